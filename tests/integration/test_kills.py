"""Controller and cell are killed (SIGKILL) at many moments of a real run; the building goes up.

After each kill the same command is given again. Journal and physical log, which know nothing of
each other, must then tell the same story: every grip, nail and release once, none lost.
"""

from __future__ import annotations

import random
import subprocess
import time
from collections.abc import Callable
from functools import partial
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
from sitewright.central_controller.events import (
    OperationDone,
    QuestionAsked,
    RunResumed,
    SkillIntent,
    SkillOutcome,
    SkillReconciled,
)
from sitewright.robot_team.skill import Skill

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]

KILLS = 10
JOURNAL_RECORDS, CELL_RECORDS = 150, 92
"""An undisturbed run writes a few more."""
WATCHED_SPEED = 16.0
"""Simulated seconds per second: slow enough that kills hit motions, not only pauses."""
QUESTION = 8


def test_a_controller_killed_at_ten_moments_goes_on_without_a_question(tmp_path: Path) -> None:
    with real_site(tmp_path, real_time_factor=WATCHED_SPEED) as site:
        for records, then_s in moments(1, JOURNAL_RECORDS):
            life = site.begin()
            wait_for(site.journal_records, records, then_s)
            assert life.poll() is None, "the run ended before it was killed"
            site.kill_controller()
        assert run_to_the_end(site, site.run()) == 0
        events = site.events()
        assert len([e for e in events if isinstance(e, RunResumed)]) >= KILLS - 1
        assert not [e for e in events if isinstance(e, QuestionAsked)]
        assert len(list(site.runs.glob("*/journal.db"))) == 1


def test_a_cell_killed_at_ten_moments_is_found_again_and_only_nails_are_asked_about(
    tmp_path: Path,
) -> None:
    with real_site(tmp_path, real_time_factor=WATCHED_SPEED) as site:
        kill_ten_times(site, 2, site.kill_cell)


def test_controller_and_cell_killed_together_at_ten_moments(tmp_path: Path) -> None:
    with real_site(tmp_path, real_time_factor=WATCHED_SPEED) as site:

        def kill_both() -> None:
            site.kill_cell()
            site.kill_controller()

        kill_ten_times(site, 3, kill_both)


def kill_ten_times(site: RealSite, seed: int, kill: Callable[[], None]) -> None:
    """Kill at ten moments, answering the questions in between, and go on to the end."""
    site.begin()
    for records, then_s in moments(seed, CELL_RECORDS):
        until(partial(is_at, site, records))
        time.sleep(then_s)
        kill()
    run_to_the_end(site, site.end_of(going_on(site)))
    events = site.events()
    unknown = [e for e in events if isinstance(e, SkillReconciled) and e.verdict == "unknown"]
    asked = [e for e in events if isinstance(e, QuestionAsked)]
    assert len(asked) == len(unknown)
    skills = {e.command_id: e.call.skill for e in events if isinstance(e, SkillIntent)}
    assert {skills[e.command_id] for e in unknown} <= {Skill.FASTEN}


def is_at(site: RealSite, records: int) -> bool:
    """Tell whether the cell has come so far and is there; whoever stopped is started again."""
    going_on(site)
    return site.cell_lines() >= records and site.cell_pid() is not None


def going_on(site: RealSite) -> subprocess.Popen[bytes]:
    """Return the run that is under way; one that waits for an answer gets it and is continued."""
    life = site.lives[-1]
    if life.poll() is None:
        return life
    if life.returncode > 0:  # it was not killed: a question from the kill before
        ended = site.end_of(life)
        assert ended.exit_code == QUESTION, ended.message or ended.said
        assert site.resolve(ended.document, truth(site, ended)).exit_code == 0
    return site.begin()


def moments(seed: int, records: int) -> list[tuple[int, float]]:
    """Return ten moments spread over a run: so many records, and then a while."""
    chosen = random.Random(seed)  # noqa: S311 -- repeatable, no secret
    share = records / KILLS
    return [
        (int(k * share) + chosen.randint(1, int(share)), chosen.uniform(0.0, 0.25))
        for k in range(KILLS)
    ]


def wait_for(count: Callable[[], int], records: int, then_s: float) -> None:
    until(lambda: count() >= records)
    time.sleep(then_s)


def truth(site: RealSite, ended: Ended) -> str:
    """Return what a person sees who looks at the wood: is the nail of the question there?"""
    text = str(ended.document["question"]["text"])
    driven = [e["operation"] for e in site.physical("fastener")]
    return "done" if any(f" {operation} " in text for operation in driven) else "not-done"


def run_to_the_end(site: RealSite, ended: Ended) -> int:
    """Answer each question truthfully and go on; return how many there were."""
    questions = 0
    while ended.exit_code == QUESTION and ended.document["question"] is not None:
        questions += 1
        assert site.resolve(ended.document, truth(site, ended)).exit_code == 0
        ended = site.run()
    assert ended.exit_code == 0, ended.message or ended.said
    assert ended.document["targets_installed"] == 3
    assert ended.document["unallowed_contacts"] == 0
    check_journal_against_physics(site, nails=NAILS_PER_STUD)
    return questions


