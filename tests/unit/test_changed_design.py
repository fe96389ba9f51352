"""A design that changes under a chain of runs: what stands stays, what was planned dies."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from typing_extensions import override

from builders_run import KEY, Killed, Person, Site, design
from sitewright.app.run import RunOptions, fold_of, run_project
from sitewright.app.run_folder import RunFolder, chain_events, chain_of
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import (
    AnyEvent,
    DesignChanged,
    ProposalMade,
    ProposalSuperseded,
)
from sitewright.central_controller.guard import Refused, may_start
from sitewright.central_controller.ports import ApprovalAnswer, ApprovalRequest, Approve, Hold

OLD, NEW = "a" * 64, "b" * 64


class Changing(Site):
    """A site whose design has a hash that the test can change."""

    model = OLD

    @override
    def options(self, *, from_design: bool = False) -> RunOptions:
        return replace(super().options(from_design=from_design), hashes={"model": self.model})


def newest(site: Changing) -> tuple[RunFolder, ...]:
    return chain_of(RunFolder(max((site.folder / "runs").glob("0*"))))


def events_of(site: Changing) -> list[AnyEvent]:
    return list(chain_events(newest(site))[0])


def kinds(site: Changing) -> list[str]:
    return [e.kind for e in events_of(site)]


def nails(site: Changing) -> list[str]:
    return sorted(site.world().nails)


def held(_: ApprovalRequest) -> ApprovalAnswer:
    return Hold(who="tester")


def folded_again(site: Changing) -> CycleState:
    """Return what a replay of the newest chain gives."""
    return fold_of(newest(site), site.site)[0]


def test_a_held_proposal_dies_with_the_design_it_was_made_of(tmp_path: Path) -> None:
    site = Changing(tmp_path)
    site.person.script = [held]
    first = run_project(site.ports(), site.options())
    (old,) = [e for e in events_of(site) if isinstance(e, ProposalMade)]
    site.model = NEW
    result = run_project(site.ports(), site.options())
    assert (result.run, result.is_complete) == (first.run, True)
    (dead,) = [e for e in events_of(site) if isinstance(e, ProposalSuperseded)]
    assert (dead.fingerprint, dead.is_replan) == (old.fingerprint, False)
    (change,) = [e for e in events_of(site) if isinstance(e, DesignChanged)]
    assert (change.old_sha256, change.model_sha256) == (OLD, NEW)
    made = [e for e in events_of(site) if isinstance(e, ProposalMade)][1:]
    assert old.fingerprint not in {m.fingerprint for m in made}
    assert site.person.asked[1].why == "The design changed."
    assert folded_again(site).model_sha256 == NEW


def test_an_approval_of_the_old_plan_is_refused_as_stale(tmp_path: Path) -> None:
    site = Changing(tmp_path)
    site.person.script = [held]
    run_project(site.ports(), site.options())
    old = site.person.asked[0]
    site.model = NEW
    site.person.script = [lambda _: Approve(fingerprint=old.fingerprint, who="tester")]
    result = run_project(site.ports(), site.options())
    assert result.exit_code == 7
    assert "the open one is" in result.message
    assert (site.world().log, kinds(site).count("approval_refused")) == ([], 1)


def test_the_guard_lets_no_step_of_the_old_plan_start(tmp_path: Path) -> None:
    site = Changing(tmp_path)
    site.person.script = [held]
    run_project(site.ports(), site.options())
    old = site.person.asked[0].proposal
    before = folded_again(site)
    site.model = NEW
    site.person.script = [held]
    run_project(site.ports(), site.options())
    after = folded_again(site)
    seen = after.site.sensed
    assert seen is not None
    assert after.site.serial > before.site.serial
    for state in (after, replace(after, proposal=before.proposal)):
        verdict = may_start(old.steps[0], old, state, seen, key=KEY, now_utc_ns=0)
        assert isinstance(verdict, Refused)
        assert verdict.needs_plan


def test_a_finished_chain_goes_on_with_the_new_design_and_says_so(tmp_path: Path) -> None:
    site = Changing(tmp_path)
    first = run_project(site.ports(), site.options())
    site.site, site.model = design(targets=3), NEW
    second = run_project(site.ports(), site.options())
    assert second.run != first.run
    assert second.site.installed == ("stud-1", "stud-2", "stud-3")
    assert kinds(site).count("design_changed") == 1
    assert folded_again(site).model_sha256 == NEW
    again = run_project(site.ports(), site.options())
    assert (again.run, again.message) == (
        second.run,
        "Every component is installed; nothing to do.",
    )


def test_new_operations_on_an_installed_component_are_work_still_to_do(tmp_path: Path) -> None:
    site = Changing(tmp_path)
    run_project(site.ports(), site.options())
    assert len(nails(site)) == 4
    site.site, site.model = design(operations=3), NEW
    result = run_project(site.ports(), site.options())
    assert (result.is_complete, len(nails(site))) == (True, 6)
    (change,) = [e for e in events_of(site) if isinstance(e, DesignChanged)]
    assert change.reopened == ("stud-1", "stud-2")
    assert folded_again(site).site.installed == ("stud-1", "stud-2")


@pytest.mark.parametrize("die_at", range(1, 6))
def test_a_crash_while_the_change_is_told_loses_none_of_it(tmp_path: Path, die_at: int) -> None:
    site = Changing(tmp_path)
    run_project(site.ports(), site.options())
    site.site, site.model = design(operations=3), NEW
    site.controller.count, site.controller.die_at = 0, die_at
    with pytest.raises(Killed):
        run_project(site.ports(), site.options())
    site.controller.die_at = -1
    site.person = Person()
    assert run_project(site.ports(), site.options()).is_complete
    assert len(nails(site)) == 6
    assert kinds(site).count("design_changed") == 1
