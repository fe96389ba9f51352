"""Stored certificates are proven again without the planner; whatever was forged is named."""

from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from builders_audit import Started, started, wooden_frame, write_run
from builders_planning import SUPPORT_1, Rehearsal
from sitewright.app.auditing import audit_certificates
from sitewright.app.run_folder import RunFolder
from sitewright.cli.main import commands
from sitewright.foundation.ids import BodyId
from sitewright.foundation.pose import Pose, translation
from sitewright.planning_twin.audit import Fault
from sitewright.planning_twin.motion import PathSegment
from sitewright.robot_team.skill import Skill

_AUDIT_ALONE = """
import sys
from sitewright.cli.main import exit_code
code = exit_code(["audit", "certificates", sys.argv[1]])
loaded = [m for m in sys.modules if m.startswith(("roboplan", "pinocchio", "mujoco", "ruckig",
    "py_opw_kinematics", "sitewright.planning_twin.backends"))]
print(code, *sorted(loaded))
"""


@pytest.fixture(scope="module")
def honest(frame: Rehearsal) -> Started:
    """Return the first reach: a free way, a straight way, and the last three centimetres."""
    return started(frame, SUPPORT_1, Skill.REACH)


def objections(folder: Path, start: Started) -> dict[Fault, str]:
    """Return what an audit says about a run in which the step started, by fault."""
    project = wooden_frame(folder)
    return audited(folder, write_run(project, start))


def audited(folder: Path, run: RunFolder) -> dict[Fault, str]:
    report = audit_certificates(wooden_frame(folder), run)
    found: dict[Fault, str] = {}
    for motion in report.motions:
        for objection in motion.findings.objections:
            found[objection.fault] = found.get(objection.fault, "") + objection.what
    assert report.is_proven == (not found)
    return found


def test_an_honest_run_is_proven_again(tmp_path: Path, honest: Started) -> None:
    project = wooden_frame(tmp_path)
    report = audit_certificates(project, write_run(project, honest))
    assert report.is_proven
    assert report.is_scene_compared
    (motion,) = report.motions
    assert motion.findings.pairs > 300
    assert motion.findings.longest_contact_m == pytest.approx(0.03, abs=1e-4)
    assert motion.findings.closest_distance_m == honest.certificate.closest_distance_m


def test_the_command_says_what_it_found(tmp_path: Path, honest: Started) -> None:
    write_run(wooden_frame(tmp_path), honest)
    result = CliRunner().invoke(commands, ["audit", "certificates", str(tmp_path), "--json"])
    document = json.loads(result.stdout)
    assert result.return_value == 0 or result.exit_code == 0
    assert document["schema"] == "sitewright.audit/1"
    assert document["is_proven"]
    assert [m["skill"] for m in document["motions"]] == ["reach"]


def test_planner_and_prover_are_not_even_loaded(tmp_path: Path, honest: Started) -> None:
    write_run(wooden_frame(tmp_path), honest)
    run = subprocess.run(
        [sys.executable, "-c", _AUDIT_ALONE, str(tmp_path)],
        capture_output=True,
        text=True,
        check=True,
    )
    code, *loaded = run.stdout.splitlines()[-1].split()
    assert code == "0"
    own = {"sitewright.planning_twin.backends", "sitewright.planning_twin.backends.audit"}
    inside = {f"sitewright.planning_twin.backends.audit.{m}" for m in _audit_modules()}
    assert set(loaded) == own | inside


def _audit_modules() -> list[str]:
    return ["gaps", "pairs", "parts", "reproof"]


def test_a_scene_that_was_changed_on_the_disk_is_told(tmp_path: Path, honest: Started) -> None:
    run = write_run(wooden_frame(tmp_path), honest)
    file = run.path / "blobs" / honest.certificate.scene_revision
    file.write_text(file.read_text().replace("0.01", "0.001", 1))
    assert "changed after it was written" in audited(tmp_path, run)[Fault.RECORD]


def test_a_shape_that_is_missing_is_told(tmp_path: Path, honest: Started) -> None:
    run = write_run(wooden_frame(tmp_path), honest)
    sizes = {p: p.stat().st_size for p in (run.path / "blobs").iterdir()}
    min(sizes, key=lambda p: sizes[p]).unlink()
    assert "cannot be read" in audited(tmp_path, run)[Fault.RECORD]


def test_a_proposal_that_was_changed_on_the_disk_is_told(tmp_path: Path, honest: Started) -> None:
    run = write_run(wooden_frame(tmp_path), honest)
    (file,) = (run.path / "proposals").iterdir()
    file.write_text(
        file.read_text().replace('"closest_distance_m":0.0', '"closest_distance_m":0.9')
    )
    assert "changed after it was written" in audited(tmp_path, run)[Fault.RECORD]