def test_a_cell_killed_with_a_piece_in_hand_goes_on_from_what_is_sensed(tmp_path: Path) -> None:
    """The physics stands again where the skill began: on the pallet, on the way, at the target."""
    skills = [Skill.GRASP, Skill.RETRACT, Skill.REACH, Skill.POSITION, Skill.RELEASE]
    with real_site(tmp_path, studs=0, supports=1, real_time_factor=2.0) as site:
        life = site.begin()
        for skill in skills:
            until(partial(is_handling, site, skill))
            time.sleep(0.05)
            site.kill_cell()
        ended = site.end_of(life)
        assert ended.exit_code == 0, ended.message or ended.said
        check_journal_against_physics(site, nails=0)
        events = site.events()
        outcomes = [e for e in events if isinstance(e, SkillOutcome)]
        from_driver = {e.command_id for e in outcomes if e.source == "driver"}
        intended = {e.command_id: e.call.skill for e in events if isinstance(e, SkillIntent)}
        interrupted = [skill for command, skill in intended.items() if command not in from_driver]
        assert interrupted == skills
        assert [e["effect"] for e in site.physical()] == ["gripped", "let-go"]


def is_handling(site: RealSite, skill: Skill) -> bool:
    """Tell whether the cell is at a skill of a robot that has, or is about to take, a piece."""
    record = site.last_cell_record()
    if (record.get("kind"), record.get("skill")) != ("accepted", skill):
        return False
    return skill == Skill.GRASP or bool(site.physical("gripped"))


def test_a_cell_killed_in_a_tool_change_leaves_the_dock_and_goes_on(tmp_path: Path) -> None:
    """It dies before the old tool is docked, with a bare flange, with the new one, and painting."""
    moments_of_change = [
        ("accepted", Skill.CHANGE_END_EFFECTOR),
        ("effect", "tool-docked"),
        ("effect", "tool-taken"),
        ("accepted", Skill.APPLY_FINISH),
    ]
    with real_site(tmp_path, studs=0, supports=1, real_time_factor=4.0) as site:
        site.paint("support-1")
        life = site.begin()
        for moment in moments_of_change:
            until(partial(is_last, site, *moment))
            site.kill_cell()
        asked = site.end_of(life)
        assert asked.exit_code == QUESTION, asked.message or asked.said
        assert "apply-finish" in asked.document["question"]["text"]
        assert site.resolve(asked.document, "not-done").exit_code == 0
        ended = site.run()
        assert ended.exit_code == 0, ended.message or ended.said
        assert (ended.document["finishes_applied"], ended.document["unallowed_contacts"]) == (1, 0)
        changes = [(e["effect"], e["end_effector"]) for e in site.physical() if "end_effector" in e]
        assert changes == [("tool-docked", "nail-gun"), ("tool-taken", "paint-head")]
        check_journal_against_physics(site, nails=0)


def is_last(site: RealSite, kind: str, what: str) -> bool:
    record = site.last_cell_record()
    return (record.get("kind"), record.get("skill", record.get("effect"))) == (kind, what)


def test_a_nail_without_an_end_is_a_question_until_a_person_looks(tmp_path: Path) -> None:
    """The cell dies before one shot, after another, and at one that somebody calls half done."""
    with real_site(tmp_path, real_time_factor=2.0) as site:
        asked = kill_at_nail(site, shots=0, is_shot=False)
        before = len(site.cell_records())
        again = site.run()
        assert (again.exit_code, again.document["question"]) == (8, asked.document["question"])
        assert {r["kind"] for r in site.cell_records()[before:]} <= {"epoch"}
        assert site.resolve(asked.document, "not-done").exit_code == 0
        asked = kill_at_nail(site, shots=0, is_shot=True)
        assert site.resolve(asked.document, "done").exit_code == 0
        asked = kill_at_nail(site, shots=1, is_shot=False)
        assert site.resolve(asked.document, "partial").exit_code == 0
        assert site.resolve(asked.document, "done").exit_code == 8, "it was answered before"
        ended = site.run()
        assert (ended.exit_code, ended.document["question"]) == (8, None)
        assert "half done" in ended.document["refused"]["stud-1"]
        assert ended.document["targets_installed"] == 2
        assert [e["operation"] for e in site.physical("fastener")] == ["stud-1.nail-1"]
        done = [e for e in site.events() if isinstance(e, OperationDone)]
        assert [(e.operation, e.by) for e in done] == [("stud-1.nail-1", "person")]


def kill_at_nail(site: RealSite, *, shots: int, is_shot: bool) -> Ended:
    """Run until the cell is at its next nail, kill it before or after the shot, and return."""
    life = site.begin()
    at_nail = ("", "effect", shots + 1) if is_shot else (Skill.FASTEN, "accepted", shots)

    def is_there() -> bool:
        record = site.last_cell_record()
        return (record.get("skill", ""), record.get("kind"), site.shots()) == at_nail

    until(is_there)
    site.kill_cell()
    ended = site.end_of(life)
    assert ended.exit_code == QUESTION, ended.message or ended.said
    question = ended.document["question"]
    assert "fasten stud-1.nail-" in question["text"]
    assert f"sitewright resolve {question['run']} {question['step']} " in question["text"]
    return ended
