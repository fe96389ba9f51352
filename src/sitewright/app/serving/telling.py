"""Answers of the run in words, for the page."""

from __future__ import annotations

from collections.abc import Mapping

from sitewright.central_controller.ports import Alternative
from sitewright.central_controller.site_state import SiteState
from sitewright.central_controller.steering import hand_facts
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.sentence import Sentence, parts_of, sentence_of
from sitewright.interaction_twin.decisions import Reply
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.narration import narrate
from sitewright.interaction_twin.phrases import Phrasebook
from sitewright.interaction_twin.retelling import retold
from sitewright.robot_team.skill import SkillCall


def ways_reply(
    fingerprint: str, body: Mapping[str, Json], labels: Labels, book: Phrasebook
) -> Reply:
    """Return the other actions in words: those that are possible, and why the others are not."""
    ways = body["ways"]
    assert isinstance(ways, list)  # noqa: S101 -- our own process
    feasible = [_told(w, labels, book) for w in ways if w["is_feasible"]]
    infeasible = [_told(w, labels, book) for w in ways if not w["is_feasible"]]
    found: dict[str, Json] = {
        "fingerprint": fingerprint,
        "step": body["step"],
        "feasible": feasible,
        "infeasible": infeasible,
    }
    return Reply(status=200, body=found)


def _told(way: Mapping[str, Json], labels: Labels, book: Phrasebook) -> Json:
    call = way["call"]
    assert isinstance(call, Mapping)  # noqa: S101 -- our own process
    arguments = call["arguments"]
    assert isinstance(arguments, list)  # noqa: S101
    skill_call = SkillCall(str(call["skill"]), RobotId(str(call["robot"])), tuple(arguments))
    words = narrate(skill_call, labels, book)
    facts = {**call, "words": words, "duration_s": way["duration_s"]}
    if way["is_feasible"]:
        return {**facts, "price_s": way["price_s"], "note": retold(_note(way), labels, book)}
    return {**facts, "why_not": retold(_note(way) or Sentence("It leads nowhere."), labels, book)}


def _note(way: Mapping[str, Json]) -> str:
    """Return a note as the sentence that it was, if it was one."""
    parts = way.get("note_told")
    return str(way["note"]) if parts is None else sentence_of(parts)


def by_hand_document(
    target: str, site: SiteState, labels: Labels, book: Phrasebook
) -> Mapping[str, Json] | None:
    """Return the checklist of what a person can vouch for at a target; None if there is none."""
    facts = hand_facts(site).get(ComponentId(target))
    if facts is None:
        return None
    return {
        "target": target,
        "name": labels.name(target),
        "effects": [{"fact": f, "words": _in_words(f, labels, book)} for f in facts],
    }


def _in_words(fact: str, labels: Labels, book: Phrasebook) -> str:
    name, subject = fact.strip("()").split()
    if name == "standing":
        return retold(Sentence("{target} stands by itself", target=subject), labels, book)
    return retold(Sentence("{operation} is done", operation=subject), labels, book)


def way_document(way: Alternative) -> Json:
    """Return another action as the run tells it to the server."""
    return {
        "call": {
            "skill": way.call.skill,
            "robot": way.call.robot,
            "arguments": list(way.call.arguments),
        },
        "duration_s": way.duration_s,
        "price_s": way.price_s,
        "is_feasible": not way.leads_nowhere,
        "note": way.note,
        "note_told": parts_of(way.note) if isinstance(way.note, Sentence) else None,
    }


def retold_reply(reply: Reply, labels: Labels, book: Phrasebook) -> Reply:
    """Return an answer with its message in a language."""
    parts = reply.body.get("message~")
    if parts is None:
        return reply
    body = {k: v for k, v in reply.body.items() if k != "message~"}
    return Reply(
        status=reply.status, body={**body, "message": retold(sentence_of(parts), labels, book)}
    )
