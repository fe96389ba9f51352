"""What a page says of a plan that is different from the one that was approved before."""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import replace

from builders_words import LABELS, STUD, proposal
from sitewright.central_controller.events import ProposalMade
from sitewright.central_controller.fingerprint import check_code
from sitewright.central_controller.proposal import Proposal
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.languages import PHRASEBOOKS
from sitewright.interaction_twin.proposal_document import (
    ProposalSource,
    differences,
    proposal_document,
)
from sitewright.interaction_twin.proposal_story import ProposalStory

OLD, NEW = "0" * 64, "f" * 64


def rest(plan: Proposal, first: int) -> Proposal:
    """Return a plan of the steps from one on, numbered anew."""
    left = [s for s in plan.steps if s.number >= first]
    return replace(plan, steps=tuple(replace(s, number=n) for n, s in enumerate(left, start=1)))


def kinds(old: Proposal, new: Proposal, *, done: Container[int]) -> list[Json]:
    return [mapping(d)["kind"] for d in differences(old, new, LABELS, old_done=done)]


def mapping(value: Json) -> Mapping[str, Json]:
    assert isinstance(value, Mapping)
    return value


def test_steps_that_were_done_are_not_told_as_left_out() -> None:
    old = proposal()
    new = rest(old, 4)
    assert kinds(old, new, done=()) == ["removed"] * 3
    assert kinds(old, new, done={1, 2, 3}) == ["motion"], "the same steps begin elsewhere"


def test_a_chosen_step_says_that_it_stands_for_the_rest_of_the_plan() -> None:
    old = proposal()
    one = replace(old, steps=(replace(old.steps[4], number=1),))
    made = ProposalMade(fingerprint=NEW, target=STUD, site_serial=0, steps=(), is_single=True)
    for book in PHRASEBOOKS.values():
        source = ProposalSource(
            run="0001",
            fingerprint=NEW,
            proposal=one,
            story=ProposalStory(made=made, asked_at_ms=0),
            next_step=1,
            labels=LABELS,
            previous=(OLD, old),
            previous_done=frozenset({1, 2}),
            book=book,
        )
        told = proposal_document(source, is_open=True)
        words = book.page["instead"].format(code=check_code(OLD))
        assert told["differences"] == [{"kind": "target", "words": words}]
