"""Controller and cell are killed at every boundary; journal and physical log must agree."""

from __future__ import annotations

import os
import random
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from typing_extensions import override

from builders_run import A, Boundaries, Killed, Site, cell_dies, design
from sitewright.app.run import RunResult, resolve, run_project
from sitewright.app.run_folder import chain_events, chain_of, run_folders
from sitewright.central_controller.cycle import folded
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import (
    AnyEvent,
    ComponentStanding,
    OperationDone,
    SkillIntent,
    SkillOutcome,
    SkillReconciled,
)
from sitewright.central_controller.ports import Answer, Question


def wanted(site: Site) -> Counter[str]:
    return Counter(o for ops in site.site.operations.values() for o in ops)


@pytest.fixture
def folder(tmp_path: Path) -> Iterator[Path]:
    """A folder in memory where there is one: processes die here, the machine does not."""
    memory = Path("/dev/shm")  # noqa: S108 -- a fresh folder in it
    if not os.access(memory, os.W_OK):
        yield tmp_path
        return
    with tempfile.TemporaryDirectory(dir=memory) as name:
        yield Path(name)


def small(folder: Path) -> Site:
    return Site(folder, site=design(targets=1))


def events_of(site: Site) -> list[AnyEvent]:
    return list(chain_events(chain_of(run_folders(site.folder / "runs")[-1]))[0])


def check_against_physics(site: Site, result: RunResult) -> None:
    """Compare the journal with what physically happened; never with itself."""
    world, events = site.world(), events_of(site)
    assert result.is_complete, result.message
    assert Counter(world.nails) == wanted(site), "a nail is missing or was driven twice"
    assert Counter(c for c, _, _ in world.log).most_common(1)[0][1] == 1
    intended = {e.command_id for e in events if isinstance(e, SkillIntent)}
    assert {c for c, _, _ in world.log} <= intended, "something ran without an intent"
    recorded = Counter(e.operation for e in events if isinstance(e, OperationDone))
    assert recorded == wanted(site)
    assert {p.piece for p in result.site.placed.values()} == {
        what for _, skill, what in world.log if skill == "position"
    }


def looks(site: Site) -> Callable[[Question], Answer]:
    """A person who looks at the piece and tells the truth."""

    def look(question: Question) -> Answer:
        done = question.call.arguments[0] in site.world().nails
        return Answer.DONE if done else Answer.NOT_DONE

    return look


def boundaries_of_a_run(folder: Path) -> tuple[int, int]:
    site = small(folder / "count")
    run_project(site.ports(), site.options())
    return site.controller.count, site.cell_life.count


def run_with_kills(site: Site, kills: tuple[int, ...]) -> RunResult:
    """Run, dying at each given boundary of each life, until a life ends by itself."""
    for die_at in kills:
        site.controller.count, site.controller.die_at = 0, die_at
        try:
            return run_project(site.ports(), site.options())
        except Killed:
            continue
    site.controller.die_at = -1
    return run_project(site.ports(), site.options())


def test_a_controller_killed_at_any_boundary_goes_on_without_a_question(folder: Path) -> None:
    controller, _ = boundaries_of_a_run(folder)
    assert controller > 80
    for die_at in range(1, controller + 1):
        site = small(folder / str(die_at))
        result = run_with_kills(site, (die_at,))
        check_against_physics(site, result)
        assert site.person.questions == []
        assert len(site.person.asked) <= 2, "an approval that still holds was asked for again"


def test_a_controller_killed_again_and_again_goes_on_without_a_question(folder: Path) -> None:
    chosen = random.Random(7)  # noqa: S311 -- repeatable, no secret
    for number in range(30):
        site = small(folder / str(number))
        kills = tuple(chosen.randint(1, 60) for _ in range(chosen.randint(2, 6)))
        check_against_physics(site, run_with_kills(site, kills))
        assert site.person.questions == []


def test_a_controller_killed_inside_the_driver_goes_on_without_a_question(folder: Path) -> None:
    """The cell finishes what it accepted, as a process of its own does."""
    _, cell = boundaries_of_a_run(folder)
    for die_at in range(1, cell + 1, 4):  # before it is accepted; the other points are the cell's
        site = small(folder / str(die_at))
        site.cell_life.die_at = die_at
        with pytest.raises(Killed):
            run_project(site.ports(), site.options())
        site.cell_life.die_at = -1
        check_against_physics(site, run_project(site.ports(), site.options()))
        assert site.person.questions == []


def test_a_cell_killed_at_any_boundary_is_reconciled_and_only_nails_are_asked_about(
    folder: Path,
) -> None:
    _, cell = boundaries_of_a_run(folder)
    asked = 0
    for die_at in range(1, cell + 1):
        site = small(folder / str(die_at))
        site.cell_life = Boundaries(die_at=die_at, error=cell_dies)
        site.person.look = looks(site)
        check_against_physics(site, run_project(site.ports(), site.options()))
        assert {q.call.skill for q in site.person.questions} <= {"fasten"}
        asked += len(site.person.questions)
    assert asked == 2 * sum(
        wanted(small(folder)).values()
    )  # accepted but not ended: two points per nail


def test_both_killed_at_random_pairs_of_boundaries(folder: Path) -> None:
    controller, cell = boundaries_of_a_run(folder)
    chosen = random.Random(11)  # noqa: S311 -- repeatable, no secret
    for number in range(40):
        site = small(folder / str(number))
        site.cell_life = Boundaries(die_at=chosen.randint(1, cell), error=cell_dies)
        site.person.look = looks(site)
        kills = tuple(chosen.randint(1, controller) for _ in range(2))
        check_against_physics(site, run_with_kills(site, kills))


