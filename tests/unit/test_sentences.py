"""What planners and controller say can be said in every language, and no id is left in it."""

from __future__ import annotations

import ast
import copy
import pickle
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import sitewright
from sitewright.central_controller.codec import from_json, to_json
from sitewright.central_controller.events import (
    RefusalMet,
    TargetRefused,
    event_from_json,
    event_to_json,
)
from sitewright.central_controller.outcomes import WITH_HELPS
from sitewright.central_controller.ports import RefusalNote
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.sentence import JOINTS, Sentence, parts_of, sentence_of
from sitewright.interaction_twin.decisions import DECIDED, DECIDED_OTHERWISE
from sitewright.interaction_twin.labels import DRAWN_ZONE, Kind, Label, Labels
from sitewright.interaction_twin.languages import PHRASEBOOKS
from sitewright.interaction_twin.phrases import Phrasebook
from sitewright.interaction_twin.retelling import retold
from sitewright.planning_twin.feedback import sentence
from sitewright.planning_twin.refusal import (
    BlockedBy,
    Disagreement,
    NoGrasp,
    NoIk,
    NoPath,
    NotClear,
    PayloadExceeded,
    Refusal,
    WorkerFailed,
)
from sitewright.robot_team.skill import Skill, SkillCall

SOURCES = Path(sitewright.__file__).parent
OTHERS = [book for book in PHRASEBOOKS.values() if book.language != "en"]
LABELS = Labels(
    label_by_id={
        "arm-7": Label(Kind.ROBOT, "North arm"),
        "stud-1": Label(Kind.COMPONENT, "Left stud"),
        "thin.1": Label(Kind.PIECE, "Thin board"),
        "pallet-2": Label(Kind.STOCK_PLACE, "Second pallet"),
        "stud-1.nail-1": Label(Kind.OPERATION, "nail 1", of="stud-1", process="nail"),
    }
)
IDS = re.compile(r"arm-7|stud-1|thin\.1|pallet-2|nail-1|link_3|keep-out-4|[{}]")
PAIR = ("arm-7/link_3", "thin.1")


@cache
def templates() -> frozenset[str]:
    """Return every template that the sources make sentences of."""
    return frozenset(_templates())


def _templates() -> Iterator[str]:
    for file in SOURCES.rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            match node:
                case ast.Call(func=ast.Name(id="Sentence"), args=[ast.Constant(value=str(text))]):
                    yield text
                case _:
                    pass
    yield from (WITH_HELPS, DRAWN_ZONE, DECIDED_OTHERWISE, *DECIDED.values(), *JOINTS.values())


def places(template: str) -> set[str]:
    return set(re.findall(r"\{([^}]+)\}", template))


@pytest.mark.parametrize("book", OTHERS, ids=lambda book: book.language)
def test_every_sentence_is_there_in_every_language_with_the_same_places(book: Phrasebook) -> None:
    known = book.told
    made = templates()
    assert sorted(made - set(known)) == []
    # the class of a refusal is for those who read English; an operation is said with its component
    may_leave_out = {"kind", "target"}
    assert {t for t in made if places(known[t]) - places(t)} == set()
    assert {t for t in made if places(t) - places(known[t]) - may_leave_out} == set()


def test_no_language_keeps_what_nobody_says() -> None:
    english = {*templates(), *PHRASEBOOKS["en"].told}
    words = {k for book in OTHERS for k in book.told if k not in english}
    skills = {str(s) for s in Skill}
    assert words - skills == {"nail", "screw", "paint", "drill", "never", "not-done", "unknown"}