def test_a_missing_body_in_the_scene_is_told(tmp_path: Path, honest: Started) -> None:
    """All hashes are right: only journal and cell file know that the table is there."""
    forged = honest.with_scene(honest.scene.without(BodyId("assembly-table")))
    assert objections(tmp_path, forged) == {Fault.SCENE: "body assembly-table is missing"}


def test_a_piece_at_another_place_in_the_scene_is_told(tmp_path: Path, honest: Started) -> None:
    piece = BodyId("thin.1")
    pose = honest.scene.bodies[piece].placement
    assert isinstance(pose, Pose)
    forged = honest.with_scene(honest.scene.placed(piece, translation(0.0, 0.0, 1.0) @ pose))
    assert "thin.1 is somewhere else" in objections(tmp_path, forged)[Fault.SCENE]


def test_a_lower_clearance_in_the_scene_is_told(tmp_path: Path, honest: Started) -> None:
    forged = honest.with_scene(replace(honest.scene, clearance_m=0.001))
    assert "clearance is 1 mm, not 10 mm" in objections(tmp_path, forged)[Fault.SCENE]


def test_another_trajectory_that_was_started_is_told(tmp_path: Path, honest: Started) -> None:
    trajectory = honest.motion.timed.trajectory
    other = replace(trajectory, times_s=tuple(1.5 * t for t in trajectory.times_s))
    found = objections(tmp_path, replace(honest, told=other))
    assert "not the one that was approved" in found[Fault.TRAJECTORY]


def test_a_trajectory_off_its_path_is_told(tmp_path: Path, honest: Started) -> None:
    timed = honest.motion.timed
    rows = timed.trajectory.velocities_rad_s
    swerving = replace(timed.trajectory, velocities_rad_s=(rows[0], (9.0, *rows[1][1:]), *rows[2:]))
    motion = replace(honest.motion, timed=replace(timed, trajectory=swerving))
    assert "leaves its path" in objections(tmp_path, honest.with_motion(motion))[Fault.TRAJECTORY]


def test_a_path_through_something_is_told_with_the_pair(tmp_path: Path, honest: Started) -> None:
    """The last line goes on for ten centimetres, with a certificate that says it is fine."""

    def deeper(number: int, segment: PathSegment) -> PathSegment:
        if number != len(honest.motion.timed.path.segments) - 1:
            return segment
        a, b = segment.waypoints_rad[-2:]
        beyond = tuple(y + 3.0 * (y - x) for x, y in zip(a, b, strict=True))
        return replace(segment, waypoints_rad=(*segment.waypoints_rad, beyond))

    found = objections(tmp_path, honest.with_segments(deeper))
    assert "thick." in found[Fault.DISTANCE]
    assert Fault.TRAJECTORY in found


def test_a_certificate_about_another_path_is_told(tmp_path: Path, honest: Started) -> None:
    certificate = replace(honest.certificate, path_sha256="0" * 64)
    found = objections(tmp_path, replace(honest, certificate=certificate))
    assert found == {Fault.TRAJECTORY: "the certificate is about another path"}


def test_a_deeper_contact_is_told(tmp_path: Path, honest: Started) -> None:
    forged = honest.with_segments(
        lambda _number, s: replace(s, threshold_m=dict.fromkeys(s.threshold_m, -0.05))
    )
    found = objections(tmp_path, forged)
    assert "may overlap by 50.0 mm" in found[Fault.THRESHOLD]


def test_a_contact_that_is_allowed_all_along_is_told(tmp_path: Path, honest: Started) -> None:
    last = honest.motion.timed.path.segments[-1].threshold_m
    forged = honest.with_segments(lambda _number, s: replace(s, threshold_m=dict(last)))
    assert "allow contacts over" in objections(tmp_path, forged)[Fault.THRESHOLD]


def test_a_greater_distance_than_is_true_is_told(tmp_path: Path, honest: Started) -> None:
    certificate = replace(
        honest.certificate, closest_distance_m=honest.certificate.closest_distance_m + 0.01
    )
    found = objections(tmp_path, replace(honest, certificate=certificate))
    assert set(found) == {Fault.CLAIM}


def test_a_start_without_certificates_is_not_proven(tmp_path: Path, honest: Started) -> None:
    """Runs of an older version kept none."""
    project = wooden_frame(tmp_path)
    report = audit_certificates(project, write_run(project, replace(honest, keeps_proofs=False)))
    assert (report.is_proven, report.not_kept) == (False, 1)
    result = CliRunner().invoke(commands, ["audit", "certificates", str(tmp_path)])
    assert "1 motions are of a version that kept no certificates" in result.stdout


def test_another_cell_file_is_said_not_to_be_compared(tmp_path: Path, honest: Started) -> None:
    project = wooden_frame(tmp_path)
    run = write_run(project, honest)
    project.cell_file.write_text(project.cell_file.read_text() + "\n# looked over\n")
    report = audit_certificates(project, run)
    assert (report.is_proven, report.is_scene_compared) == (True, False)
