"""Things go wrong in a real run: in the physics, on the disk, with the planner, with the user.

Each ends in a new plan or in a clear word with its exit code; files stay whole, and the same
command, given again, goes on.
"""

from __future__ import annotations

import json
import os
import resource
import shutil
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

from builders_site import (
    NAILS_PER_STUD,
    Ended,
    RealSite,
    check_journal_against_physics,
    real_site,
    until,
)
from sitewright.app.run_folder import run_folders
from sitewright.central_controller.events import (
    ApprovalGiven,
    ComponentPositioned,
    DeviationSeen,
    LinkLost,
    ProposalMade,
    ProposalSuperseded,
    SkillIntent,
    SkillOutcome,
)
from sitewright.robot_team.drivers.mujoco.places import OUTPUT_NAME
from sitewright.robot_team.skill import Skill

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]

OK, NO_MOTION, EXECUTION_FAILED, LOCKED, BACKEND, INTERRUPTED = 0, 6, 8, 9, 10, 130


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RealSite]:
    """A project of one stud on the table, built."""
    with real_site(tmp_path_factory.mktemp("built"), studs=0, supports=1) as site:
        assert site.run().exit_code == OK
        assert site.cell_pid() is None, "the cell ends with the run"
        yield site


@pytest.fixture
def copied(built: RealSite, tmp_path: Path) -> Iterator[RealSite]:
    """The same, with everything that its runs left on the disk, to be damaged."""
    ignore = shutil.ignore_patterns("cell.sock", "cell.pid")
    shutil.copytree(built.project, tmp_path / "project", ignore=ignore)
    site = RealSite(tmp_path)
    yield site
    site.clean_up()


def contents(folder: Path) -> dict[Path, bytes]:
    """Return all that a run left but the locks, which are files of the moment."""
    files = (f for f in folder.rglob("*") if f.is_file() and "lock" not in f.name)
    return {f.relative_to(folder): f.read_bytes() for f in files}


def failed_steps(site: RealSite) -> list[tuple[str, str]]:
    """Return skill and reason of every step that the cell reported as not done."""
    skills = {e.command_id: e.call.skill for e in site.events() if isinstance(e, SkillIntent)}
    return [
        (skills[e.command_id], e.report.reason)
        for e in site.events()
        if isinstance(e, SkillOutcome) and not e.report.is_done
    ]


def check_planned_anew(site: RealSite, ended: Ended, times: int) -> None:
    """A new plan is a new proposal with an approval of its own."""
    assert ended.exit_code == OK, ended.message or ended.said
    events = site.events()
    superseded = [e for e in events if isinstance(e, ProposalSuperseded)]
    assert len([e for e in superseded if e.is_replan]) == times
    proposals = [e.fingerprint for e in events if isinstance(e, ProposalMade)]
    approved = [e.approval.fingerprint for e in events if isinstance(e, ApprovalGiven)]
    assert approved == proposals
    assert len(set(proposals)) == ended.document["targets_total"] + times


# ---- physics ------------------------------------------------------------------------------


@pytest.mark.parametrize("drop_after_s", [0.1, 0.5], ids=["in the grasp", "while it is lifted"])
def test_a_piece_that_falls_back_onto_its_stack_is_taken_again(
    tmp_path: Path, drop_after_s: float
) -> None:
    with real_site(tmp_path, studs=0, supports=1, drop_after_s=drop_after_s) as site:
        check_planned_anew(site, site.run(), 1)
        (dropped,) = site.physical("dropped")
        taken = [e["piece"] for e in site.physical("gripped")]
        assert taken == [dropped["piece"]] * 2
        check_journal_against_physics(site, nails=0)


def test_a_piece_dropped_on_the_way_stays_where_it_fell_and_another_one_is_taken(
    tmp_path: Path,
) -> None:
    with real_site(tmp_path, studs=0, supports=1, drop_after_m=0.7) as site:
        ended = site.run()
        check_planned_anew(site, ended, 1)
        (dropped,) = site.physical("dropped")
        assert failed_steps(site) == [("reach", "dropped")]
        (positioned,) = [e for e in site.events() if isinstance(e, ComponentPositioned)]
        assert positioned.piece != dropped["piece"]
        assert all(dropped["piece"] in c["pair"] for c in ended.document["contacts"])


def test_a_piece_dropped_where_another_belongs_is_brought_to_the_buffer_first(
    tmp_path: Path,
) -> None:
    with real_site(tmp_path, studs=0, supports=1, drop_after_m=1.85) as site:
        check_planned_anew(site, site.run(), 1)
        (dropped,) = site.physical("dropped")
        down = [e.call for e in site.events() if isinstance(e, SkillIntent)]
        assert (Skill.SET_DOWN, (dropped["piece"], "buffer-a")) in [
            (c.skill, c.arguments) for c in down
        ]
        (positioned,) = [e for e in site.events() if isinstance(e, ComponentPositioned)]
        assert positioned.piece != dropped["piece"]
        check_journal_against_physics(site, nails=0, aside=frozenset({dropped["piece"]}))


