"""Skills in the simulated cell succeed and fail by physics, never because they were commanded."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import builders_cell as site
from builders_cell import (
    DOWN,
    GRIPPER,
    NAILER,
    PAINTER,
    TABLE_TOP_M,
    TARGET,
    THICK,
    THIN,
    A,
    B,
    Mover,
    command,
    grasp_pose,
    over,
)
from sitewright.errors import CommandRefusedError
from sitewright.foundation.ids import CommandId
from sitewright.foundation.pose import Pose, rotation, translation
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.driver import SkillReport
from sitewright.robot_team.drivers.mujoco.codec import (
    Setup,
    checkpoint_from_json,
    checkpoint_to_json,
    command_from_json,
    command_to_json,
    setup_from_json,
    setup_to_json,
)
from sitewright.robot_team.drivers.mujoco.faults import drop_when_due, nudge_when_due
from sitewright.robot_team.drivers.mujoco.observing import observe
from sitewright.robot_team.drivers.mujoco.opening import open_simulation
from sitewright.robot_team.drivers.mujoco.skills.registry import EXECUTORS, check, execute
from sitewright.robot_team.piece import Piece
from sitewright.robot_team.skill import Skill, SkillCommand

NAIL = {"type": "nail", "d_m": 0.0031, "l_m": 0.09}
TIGHT: dict[str, Any] = {"tolerance_m": 0.002, "tolerance_rad": 0.005}


class Site:
    """A simulation with a planner that does not look, and all that was recorded."""

    def __init__(self, cell: Cell | None = None, pieces: tuple[Piece, ...] | None = None) -> None:
        self.cell = cell or site.cell()
        self.effects: list[Any] = []
        self.contacts: list[Any] = []
        setup = Setup(cell=self.cell, pieces=site.pieces() if pieces is None else pieces)
        self.sim = open_simulation(setup, None, self.effects.append)
        self.sim.on_step = drop_when_due
        self.mover = Mover(self.cell)

    def do(self, order: SkillCommand) -> SkillReport:
        check(self.sim, order, EXECUTORS)
        report, contacts = execute(self.sim, order)
        self.contacts += contacts
        return report

    def done(self, order: SkillCommand) -> SkillReport:
        report = self.do(order)
        assert report.is_done, report
        return report

    def pose(self, name: str) -> Pose:
        return self.sim.physics.pose(name)

    def go(self, robot: Any, tool: Any, *poses: Pose, skill: str = "reach") -> SkillReport:
        return self.do(command(skill, robot, self.mover.to_tcp(robot, tool, *poses)))

    def pick(self) -> SkillReport:
        at = grasp_pose(self.pose("thin-4"))
        assert self.go(A, GRIPPER, over(at, 0.3), at).is_done
        return self.do(command("grasp", A, piece="thin-4", width_m=0.09, tolerance_m=0.002))

    def place(self) -> None:
        assert self.pick().is_done
        start, goal = grasp_pose(self.pose("thin-4")), grasp_pose(TARGET)
        ways = [over(start, 0.15), over(start, 0.3), over(goal, 0.3), over(goal, 0.05), goal]
        assert self.go(A, GRIPPER, *ways).is_done

    def aim(self, x: float, y: float, height_m: float = 0.0) -> Pose:
        top_m = TARGET.position_m[2] + THIN[2] / 2
        tip = Pose((x, y, top_m + height_m)) @ DOWN
        assert self.go(B, NAILER, over(tip, 0.15), tip).is_done
        return tip

    def shoot(self, name: str, into: str = "support-2", needed_m: float = 0.03) -> SkillReport:
        return self.do(
            command(
                "fasten",
                B,
                operation=name,
                through="thin-4",
                into=into,
                fastener=NAIL,
                penetration_m=needed_m,
            )
        )

    def nail_at(self, x: float, y: float) -> None:
        tip = self.aim(x, y)
        into = "support-2" if x > 0 else "support-1"
        assert self.shoot(f"nail-{x}-{y}", into).is_done
        assert self.go(B, NAILER, over(tip, 0.15), skill="retract").is_done


def number(report: SkillReport, key: str) -> float:
    value = report.evidence[key]
    assert isinstance(value, float)
    return value


def warnings_of(at: Site) -> int:
    return sum(int(w.number) for w in at.sim.physics.d.warning)


# ---- motion -----------------------------------------------------------------------------------


def test_a_fast_motion_is_followed_within_two_milliradians() -> None:
    at = Site()
    far = tuple(math.radians(v) for v in (80, -60, 90, 60, 60, 170))
    report = at.done(command("reach", A, at.mover.through(A, far, site.HOME)))
    assert number(report, "tracking_rad") < 0.002
    assert warnings_of(at) == 0
    assert at.contacts == []


def test_a_motion_that_starts_elsewhere_is_refused_and_nothing_moves() -> None:
    at = Site()
    elsewhere = tuple(q + 0.02 for q in site.HOME)
    trajectory = site.lines(at.cell.robot_by_id[A], (elsewhere, site.HOME))
    before = observe(at.sim)
    report = at.do(command("reach", A, trajectory))
    assert (report.is_done, report.reason) == (False, "tracking")
    assert observe(at.sim).robots[A].q_rad == before.robots[A].q_rad


@pytest.mark.parametrize("factor", [1.5, float("nan")])
def test_a_motion_past_the_speed_limit_is_refused(factor: float) -> None:
    at = Site()
    trajectory = at.mover.through(A, tuple(q + 0.8 for q in site.HOME[:1]) + site.HOME[1:])
    fast = replace(
        trajectory,
        velocities_rad_s=tuple(
            tuple(3.0 * factor * v for v in row) for row in trajectory.velocities_rad_s
        ),
    )
    assert at.do(command("reach", A, fast)).reason == "tracking"
    assert at.sim.physics.d.qpos[at.sim.arms.positions].tolist() == pytest.approx(site.HOME * 2)


def test_hold_stops_on_the_path_and_the_joints_stay_near_it() -> None:
    at = Site()
    goal = (1.2, *site.HOME[1:])
    order = command("reach", A, at.mover.through(A, goal))
    at.sim.on_step = lambda sim: sim.hold.set() if sim.time_s > 0.9 else None
    report = at.do(order)
    assert (report.is_done, report.reason) == (False, "held")
    sensed = observe(at.sim).robots[A]
    assert 0.05 < sensed.q_rad[0] < 1.15
    assert sensed.q_rad[1:] == pytest.approx(site.HOME[1:], abs=1e-3)
    assert max(map(abs, sensed.velocity_rad_s)) < 5e-3


# ---- grip -------------------------------------------------------------------------------------


def test_a_stud_is_lifted_and_the_one_below_stays() -> None:
    at = Site()
    below = at.pose("thin-3")
    report = at.pick()
    assert report.is_done
    assert observe(at.sim).robots[A].gripped == "thin-4"
    start = at.pose("thin-4")
    assert at.go(A, GRIPPER, over(grasp_pose(start), 0.3), skill="retract").is_done
    assert at.pose("thin-4").position_m[2] - start.position_m[2] == pytest.approx(0.3, abs=1e-3)
    assert at.pose("thin-3").distance_to_m(below) < 0.001
    assert at.contacts == []
    assert warnings_of(at) == 0


def test_a_grasp_in_the_air_fails_and_holds_nothing() -> None:
    at = Site()
    beside = translation(0.0, 0.5, 0.2) @ grasp_pose(at.pose("thin-4"))
    assert at.go(A, GRIPPER, beside).is_done
    report = at.do(command("grasp", A, piece="thin-4", width_m=0.09, tolerance_m=0.002))
    assert (report.is_done, report.reason) == (False, "grasp-failed")
    assert at.sim.fixings.grips == {}
    assert observe(at.sim).robots[A].gripped is None
    assert observe(at.sim).robots[A].aperture_m == pytest.approx(0.17, abs=1e-3)
    assert [e for e in at.effects if e["effect"] == "gripped"] == []


def test_a_piece_of_another_width_is_not_taken_for_the_expected_one() -> None:
    at = Site()
    grasp = grasp_pose(at.pose("thin-4"))
    assert at.go(A, GRIPPER, over(grasp, 0.3), grasp).is_done
    report = at.do(command("grasp", A, piece="thin-4", width_m=0.084, tolerance_m=0.002))
    assert report.reason == "grasp-failed"
    assert at.sim.fixings.grips == {}


def test_a_rebuild_while_holding_moves_the_piece_less_than_a_tenth_of_a_millimetre() -> None:
    at = Site()
    assert at.pick().is_done
    assert at.go(A, GRIPPER, over(grasp_pose(at.pose("thin-4")), 0.3)).is_done
    before = at.pose("thin-4")
    at.sim.fix(at.sim.fixings)
    at.sim.advance(0.2)
    assert at.pose("thin-4").distance_to_m(before) < 1e-4


def test_a_released_stud_lies_on_what_it_was_put_on() -> None:
    at = Site()
    at.place()
    placed = at.done(
        command(
            "position",
            A,
            piece="thin-4",
            world_T_piece=TARGET,
            rests_on=["support-1", "support-2"],
            **TIGHT,
        )
    )
    assert number(placed, "off_m") < 0.001
    at.done(command("release", A, piece="thin-4", aperture_m=0.13))
    assert at.go(A, GRIPPER, over(grasp_pose(TARGET), 0.3), skill="retract").is_done
    top_m = TABLE_TOP_M + THICK[2] + THIN[2] / 2
    assert at.pose("thin-4").position_m[2] == pytest.approx(top_m, abs=3e-4)
    assert observe(at.sim).robots[A].aperture_m == pytest.approx(0.13, abs=1e-3)
    assert at.contacts == []


def test_position_fails_when_the_piece_does_not_touch_its_supports() -> None:
    at = Site()
    at.place()
    goal = over(TARGET, 0.004)
    assert at.go(A, GRIPPER, grasp_pose(goal)).is_done
    report = at.do(
        command(
            "position",
            A,
            piece="thin-4",
            world_T_piece=goal,
            rests_on=["support-1", "support-2"],
            **TIGHT,
        )
    )
    assert report.reason == "position-failed"
    assert set(report.evidence["apart_m"]) == {"support-1", "support-2"}  # type: ignore[arg-type]


def test_a_lost_grip_drops_the_piece_and_is_reported() -> None:
    at = Site(site.cell(drop_after_s=1.0))
    assert at.pick().is_done
    start = grasp_pose(at.pose("thin-4"))
    report = at.go(A, GRIPPER, over(start, 0.3), over(start, 0.5), over(start, 0.3))
    assert (report.is_done, report.reason) == (False, "dropped")
    at.sim.advance(1.0)
    assert at.pose("thin-4").position_m[2] < 0.6
    assert observe(at.sim).robots[A].gripped is None
    assert [e["effect"] for e in at.effects] == ["gripped", "dropped"]


def test_a_grip_may_be_lost_after_a_way_instead_of_a_time() -> None:
    at = Site(site.cell(drop_after_m=0.1))
    assert at.pick().is_done
    start = grasp_pose(at.pose("thin-4"))
    assert at.go(A, GRIPPER, over(start, 0.05), over(start, 0.09)).is_done
    assert at.go(A, GRIPPER, over(start, 0.09), over(start, 0.3)).reason == "dropped"
    (dropped,) = [e for e in at.effects if e["effect"] == "dropped"]
    assert dropped["piece"] == "thin-4"


def test_set_down_needs_the_piece_at_its_place() -> None:
    at = Site()
    assert at.pick().is_done
    here = at.pose("thin-4")
    aside = translation(0.02, 0.0, 0.0) @ here
    order: dict[str, Any] = {"piece": "thin-4", "aperture_m": 0.13, **TIGHT}
    report = at.do(command("set-down", A, world_T_piece=aside, **order))
    assert (report.is_done, report.reason) == (False, "position-failed")
    assert at.pick().is_done
    at.done(command("set-down", A, world_T_piece=here, **order))


# ---- nails ------------------------------------------------------------------------------------


def test_a_push_on_a_nailed_support_moves_the_stud_with_it() -> None:
    at = Site()
    at.place()
    for x, y in ((0.62, 0.02), (0.58, -0.02)):
        at.nail_at(x, y)
    at.done(command("release", A, piece="thin-4", aperture_m=0.13))
    clear = over(grasp_pose(TARGET), 0.3)
    parked = (math.radians(115), *site.HOME[1:])
    at.done(command("retract", A, at.mover.to_tcp(A, GRIPPER, clear)))
    at.done(command("reach", A, at.mover.through(A, parked)))
    assert len(observe(at.sim).fasteners) == 2
    before = {p: at.pose(p) for p in ("thin-4", "support-2", "support-1")}
    body = at.sim.physics.body("support-2")
    for _ in range(150):
        at.sim.physics.d.xfrc_applied[body, :3] = (0.0, 500.0, 0.0)
        at.sim.step()
    at.sim.physics.d.xfrc_applied[:] = 0.0
    at.sim.physics.refresh()
    moved = {p: at.pose(p).distance_to_m(b) for p, b in before.items()}
    assert moved["support-2"] > 0.02
    assert moved["thin-4"] > 0.01
    apart = at.pose("support-2").inverse() @ at.pose("thin-4")
    joined = before["support-2"].inverse() @ before["thin-4"]
    assert apart.distance_to_m(joined) < 0.001
    assert at.contacts == []


def test_a_nail_in_the_air_is_missed_and_joins_nothing() -> None:
    at = Site()
    at.place()
    at.aim(0.62, 0.02, height_m=0.02)
    report = at.shoot("n1")
    assert (report.is_done, report.reason) == (False, "missed")
    assert observe(at.sim).fasteners == ()
    assert at.sim.fixings.connections == ()
    shot = [e for e in at.effects if e["effect"] == "fastener"]
    assert [e["is_driven"] for e in shot] == [False]


@pytest.mark.parametrize(
    ("x", "into", "needed_m"),
    [(0.40, "support-2", 0.03), (0.62, "support-1", 0.03), (0.62, "support-2", 0.06)],
    ids=["beside the receiver", "into the wrong body", "not deep enough"],
)
def test_a_nail_that_does_not_hold_is_missed(x: float, into: str, needed_m: float) -> None:
    at = Site()
    at.place()
    at.aim(x, 0.02)
    assert at.shoot("n1", into, needed_m).reason == "missed"
    assert at.sim.fixings.connections == ()


def test_a_deflected_shot_misses_and_the_next_one_holds() -> None:
    at = Site(site.cell(miss_shot_number=1))
    at.place()
    at.aim(0.62, 0.02)
    assert at.shoot("n1").reason == "missed"
    assert at.shoot("n1").is_done
    assert [e["is_driven"] for e in at.effects if e["effect"] == "fastener"] == [False, True]


def test_a_leaning_gun_still_drives_its_nail() -> None:
    at = Site()
    at.place()
    top_m = TARGET.position_m[2] + THIN[2] / 2 + 0.012 * math.sin(math.radians(5))
    tip = Pose((0.62, 0.02, top_m)) @ DOWN @ rotation((0, 1, 0), math.radians(5))
    assert at.go(B, NAILER, over(tip, 0.15), tip).is_done
    report = at.shoot("n1", needed_m=0.045)
    assert report.is_done
    assert 0.045 < number(report, "penetration_m") < 0.05


def test_a_tool_drives_only_its_own_fasteners() -> None:
    at = Site()
    at.place()
    at.aim(0.62, 0.02)
    for fastener in ({**NAIL, "type": "screw"}, {**NAIL, "l_m": 0.12}):
        report = at.do(
            command(
                "fasten",
                B,
                operation="n1",
                through="thin-4",
                into="support-2",
                fastener=fastener,
                penetration_m=0.03,
            )
        )
        assert report.reason == "missed"
    assert at.effects[-1]["effect"] == "gripped"


# ---- tools and paint --------------------------------------------------------------------------


def change(at: Site, off: Pose = Pose()) -> SkillReport:  # noqa: B008 - a value
    def dock(name: Any) -> Pose:
        tool = at.cell.end_effector_by_id[name]
        assert tool.station is not None
        return at.cell.station_by_id[tool.station].world_T_station @ tool.station_T_mount @ off

    old, new = dock(NAILER), dock(PAINTER)
    ways = (
        at.mover.to_tcp(B, None, over(old, 0.3), old),
        at.mover.to_tcp(B, None, over(old, 0.3), over(new, 0.3), new),
        at.mover.to_tcp(B, None, over(new, 0.3)),
    )
    return at.do(
        command("change-end-effector", B, *ways, old=NAILER, new=PAINTER, station="tools-b")
    )


def test_a_tool_is_changed_and_the_sensors_say_so() -> None:
    at = Site()
    report = change(at)
    assert report.is_done, report
    seen = observe(at.sim)
    assert seen.robots[B].mounted == PAINTER
    assert seen.docked == {NAILER: "tools-b"}
    assert [e["effect"] for e in at.effects] == ["tool-docked", "tool-taken"]
    assert at.contacts == []
    flange = at.sim.tip(B)
    assert at.pose(PAINTER).distance_to_m(flange) < 1e-6


def test_a_flange_that_is_not_at_the_dock_leaves_the_tool_mounted() -> None:
    at = Site()
    report = change(at, off=translation(0.0, 0.008, 0.0))
    assert (report.is_done, report.reason) == (False, "dock-failed")
    assert observe(at.sim).robots[B].mounted == NAILER


def paint(at: Site, strokes: int) -> SkillReport:
    """Spray the top of the second support in parallel strokes along y."""
    width_m, standoff_m = 0.05, 0.15
    patch = Pose((0.6, 0.0, TABLE_TOP_M + THICK[2])) @ DOWN
    poses = []
    for k in range(strokes):
        x = 0.6 + (k - 0.5) * 0.045
        ends = [
            Pose((x, y, TABLE_TOP_M + THICK[2] + standoff_m)) @ DOWN
            for y in (-0.15, -0.09, -0.03, 0.03, 0.09, 0.15)
        ]
        poses += ends if k % 2 == 0 else ends[::-1]
    start, *rest = poses
    assert at.go(B, PAINTER, start).is_done
    return at.do(
        command(
            "apply-finish",
            B,
            at.mover.to_tcp(B, PAINTER, *rest),
            operation="paint-1",
            piece="support-2",
            world_T_patch=patch,
            size_m=[0.09, 0.30],
            standoff_m=standoff_m,
            width_m=width_m,
            coverage=0.95,
        )
    )


def test_paint_covers_only_what_the_cone_swept() -> None:
    at = Site(pieces=site.pieces()[:2])
    assert change(at).is_done
    short = paint(at, 1)
    assert (short.is_done, short.reason) == (False, "coverage-short")
    assert 0.3 < observe(at.sim).coverage["paint-1"] < 0.7  # type: ignore[index]
    assert paint(at, 2).is_done
    assert observe(at.sim).coverage["paint-1"] >= 0.95  # type: ignore[index]


def test_paint_does_not_stick_to_air() -> None:
    at = Site(pieces=tuple(p for p in site.pieces() if p.id != "support-2"))
    assert change(at).is_done
    with pytest.raises(CommandRefusedError, match="support-2"):
        paint(at, 2)


# ---- contacts, observation, start -------------------------------------------------------------


def test_an_arm_that_hits_something_is_in_the_contact_log() -> None:
    at = Site()
    into = grasp_pose(translation(0.3, -0.3, -0.17) @ TARGET)
    at.go(A, GRIPPER, over(into, 0.3), into, over(into, 0.3))
    pairs = {tuple(c["pair"]) for c in at.contacts}
    assert any("assembly-table" in p for p in pairs), pairs
    assert all(c["depth_m"] > 0.0 and c["skill"] == "reach" for c in at.contacts)


def test_declared_contacts_are_allowed_and_nothing_else_is() -> None:
    at = Site()
    at.place()
    assert at.go(A, GRIPPER, grasp_pose(over(TARGET, 0.05))).is_done
    down = grasp_pose(translation(0.0, 0.0, -0.001) @ TARGET)
    trajectory = at.mover.to_tcp(A, GRIPPER, down, grasp_pose(over(TARGET, 0.1)))
    order = command("reach", A, trajectory, contacts=[["support-1", "thin-4"]])
    at.do(order)
    assert {tuple(c["pair"]) for c in at.contacts} == {("support-2", "thin-4")}


def test_resting_pieces_do_not_drift() -> None:
    at = Site()
    before = {p.id: at.pose(p.id) for p in site.pieces()}
    at.sim.advance(20.0)
    assert max(at.pose(p).distance_to_m(b) for p, b in before.items()) < 1e-5


def test_noise_is_seeded_and_off_by_default() -> None:
    def read(**settings: float) -> tuple[float, ...]:
        return observe(Site(site.cell(**settings)).sim).world_T_piece["thin-1"].position_m  # type: ignore[index]

    assert read(noise_m=0.001, seed=3) == read(noise_m=0.001, seed=3)
    assert read(noise_m=0.001, seed=3) != read(noise_m=0.001, seed=4)
    plain = read()
    assert math.dist(plain, read(noise_m=0.001, seed=3)) < 0.006
    assert plain == read(seed=9)


def test_a_nudged_piece_lies_elsewhere_and_only_once() -> None:
    at = Site(site.cell(nudge_after_skills=2, nudge_piece_number=6, nudge_m=0.05))
    before = at.pose("thin-4")
    for skills in (1, 2, 3):
        nudge_when_due(at.sim, skills)
    assert at.pose("thin-4").position_m[0] - before.position_m[0] == pytest.approx(0.05, abs=2e-3)
    assert [e["effect"] for e in at.effects] == ["nudged"]


def test_a_checkpoint_brings_back_the_same_state() -> None:
    at = Site()
    at.place()
    at.nail_at(0.62, 0.02)
    stored = checkpoint_to_json(at.sim.checkpoint())
    setup = Setup(cell=at.cell, pieces=site.pieces())
    again = open_simulation(
        setup_from_json(setup_to_json(setup)), checkpoint_from_json(stored), print
    )
    first, second = observe(at.sim), observe(again)
    assert first == second
    again.advance(0.5)
    third = observe(again)
    moved = [
        third.world_T_piece[p].distance_to_m(first.world_T_piece[p]) for p in first.world_T_piece
    ]
    assert max(moved) < 1e-4
    assert np.allclose(third.robots[A].q_rad, first.robots[A].q_rad, atol=1e-4)


def test_a_command_survives_its_way_as_json() -> None:
    at = Site()
    order = command("reach", A, at.mover.through(A, (0.5, *site.HOME[1:])), contacts=(("a", "b"),))
    back = command_from_json(command_to_json(order))
    assert back.trajectories == order.trajectories
    assert back.params == {"contacts": [["a", "b"]]}
    assert (back.command_id, back.epoch, back.skill) == (order.command_id, 1, "reach")


@pytest.mark.parametrize(
    ("skill", "params"),
    [
        ("fly", {}),
        ("grasp", {"piece": "thin-4"}),
        ("grasp", {"piece": "nothing", "width_m": 0.09, "tolerance_m": 0.002}),
        ("grasp", {"piece": "thin-4", "width_m": float("nan"), "tolerance_m": 0.002}),
        ("release", {"piece": "thin-4", "aperture_m": -1.0}),
        ("set-down", {"piece": "thin-4", "aperture_m": 0.1, "world_T_piece": {"p_m": [0, 0]}}),
        ("fasten", {"operation": "n", "through": "thin-4", "into": "support-1"}),
        ("change-end-effector", {"old": "nail-gun", "new": None}),
        ("change-end-effector", {"old": "hammer", "new": None}),
        ("reach", {"contacts": "all"}),
    ],
)
def test_a_command_that_makes_no_sense_is_refused_before_anything_moves(
    skill: str, params: dict[str, Any]
) -> None:
    at = Site()
    with pytest.raises(CommandRefusedError):
        check(at.sim, command(skill, A, **params), EXECUTORS)


def test_every_skill_has_an_executor() -> None:
    assert set(EXECUTORS) == set(Skill)


def test_command_ids_of_these_tests_are_unique() -> None:
    ids = [command("reach", A).command_id for _ in range(5)]
    assert len(set(ids)) == 5
    assert all(isinstance(CommandId(i), str) for i in ids)
    assert all(a < b for a, b in pairwise(ids))
