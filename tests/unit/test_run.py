"""The runner over its ports: a building goes up, whatever fails on the way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest
from typing_extensions import override

from builders_run import A, B, Person, Site, World, design, moved
from sitewright.app.installing import installed_times
from sitewright.app.locks import LockedError, locked
from sitewright.app.run import resolve, run_project
from sitewright.app.run_folder import RunFolder, chain_events, chain_of, run_folders
from sitewright.app.runner import RunPorts
from sitewright.central_controller.events import (
    AnyEvent,
    ComponentInstalled,
    DeviationSeen,
    ProposalSuperseded,
    SkillIntent,
)
from sitewright.central_controller.ports import (
    Answer,
    ApprovalAnswer,
    ApprovalRequest,
    Approve,
    DoInstead,
    Escalation,
    FactsChanged,
    Hold,
    ProposalOutcome,
    Reject,
    Scope,
    ScopeKind,
    SiteContext,
)
from sitewright.errors import ExecutionError
from sitewright.foundation.ids import ComponentId
from sitewright.journal.errors import JournalCorruptError
from sitewright.planning_twin.refusal import NotClear, StaleCertificate


def events_of(site: Site) -> list[AnyEvent]:
    folder = run_folders(site.folder / "runs")[-1]
    return list(chain_events(chain_of(folder))[0])


def times(folder: Path) -> dict[str, str]:
    return dict(line.split() for line in (folder / "as_built.json").read_text().splitlines())


def kinds(site: Site) -> list[str]:
    return [e.kind for e in events_of(site)]


def nails(site: Site) -> list[str]:
    return sorted(site.world().nails)


ALL_NAILS = sorted(o for ops in design().operations.values() for o in ops)


def test_a_building_goes_up_and_every_effect_happens_once(tmp_path: Path) -> None:
    site = Site(tmp_path)
    result = run_project(site.ports(), site.options())
    assert (result.exit_code, result.is_complete) == (0, True), result.message
    assert nails(site) == ALL_NAILS
    assert result.site.installed == ("stud-1", "stud-2")
    written = times(result.folder)
    assert list(written) == ["stud-1", "stud-2"]
    assert all(datetime.fromisoformat(at).tzinfo == UTC for at in written.values())
    assert sorted(p.name for p in (result.folder / "pddl").iterdir()) == [
        "stud-1-1.plan",
        "stud-1-1.problem",
        "stud-2-1.plan",
        "stud-2-1.problem",
    ]
    assert site.events == events_of(site)
    assert len(site.person.asked) == 2
    assert kinds(site).count("skill_intent") == len(site.world().log)


def test_a_finished_project_has_nothing_to_do(tmp_path: Path) -> None:
    site = Site(tmp_path)
    first = run_project(site.ports(), site.options())
    again = run_project(site.ports(), site.options())
    assert (again.exit_code, again.run) == (0, first.run)
    assert "nothing to do" in again.message
    assert len(run_folders(tmp_path / "runs")) == 1


def test_from_design_starts_on_an_empty_site(tmp_path: Path) -> None:
    site = Site(tmp_path)
    run_project(site.ports(), site.options())
    again = run_project(site.ports(), site.options(from_design=True))
    assert again.run.startswith("0002-")
    assert again.is_complete
    assert len(site.world(again.run).nails) == 4


def test_a_new_target_in_the_design_continues_the_newest_run(tmp_path: Path) -> None:
    site = Site(tmp_path)
    first = run_project(site.ports(), site.options())
    site.site = design(targets=3)
    second = run_project(site.ports(), site.options())
    assert second.run != first.run
    assert second.site.installed == ("stud-1", "stud-2", "stud-3")
    assert len(nails(site)) == 6
    assert times(first.folder).items() < times(second.folder).items()
    assert times(second.folder) == installed_times(chain_of(RunFolder(second.folder)))


def test_a_previous_run_that_was_cut_is_noticed(tmp_path: Path) -> None:
    site = Site(tmp_path)
    first = run_project(site.ports(), site.options())
    site.site = design(targets=3)
    run_project(site.ports(), site.options())
    other = Site(tmp_path / "other")
    swapped = run_project(other.ports(), other.options())
    (swapped.folder / "journal.db").replace(first.folder / "journal.db")
    with pytest.raises(JournalCorruptError, match="was changed after"):
        run_project(site.ports(), site.options())


def test_step_mode_asks_before_each_step(tmp_path: Path) -> None:
    site = Site(tmp_path, site=design(targets=1))

    class StepByStep(Person):
        @override
        def ask(self, request: ApprovalRequest) -> ApprovalAnswer:
            self.scope = Scope(ScopeKind.STEP, request.next_step)
            return super().ask(request)

    site.person = StepByStep()
    assert run_project(site.ports(), site.options()).is_complete
    steps = len(site.person.asked[0].proposal.steps)
    assert [r.next_step for r in site.person.asked] == list(range(1, steps + 1))


def test_another_feasible_action_runs_as_a_proposal_of_one_step(tmp_path: Path) -> None:
    site = Site(tmp_path, site=design(targets=1))

    def other(request: ApprovalRequest) -> ApprovalAnswer:
        return DoInstead(who="tester", call=request.alternatives()[0].call)

    site.person.script = [other]
    assert run_project(site.ports(), site.options()).is_complete
    assert [r.is_single for r in site.person.asked] == [False, True, False]
    assert site.world().log[0][1] == "reach"
    assert nails(site) == ALL_NAILS[:2]


def test_a_rejected_plan_is_not_proposed_again_for_ever(tmp_path: Path) -> None:
    site = Site(tmp_path, site=design(targets=1))
    site.person.script = [lambda _: Reject(who="tester", reason="path-unsafe", detail="too near")]
    result = run_project(site.ports(), site.options())
    assert (result.exit_code, site.world().log) == (7, [])
    assert result.site.rejections[0].detail == "too near"
    (reason,) = result.site.refused.values()
    assert reason == "stud-1: its plan was rejected, and no other one was found."
    assert run_project(site.ports(), site.options()).is_complete  # the same plan, asked for again


def test_a_target_whose_plan_was_rejected_does_not_keep_the_others_waiting(tmp_path: Path) -> None:
    site = Site(tmp_path, site=design(targets=2))
    site.person.script = [lambda _: Reject(who="tester", reason="path-unsafe")]
    result = run_project(site.ports(), site.options())
    assert (result.exit_code, result.site.installed) == (6, ("stud-2",))


def test_a_target_put_off_is_left_out_of_this_run(tmp_path: Path) -> None:
    site = Site(tmp_path)
    site.person.script = [lambda _: Reject(who="tester", reason="later")]
    result = run_project(site.ports(), site.options())
    assert (result.exit_code, result.site.installed) == (6, ("stud-2",))
    assert run_project(site.ports(), site.options()).is_complete


def test_hold_leaves_the_run_open_and_the_next_command_goes_on(tmp_path: Path) -> None:
    site = Site(tmp_path)
    site.person.script = [lambda _: Hold(who="tester", reason="lunch")]
    held = run_project(site.ports(), site.options())
    assert (held.exit_code, held.message) == (7, "tester holds the run: lunch")
    again = run_project(site.ports(), site.options())
    assert (again.run, again.is_complete) == (held.run, True)


def test_an_answer_about_another_plan_starts_nothing(tmp_path: Path) -> None:
    site = Site(tmp_path)
    site.person.script = [lambda _: Approve(fingerprint="f" * 64, who="tester")]
    result = run_project(site.ports(), site.options())
    assert (result.exit_code, site.world().log) == (7, [])
    assert "skill_intent" not in kinds(site)


def test_an_approval_that_waits_too_long_is_asked_for_again(tmp_path: Path) -> None:
    site = Site(tmp_path)
    jump_ns = iter([700_000_000_000])

    def on_event(event: AnyEvent) -> None:
        if event.kind == "approval_given":
            site.clock.now_ns += next(jump_ns, 0)

    assert run_project(replace(site.ports(), on_event=on_event), site.options()).is_complete
    whys = [r.why for r in site.person.asked]
    assert whys == ["", "This approval was not started within 10 min. Approve again.", ""]


@pytest.mark.parametrize("skill", ["grasp", "position", "fasten", "release", "reach"])
def test_a_skill_that_fails_leads_to_a_new_plan(tmp_path: Path, skill: str) -> None:
    site = Site(tmp_path, fail={skill: "missed"})
    result = run_project(site.ports(), site.options())
    assert result.is_complete, result.message
    assert nails(site) == ALL_NAILS
    assert kinds(site).count("proposal_superseded") == 1
    assert len(site.person.asked) == 3  # a new plan needs a new approval


def test_a_skill_that_always_fails_ends_in_a_hold(tmp_path: Path) -> None:
    site = Site(tmp_path)

    class Always(dict[str, str]):
        @override
        def pop(self, key: str, default: object = "") -> str:
            return "grasp-failed" if key == "grasp" else ""

    site.fail = Always()
    result = run_project(site.ports(), site.options())
    assert (result.exit_code, result.is_complete) == (8, False)
    assert "planned anew 4 times" in result.message
    site.fail = {}
    assert run_project(site.ports(), site.options()).is_complete


def when(site: Site, kind: str, change: Callable[[World], None]) -> RunPorts:
    """Change the world once, right after an event of a kind."""
    ports, first = site.ports(), iter([True])

    def on_event(event: AnyEvent) -> None:
        site.events.append(event)
        if event.kind == kind and next(first, False):
            site.change_world(change)

    return replace(ports, on_event=on_event)


def test_a_piece_moved_before_it_is_picked_leads_to_a_new_plan(tmp_path: Path) -> None:
    site = Site(tmp_path)

    def nudge(world: World) -> None:
        world.pieces["piece-1"] = moved(world.pieces["piece-1"], 0.05)

    result = run_project(when(site, "approval_given", nudge), site.options())
    assert result.is_complete
    assert kinds(site).count("deviation_seen") == 1
    assert result.site.serial == 1
    assert len({r.fingerprint for r in site.person.asked}) == 3


def test_a_small_shift_is_no_deviation(tmp_path: Path) -> None:
    site = Site(tmp_path)

    def nudge(world: World) -> None:
        world.pieces["piece-4"] = moved(world.pieces["piece-4"], 0.0015)

    assert run_project(when(site, "approval_given", nudge), site.options()).is_complete
    assert "deviation_seen" not in kinds(site)


def test_a_piece_that_lies_about_may_roll_on_without_a_new_plan(tmp_path: Path) -> None:
    site = Site(tmp_path)
    site.check.lying_about = frozenset({ComponentId("piece-4")})

    def roll(world: World) -> None:
        world.pieces["piece-4"] = moved(world.pieces["piece-4"], 0.05)

    result = run_project(when(site, "skill_intent", roll), site.options())
    assert result.is_complete
    assert "deviation_seen" not in kinds(site)
    assert result.site.sensed is not None
    seen = result.site.sensed.world_T_piece[ComponentId("piece-4")]
    assert seen == site.world().pieces["piece-4"], "where it is now is recorded"


def test_a_piece_dropped_on_the_way_is_noticed_and_another_plan_made(tmp_path: Path) -> None:
    site = Site(tmp_path)

    def drop(world: World) -> None:
        if world.gripped[A]:
            world.pieces[world.gripped[A] or ""] = moved(world.pieces["piece-2"], 0.3)
            world.gripped[A] = None

    intents: list[str] = []

    def on_event(event: AnyEvent) -> None:
        if isinstance(event, SkillIntent):
            intents.append(event.call.skill)
            if intents[-2:] == ["grasp", "reach"] and len(intents) < 5:
                site.change_world(drop)

    result = run_project(replace(site.ports(), on_event=on_event), site.options())
    assert result.is_complete
    seen = [e for e in events_of(site) if isinstance(e, DeviationSeen)]
    assert any("not in the gripper" in e.what for e in seen)


def test_an_installed_piece_that_moves_far_stops_the_run_for_a_person(tmp_path: Path) -> None:
    site = Site(tmp_path)

    def bump(world: World) -> None:
        installed = site.events[-1]
        assert isinstance(installed, ComponentInstalled)
        world.pieces[installed.piece] = moved(world.pieces[installed.piece], 0.04)

    result = run_project(when(site, "component_installed", bump), site.options())
    assert (result.exit_code, result.is_complete) == (8, False)
    assert "after it was installed" in result.message


def test_a_motion_that_is_not_clear_any_more_is_planned_anew(tmp_path: Path) -> None:
    site = Site(tmp_path)
    cause = NotClear(pair=("a", "b"), q_rad=(0.0,), distance_m=0.0, threshold_m=0.01, segment=0)
    site.check.refuse_once = StaleCertificate(cause=cause)
    assert run_project(site.ports(), site.options()).is_complete
    assert kinds(site).count("proposal_superseded") == 1


def test_a_fact_that_does_not_hold_any_more_is_planned_anew(tmp_path: Path) -> None:
    site = Site(tmp_path)
    site.check.refuse_once = FactsChanged(("(accessible piece-1)",))
    assert run_project(site.ports(), site.options()).is_complete
    texts = [e.reason for e in events_of(site) if isinstance(e, ProposalSuperseded)]
    assert texts == ["Step 1 relies on what is not so: (accessible piece-1)."]


def test_a_target_that_cannot_be_planned_is_named_and_the_others_are_built(tmp_path: Path) -> None:
    site = Site(tmp_path)
    propose = site.planner.propose

    def without_first(
        context: SiteContext, *, exclude: frozenset[ComponentId] = frozenset()
    ) -> ProposalOutcome:
        first = ComponentId("stud-1")
        if first not in exclude:
            return Escalation(target=first, reason="out of reach", is_proven=True, exit_code=4)
        return propose(context, exclude=exclude)

    site.planner.propose = without_first  # type: ignore[method-assign]
    result = run_project(site.ports(), site.options())
    assert (result.exit_code, result.site.installed) == (6, ("stud-2",))
    assert result.refused == {"stud-1": "out of reach"}


def test_two_runs_at_once_are_refused(tmp_path: Path) -> None:
    site = Site(tmp_path)
    with locked(tmp_path / "cell.lock", "The cell"), pytest.raises(LockedError) as error:
        run_project(site.ports(), site.options())
    assert error.value.exit_code == 9
    with locked(tmp_path / "runs" / "lock", "The project"), pytest.raises(LockedError):
        run_project(site.ports(), site.options())


def test_a_question_that_is_not_open_cannot_be_answered(tmp_path: Path) -> None:
    site = Site(tmp_path)
    result = run_project(site.ports(), site.options())
    ports = site.ports()
    with pytest.raises(ExecutionError, match="no open question"):
        resolve(
            tmp_path / "runs", site.site, result.run, 3, Answer.DONE, who="x",
            clock=ports.clock, ids=ports.ids,
        )  # fmt: skip
    with pytest.raises(ExecutionError, match="There is no run"):
        resolve(
            tmp_path / "runs", site.site, "9999", 3, Answer.DONE, who="x",
            clock=ports.clock, ids=ports.ids,
        )  # fmt: skip


def test_a_full_disk_starts_nothing(tmp_path: Path) -> None:
    site = Site(tmp_path)
    result = run_project(replace(site.ports(), min_free_bytes=1 << 62), site.options())
    assert (result.exit_code, site.world().log) == (8, [])
    assert run_project(site.ports(), site.options()).is_complete


def test_a_proposal_that_was_edited_on_disk_is_refused(tmp_path: Path) -> None:
    site = Site(tmp_path)
    run_project(site.ports(), site.options())
    folder = RunFolder(run_folders(tmp_path / "runs")[-1].path)
    path = next((folder.path / "proposals").iterdir())
    digest = path.stem
    assert folder.load_proposal(digest).steps
    path.write_text(path.read_text().replace("stud-", "beam-", 1))
    with pytest.raises(JournalCorruptError, match="changed"):
        folder.load_proposal(digest)
    path.write_text("{")
    with pytest.raises(JournalCorruptError, match="cannot be read"):
        folder.load_proposal(digest)


def test_the_robots_end_where_they_began(tmp_path: Path) -> None:
    site = Site(tmp_path)
    result = run_project(site.ports(), site.options())
    assert site.world().q_rad == {A: 0.0, B: 0.0}
    assert result.site.place_by_robot == {A: None, B: None}