def test_a_nail_without_outcome_is_a_question_that_auto_never_answers(tmp_path: Path) -> None:
    site = Site(tmp_path)
    nail_cell_boundary(site)
    result = run_project(site.ports(), site.options())
    assert result.exit_code == 8
    question = result.question
    assert question is not None
    assert question.call.skill == "fasten"
    assert f"sitewright resolve {result.run} {question.step}" in question.text
    log = list(site.world().log)
    again = run_project(site.ports(), site.options())
    assert (again.exit_code, again.question) == (8, question)
    assert site.world().log == log, "something moved while a question was open"
    answer = looks(site)(question)
    ports = site.ports()
    resolve(
        tmp_path / "runs", site.site, result.run, question.step, answer, who="tester",
        clock=ports.clock, ids=ports.ids,
    )  # fmt: skip
    check_against_physics(site, run_project(site.ports(), site.options()))


def test_a_half_done_nail_sets_its_target_aside_for_rework(tmp_path: Path) -> None:
    site = Site(tmp_path)
    nail_cell_boundary(site)
    site.person.look = lambda _: Answer.PARTIAL
    result = run_project(site.ports(), site.options())
    assert (result.exit_code, result.site.installed) == (8, ("stud-2",))
    assert "half done" in result.refused[next(iter(result.refused))]
    assert len(site.person.questions) == 1
    again = run_project(site.ports(), site.options())
    assert again.site.installed == ("stud-2",)


def nail_cell_boundary(site: Site) -> None:
    """Let the cell die right after it accepted the first nail."""
    die_in(site, "fasten", boundary=2)


def die_in(site: Site, skill: str, *, boundary: int) -> None:
    """Let the cell die once in a skill: before 1 it accepted, 2 it acted, 3 it wrote the end."""
    first = iter([True])

    class InSkill(Boundaries):
        @override
        def cross(self) -> None:
            self.count += 1
            last = [e for e in site.events if isinstance(e, SkillIntent)][-1]
            if last.call.skill == skill and self.count % 4 == boundary and next(first, False):
                raise cell_dies()

    site.cell_life = InSkill()


@pytest.mark.parametrize(("boundary", "source"), [(2, None), (3, "sensors")])
def test_a_release_without_outcome_counts_as_done_if_the_fingers_are_seen_empty(
    tmp_path: Path, boundary: int, source: str | None
) -> None:
    site = Site(tmp_path)
    die_in(site, "release", boundary=boundary)
    check_against_physics(site, run_project(site.ports(), site.options()))
    verdicts = [e.verdict for e in events_of(site) if isinstance(e, SkillReconciled)]
    sources = [e.source for e in events_of(site) if isinstance(e, SkillOutcome)]
    assert verdicts == ([] if source else ["not-done"])
    assert ("sensors" in sources) == (source == "sensors")
    assert [e.target for e in events_of(site) if isinstance(e, ComponentStanding)] == [
        "stud-1",
        "stud-2",
    ]


def test_a_command_that_never_started_goes_out_again_under_the_same_id(tmp_path: Path) -> None:
    site = Site(tmp_path)
    site.cell_life = Boundaries(die_at=5, error=cell_dies)  # before the second command's accept
    result = run_project(site.ports(), site.options())
    check_against_physics(site, result)
    kinds = [e.kind for e in events_of(site)]
    assert kinds.count("skill_reissued") == 1
    verdicts = [e.verdict for e in events_of(site) if isinstance(e, SkillReconciled)]
    assert verdicts == ["never"]
    assert len(site.person.asked) == 2, "the approval still held"


@pytest.mark.parametrize(("boundary", "place"), [(10, "piece-1"), (11, None)])
def test_a_robot_that_was_stopped_keeps_its_place_only_if_it_never_moved(
    tmp_path: Path, boundary: int, place: str | None
) -> None:
    """The third command is a reach; the cell dies before or after the robot moved."""
    site = Site(tmp_path)
    site.cell_life = Boundaries(die_at=boundary, error=cell_dies)
    check_against_physics(site, run_project(site.ports(), site.options()))
    state = CycleState(site=site.site)
    for event in events_of(site):
        state = folded(state, event)
        if isinstance(event, SkillReconciled):
            assert state.site.place_by_robot.get(A) == place
            return
    pytest.fail("the reach was not reconciled")


def test_an_expired_approval_is_not_reissued_but_asked_for(tmp_path: Path) -> None:
    site = Site(tmp_path)
    site.cell_life.die_at = 1
    with pytest.raises(Killed):
        run_project(site.ports(), site.options())
    site.cell_life.die_at = -1
    site.clock.now_ns += 700_000_000_000
    result = run_project(site.ports(), site.options())
    check_against_physics(site, result)
    assert len(site.person.asked) == 3


def test_a_real_kill_of_the_process_loses_and_repeats_nothing(tmp_path: Path) -> None:
    chosen = random.Random(3)  # noqa: S311 -- repeatable, no secret
    for number in range(6):
        site = Site(tmp_path / str(number))
        for _ in range(2):
            die_at = chosen.randint(1, 150)
            child = os.fork()
            if child == 0:  # pragma: no cover -- another process
                site.controller = Boundaries(die_at=die_at, error=_exit_now)
                try:
                    run_project(site.ports(), site.options())
                finally:
                    os._exit(1)
            os.waitpid(child, 0)
            site.lives += 1
        check_against_physics(site, run_project(site.ports(), site.options()))
        assert site.person.questions == []


def _exit_now() -> BaseException:
    os._exit(9)