def test_without_a_buffer_a_piece_in_the_way_is_named_for_a_person_to_take_away(
    tmp_path: Path,
) -> None:
    with real_site(tmp_path, studs=0, supports=1, drop_after_m=1.8) as site:
        site.without_buffers()
        ended = site.run()
        (dropped,) = site.physical("dropped")
        assert ended.exit_code == NO_MOTION
        why = ended.document["refused"]["support-1"]
        assert f"{dropped['piece']} is in its place" in why
        assert f"take {dropped['piece']} out of the way" in why


def test_a_nail_that_misses_is_driven_again(tmp_path: Path) -> None:
    with real_site(tmp_path, miss_shot_number=2) as site:
        ended = site.run()
        check_planned_anew(site, ended, 1)
        assert failed_steps(site) == [("fasten", "missed")]
        shots = [(e["operation"], e["is_driven"]) for e in site.physical("fastener")]
        assert [o for o, is_driven in shots if not is_driven] == [shots[1][0]]
        driven = [o for o, is_driven in shots if is_driven]
        assert len(driven) == len(set(driven)) == NAILS_PER_STUD
        assert ended.document["fasteners_driven"] == NAILS_PER_STUD


@pytest.mark.parametrize("nudge_m", [0.004, 0.03, -0.2])
def test_a_piece_moved_before_it_is_picked_is_found_where_it_is_now(
    tmp_path: Path, nudge_m: float
) -> None:
    """Somebody pushes the uppermost piece after the plan was approved."""
    faults = {"nudge_after_skills": 1, "nudge_piece_number": 3, "nudge_m": nudge_m}
    with real_site(tmp_path, studs=0, supports=1, **faults) as site:
        ended = site.run()
        check_planned_anew(site, ended, 1)
        (nudged,) = site.physical("nudged")
        seen = [e.subject for e in site.events() if isinstance(e, DeviationSeen)]
        assert seen == [nudged["piece"]]
        (gripped,) = site.physical("gripped")
        assert gripped["piece"] == nudged["piece"]
        check_journal_against_physics(site, nails=0)


# ---- approval -----------------------------------------------------------------------------


def test_an_approved_plan_that_was_changed_on_the_disk_does_not_run(tmp_path: Path) -> None:
    with real_site(tmp_path, studs=0, supports=1, real_time_factor=2.0) as site:
        site.begin()
        until(lambda: bool(site.physical("gripped")) if site.last_cell_record() else False)
        site.kill_controller()
        until(lambda: site.last_cell_record()["kind"] == "ended")
        (file,) = (site.newest / "proposals").glob("*.json")
        whole = file.read_text()
        proposal = json.loads(whole)
        trajectories = [m for s in proposal["proposal"]["steps"] for m in s["motions"]]
        trajectories[-1]["timed"]["trajectory"]["positions_rad"][1][0] += 0.01
        file.write_text(json.dumps(proposal))
        before = contents(site.newest)
        ended = site.run()
        assert ended.exit_code == EXECUTION_FAILED
        assert "changed after it was written" in ended.message
        moved = [r["kind"] for r in site.cell_records() if r["kind"] != "epoch"]
        assert moved[-1] == "ended"
        assert file.read_bytes() == before[file.relative_to(site.newest)]
        file.write_text(whole)
        assert site.run().exit_code == OK
        check_journal_against_physics(site, nails=0)


# ---- outside programs ---------------------------------------------------------------------


@pytest.mark.parametrize(
    ("program", "words"),
    [("", "pip install 'up-fast-downward"), ("kill -9 $$", "killed by SIGKILL; nothing was run")],
    ids=["missing", "killed"],
)
def test_without_fast_downward_nothing_runs_and_nothing_breaks(
    tmp_path: Path, program: str, words: str
) -> None:
    with real_site(tmp_path, studs=0, supports=1) as site:
        shadow = tmp_path / "shadow"
        package = shadow / "up_fast_downward"
        binary = package / "downward" / "builds" / "release" / "bin" / "downward"
        binary.parent.mkdir(parents=True)
        (package / "__init__.py").touch()
        if program:
            binary.write_text(f"#!/bin/sh\n{program}\n")
            binary.chmod(0o755)
        paths = filter(None, (str(shadow), os.environ.get("PYTHONPATH", "")))
        ended = site.run(PYTHONPATH=os.pathsep.join(paths))
        assert ended.exit_code == BACKEND
        assert words in ended.message
        assert [r["kind"] for r in site.cell_records()] == ["opened", "epoch"]
        check_planned_anew(site, site.run(), 0)
        check_journal_against_physics(site, nails=0)


