"""A refusal says how sure it is: proven, blocked by something, or not found."""

from __future__ import annotations

import pytest

from sitewright.central_controller.ports import PUT_OFF, Escalation, RefusalNote
from sitewright.foundation.ids import ComponentId

TARGET = ComponentId("stud-1")


@pytest.mark.parametrize(
    ("kind", "is_proven", "blockers", "verdict"),
    [
        ("NoIk", True, (), "proven impossible"),
        ("PayloadExceeded", True, (), "proven impossible"),
        ("NoIk", False, (), "not found within budget"),
        ("NoPath", False, (), "not found within budget"),
        ("NoGrasp", False, (), "not found within budget"),
        ("BlockedBy", False, ("thin.1",), "blocked by thin.1"),
        ("NotClear", False, ("thin.1", "kr120-b"), "blocked by thin.1 and kr120-b"),
        (PUT_OFF, False, (), "a person's wish"),
    ],
)
def test_a_note_says_one_of_three_things_unless_a_person_put_the_target_off(
    kind: str, blockers: tuple[str, ...], verdict: str, *, is_proven: bool
) -> None:
    note = RefusalNote(
        target=TARGET, kind=kind, reason="no", is_proven=is_proven, blockers=blockers
    )
    assert note.verdict == verdict


def test_a_proof_says_more_than_what_is_in_the_way() -> None:
    refused = Escalation(target=TARGET, reason="no", is_proven=True, blockers=("thin.1",))
    assert refused.verdict == "proven impossible"
