"""Each step of a real plan says why it is there."""

from __future__ import annotations

import pytest

from builders_planning import SUPPORT_1, Rehearsal
from sitewright.interaction_twin.because import reasons
from sitewright.interaction_twin.labels import labels_of
from sitewright.interaction_twin.languages import PHRASEBOOKS


def test_each_step_says_why_it_is_there(frame: Rehearsal) -> None:
    design = frame.proposals.design
    steps = frame.planned[SUPPORT_1].proposal.steps
    told = reasons(steps, labels_of(design.model, design.cell))
    by_skill = {s.call.skill: t for s, t in zip(steps, told, strict=True)}
    assert all(t.startswith("because ") for t in told)
    assert "the design asks for" in by_skill["position"]
    assert "Supporting stud 1" in by_skill["position"]
    grasp = next(n for n, s in enumerate(steps) if s.call.skill == "reach")
    assert told[grasp].startswith(f"because of step {steps[grasp].number + 1}: ")


@pytest.mark.parametrize("language", PHRASEBOOKS)
def test_no_clause_of_any_language_is_english_or_an_id(frame: Rehearsal, language: str) -> None:
    design = frame.proposals.design
    steps = frame.planned[SUPPORT_1].proposal.steps
    told = reasons(steps, labels_of(design.model, design.cell), PHRASEBOOKS[language])
    assert len(told) == len(steps)
    assert all(told)
    assert all("(" not in t for t in told)
    if language != "en":
        assert not any("because" in t for t in told)