# ---- disk ---------------------------------------------------------------------------------


def test_a_journal_that_was_cut_is_an_error_and_nothing_is_written_over(copied: RealSite) -> None:
    data = copied.journal.read_bytes()
    copied.journal.write_bytes(data[: len(data) // 2])
    before = contents(copied.runs)
    ended = copied.run()
    assert ended.exit_code == EXECUTION_FAILED
    assert ended.document["error"] == "JournalCorruptError"
    assert "--from-design" in ended.message
    assert contents(copied.runs) == before
    copied.journal.write_bytes(data)
    assert copied.run().exit_code == OK


def test_a_disk_that_takes_no_more_holds_the_run_and_room_lets_it_go_on(tmp_path: Path) -> None:
    with real_site(tmp_path, studs=0, supports=1, real_time_factor=2.0) as site:
        life = site.begin()
        until(lambda: site.last_cell_record().get("skill") == Skill.RETRACT)
        wal = site.journal.with_name("journal.db-wal")
        most = wal.stat().st_size + 4096
        resource.prlimit(life.pid, resource.RLIMIT_FSIZE, (most, most))
        ended = site.end_of(life)
        assert ended.exit_code == EXECUTION_FAILED
        assert ended.document["error"] == "JournalFullError"
        assert "Free some space" in ended.message
        assert site.run().exit_code == OK
        check_journal_against_physics(site, nails=0)


def test_a_cell_that_cannot_write_its_log_loses_nothing(tmp_path: Path) -> None:
    """It stops in the middle of a record; the next process, which can write, goes on."""
    with real_site(tmp_path, studs=0, supports=1, real_time_factor=4.0) as site:
        life = site.begin()
        until(lambda: site.last_cell_record().get("skill") == Skill.RETRACT)
        until(lambda: site.last_cell_record().get("skill") == Skill.REACH)
        pid = site.cell_pid()
        assert pid is not None
        most = site.cell_log.stat().st_size + 1000
        resource.prlimit(pid, resource.RLIMIT_FSIZE, (most, most))
        ended = site.end_of(life)
        assert ended.exit_code == OK, ended.message or ended.said
        assert [e.reason for e in site.events() if isinstance(e, LinkLost)]
        assert "was not recorded" in (site.cell_folder / OUTPUT_NAME).read_text()
        check_journal_against_physics(site, nails=0)


# ---- the user -----------------------------------------------------------------------------


def test_a_second_run_of_a_project_is_refused_while_the_first_goes_on(tmp_path: Path) -> None:
    with real_site(tmp_path, studs=0, supports=1, real_time_factor=4.0) as site:
        first = site.begin()
        until(lambda: site.journal_records() > 0)
        second = site.run()
        assert second.exit_code == LOCKED
        assert str(first.pid) in second.message
        assert site.end_of(first).exit_code == OK
        check_journal_against_physics(site, nails=0)


def test_an_interrupt_stops_the_robots_and_the_same_command_goes_on(tmp_path: Path) -> None:
    with real_site(tmp_path, studs=0, supports=1, real_time_factor=0.7) as site:
        life = site.begin()
        until(lambda: site.last_cell_record().get("skill") == Skill.GRASP)
        until(lambda: site.last_cell_record().get("skill") == Skill.REACH)
        life.send_signal(signal.SIGINT)
        assert site.end_of(life).exit_code == INTERRUPTED
        until(lambda: site.last_cell_record()["kind"] == "ended")
        assert site.last_cell_record()["report"]["reason"] == "held"
        assert site.run().exit_code == OK
        check_journal_against_physics(site, nails=0)


def test_a_finished_project_has_nothing_to_do(copied: RealSite) -> None:
    before = contents(copied.runs)
    ended = copied.run()
    assert ended.exit_code == OK
    assert "nothing to do" in ended.message
    after = contents(copied.runs)
    reports = {"report.html", "report.json", "schedule.svg"}
    assert {f for f in after if after[f] != before.get(f)} <= {
        f for f in after if f.name in reports
    }


def test_from_design_builds_again_on_an_empty_site(copied: RealSite) -> None:
    (old,) = run_folders(copied.runs)
    kept = contents(old.path)
    ended = copied.run("--from-design")
    assert ended.exit_code == OK
    assert ended.document["targets_installed"] == 1
    assert ended.document["continues"] == ""
    assert len(run_folders(copied.runs)) == 2
    assert contents(old.path) == kept
    assert copied.cell_folder.parent == copied.newest != old.path
    check_journal_against_physics(copied, nails=0)