REFUSALS: list[Refusal] = [
    NoIk(is_proven=True, extension_m=0.04),
    NoIk(is_proven=False, reason=Sentence("no posture serves what follows")),
    BlockedBy(pairs=(PAIR, ("keep-out-4", "stud-1"))),
    BlockedBy(pairs=(PAIR,), reason=Sentence("{things:and} is in its place", things=("thin.1",))),
    NoPath(nodes=500, seeds=(1,)),
    NotClear(pair=PAIR, q_rad=(), distance_m=0.0072, threshold_m=0.01, segment=0),
    Disagreement(pair=PAIR, q_rad=(), distance_m=0.003, threshold_m=0.01),
    NoGrasp(is_proven=False, candidates=3, reason=Sentence("no grasp of {piece}", piece="thin.1")),
    PayloadExceeded(mass_kg=130.0, payload_kg=120.0),
    WorkerFailed(task="stud-1", exit_status=9),
]
SKILLS = (Skill.GRASP, Skill.POSITION, Skill.SET_DOWN, Skill.RETRACT, Skill.RELEASE, Skill.REACH)


@pytest.mark.parametrize("book", PHRASEBOOKS.values(), ids=lambda book: book.language)
@pytest.mark.parametrize("refusal", REFUSALS, ids=lambda r: type(r).__name__)
def test_no_refusal_shows_an_id_in_any_language(refusal: Refusal, book: Phrasebook) -> None:
    for skill in SKILLS:
        act = SkillCall(skill, RobotId("arm-7"), ("thin.1", "stud-1.nail-1"))
        said = sentence(act, "pallet-2", ComponentId("thin.1"), refusal)
        told = retold(said, LABELS, book)
        assert "North arm" in told
        assert IDS.search(told) is None, told


def test_each_language_says_it_in_its_own_way() -> None:
    said = Sentence("{a} and {b} come to {gap_mm:.1f} mm, allowed {least_mm:.1f} mm",
                    a="thin.1", b="stud-1.nail-1", gap_mm=7.25, least_mm=10.0)  # fmt: skip
    told = {language: retold(said, LABELS, book) for language, book in PHRASEBOOKS.items()}
    assert told["en"] == "Thin board and nail 1 of Left stud come to 7.2 mm, allowed 10.0 mm"
    assert told["de"].startswith("Thin board und Nagel 1 von Left stud kommen sich bis auf 7,2 mm")
    assert "7,2 mm" in told["es"]
    assert "7.2 毫米" in told["zh"]


def test_a_sentence_is_plain_text_for_everybody_else() -> None:
    why = Sentence("take {things:and} out of the way", things=("a", "b"))
    said = Sentence("{what}: {why}", what="stud-1", why=why)
    assert said == "stud-1: take a and b out of the way"
    for again in (
        copy.deepcopy(said),
        pickle.loads(pickle.dumps(said)),  # noqa: S301 -- our own
        sentence_of(parts_of(said)),
    ):
        assert again == said
        assert again.template == said.template
        assert isinstance(again.places["why"], Sentence)
    with pytest.raises(KeyError):
        Sentence("{nobody}")
    with pytest.raises(ValueError, match="cannot be filled"):
        sentence_of({"template": "{a.__class__}", "places": {"a": 1}})


def test_the_journal_keeps_the_text_and_what_it_is_made_of() -> None:
    reason = Sentence("{target}: {why}", target="stud-1", why=Sentence("nothing was tried"))
    event = TargetRefused(target=ComponentId("stud-1"), reason=reason, is_proven=False, exit_code=6)
    stored = event_to_json(event)
    assert isinstance(stored, dict)
    assert stored["reason"] == "stud-1: nothing was tried"
    again = event_from_json(event.kind, event.version, stored)
    assert isinstance(again, TargetRefused)
    assert retold(again.reason, LABELS, PHRASEBOOKS["de"]) == "Left stud: nichts wurde versucht"
    note = RefusalNote(target=ComponentId("stud-1"), kind="NoIk", reason=reason, is_proven=True)
    met = RefusalMet(refusal=note)
    kept = from_json(RefusalMet, to_json(met)).refusal.reason
    assert isinstance(kept, Sentence)
    assert kept.template == "{target}: {why}"


def test_a_text_of_before_stays_english_with_names() -> None:
    assert retold("thin.1 is gone", LABELS, PHRASEBOOKS["de"]) == "Thin board is gone"
    assert retold("", LABELS, PHRASEBOOKS["zh"]) == ""
