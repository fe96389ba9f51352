"""A target is proven impossible only by what is proven, whatever else was refused besides."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import pytest

from builders_held import frame_of_one_stud
from builders_planning import A, B
from sitewright.app.engines import proposals_of
from sitewright.app.planning import start_of
from sitewright.central_controller.measuring import Stopwatch
from sitewright.central_controller.surveying import Situation
from sitewright.central_controller.target_outcome import TargetRefusal
from sitewright.central_controller.target_planning import PlanningPorts, plan_target
from sitewright.foundation.ids import ComponentId
from sitewright.planning_twin.refusal import NoGrasp, NoIk
from sitewright.planning_twin.study import StudyRefusal
from sitewright.symbolic_planning.domain import Fact
from sitewright.symbolic_planning.nogood import Change, Nogood

STUD = ComponentId("stud-1")


@dataclass(frozen=True, slots=True)
class Site:
    """A stud that could be built as it is, and all that is known of it."""

    ports: PlanningPorts
    found: Situation
    watch: Stopwatch
    piece: ComponentId

    def taken(self) -> Fact:
        """That robot A takes the piece: nothing is built without it."""
        return ("can-grasp", A, "gripper-s", self.piece)

    def refused(
        self, facts: Iterable[tuple[Fact, bool]], *, blocked: tuple[str, ...] = ()
    ) -> TargetRefusal:
        """Plan without some facts, proven or not; robot B is kept from fasteners meanwhile.

        Buffers are left aside: that a piece might be passed on is a law of its own.
        """
        study = self.found.study
        refusals = tuple(_no(fact, is_proven=is_proven) for fact, is_proven in facts)
        excludes = frozenset((B, place, STUD) for place in blocked)
        base = replace(study.base, excludes=study.base.excludes | excludes)
        study = replace(study, base=base, refusals=refusals, passable=frozenset())
        outcome = plan_target(self.ports, self.found.twin, study, self.found.view, self.watch)
        assert isinstance(outcome, TargetRefusal)
        return outcome


def _no(fact: Fact, *, is_proven: bool) -> StudyRefusal:
    refusal = (
        NoIk(is_proven=is_proven)
        if fact[0] == "can-reach"
        else NoGrasp(is_proven=is_proven, candidates=1)
    )
    nogood = Nogood(
        fact=fact, change=Change.REMOVED, is_proven=is_proven, evidence=" ".join(fact), scope=""
    )
    return StudyRefusal(nogood=nogood, refusal=refusal)


@pytest.fixture(scope="module")
def site() -> Site:
    """Frame 16, whose stud robot A holds while B drives both nails."""
    project = frame_of_one_stud(16)
    proposals, start = proposals_of(project), start_of(project)
    watch = Stopwatch(clock=proposals.ports.clock)
    piece = project.model.stacks[0].items[-1]
    graph = proposals.graph_of(start)
    found = proposals.surveyor.situation(graph, start, STUD, (piece,), watch)
    assert found.study.holdings
    return Site(proposals.ports, found, watch, piece)


def test_what_was_not_proven_proves_nothing(site: Site) -> None:
    assert site.refused([(site.taken(), True)]).is_proven
    assert not site.refused([(site.taken(), False)]).is_proven


def test_what_is_proven_suffices_whatever_else_was_refused(site: Site) -> None:
    nail: Fact = ("can-reach", B, f"{STUD}.nail-1")
    assert site.refused([(nail, True), (site.taken(), False)]).is_proven
    assert site.refused([(nail, False), (site.taken(), True)]).is_proven
    assert not site.refused([(nail, False), (site.taken(), False)]).is_proven


def test_a_proof_about_something_else_does_not_lend_its_certainty(site: Site) -> None:
    """A station that nobody needs is proven out of reach; what matters was only not found."""
    needless: Fact = ("can-reach", B, "tools-b")
    assert not site.refused([(needless, True), (site.taken(), False)]).is_proven


def test_robots_that_are_in_each_others_way_prove_nothing(site: Site) -> None:
    """Who is in whose way was found by collisions: who waits, or what lies there, may move."""
    nails = (f"{STUD}.nail-1", f"{STUD}.nail-2")
    assert not site.refused([], blocked=nails).is_proven
    needless: Fact = ("can-reach", B, "tools-b")
    assert not site.refused([(needless, True)], blocked=nails).is_proven
    assert site.refused([(site.taken(), True)], blocked=nails).is_proven
