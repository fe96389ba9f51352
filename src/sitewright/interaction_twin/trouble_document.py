"""What a person must help with: reason in words, what is in the way, and what can be done."""

from __future__ import annotations

from collections.abc import Sequence

from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import DeviationSeen, RefusalMet, TargetRefused
from sitewright.central_controller.ports import verdict_of
from sitewright.central_controller.steering import hand_facts
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.report.content import Stamped

_NEEDS_PERSON = 3


def trouble_document(state: CycleState, history: Sequence[Stamped], labels: Labels) -> list[Json]:
    """Return one entry per target that is set aside, and one for what made the run stand."""
    refused = {s.event.target: s.event for s in history if isinstance(s.event, TargetRefused)}
    site = state.site
    pairs = {
        s.event.refusal.target: s.event.refusal.pair
        for s in history
        if isinstance(s.event, RefusalMet) and s.event.refusal.pair
    }
    found: list[Json] = [
        {
            **_refused(target, reason, refused.get(target), state, labels),
            "pair": list(pairs[target]) if target in pairs else None,
        }
        for target, reason in site.refused.items()
    ]
    found += [
        _entry(target, reason, "a person must put it right", (), state, labels)
        for target, reason in site.needs_rework.items()
    ]
    last = next((s.event for s in reversed(history) if isinstance(s.event, DeviationSeen)), None)
    if state.held is not None and last is not None and last.level >= _NEEDS_PERSON:
        subject = ComponentId(last.subject)
        what = f"{labels.name(subject)} {last.what}"
        found.append(_entry(subject, what, "", (subject,), state, labels))
    return found


def _refused(
    target: ComponentId,
    reason: str,
    event: TargetRefused | None,
    state: CycleState,
    labels: Labels,
) -> dict[str, Json]:
    if event is None:
        return _entry(target, reason, "", (), state, labels)
    verdict = verdict_of([labels.body(b) for b in event.blockers], is_proven=event.is_proven)
    entry = _entry(target, reason, verdict, event.blockers, state, labels)
    helps: list[Json] = [
        {"words": labels.told(c.words), "steps": c.steps, "duration_s": c.duration_s}
        for c in event.counter_proposals
    ]
    return {**entry, "counter_proposals": helps}


def _entry(
    target: ComponentId,
    reason: str,
    verdict: str,
    blockers: Sequence[str],
    state: CycleState,
    labels: Labels,
) -> dict[str, Json]:
    return {
        "target": target,
        "name": labels.name(target),
        "reason": labels.told(reason),
        "verdict": verdict,
        "pair": None,
        "blockers": list(blockers),
        "blocker_names": [labels.body(b) for b in blockers],
        "counter_proposals": [],
        "options": _options(target, state),
    }


def _options(target: ComponentId, state: CycleState) -> list[Json]:
    """Return what a person can decide now; each is checked again when it is decided."""
    found: list[Json] = []
    if state.held is not None or state.finished is not None:
        words = "Plan it again, after the cell was looked at"
        found.append({"id": "again", "verb": "resume", "words": words})
    if hand_facts(state.site).get(target):
        words = "Say which of its work was done by hand"
        found.append({"id": "by-hand", "verb": "manual", "words": words})
    found += [
        {
            "id": f"remove-{zone}",
            "verb": "zone",
            "zone": {"remove": zone},
            "words": f"Take the keep-out zone {zone} away",
        }
        for zone in state.site.zones
    ]
    return found
