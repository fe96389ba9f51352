"""mplib, a MoveIt-like pipeline (FCL and OMPL's RRT-Connect), in an environment of its own."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterator
from itertools import combinations, product
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.motion.query import MotionQuery
from benchmarks.motion.solvers.answer import BUDGET_S, Answer, Solver, joints
from typing_extensions import override

from sitewright.foundation.ids import RobotId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Box, Hull, Shape
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.team_pairs import tables_of
from sitewright.planning_twin.scene import Attachment, RobotInScene, link_name, pair_of
from sitewright.robot_team.description import JointKind

_RESERVE_M = 0.0005
_WORKER = Path(__file__).parent / "mplib_worker.py"


class Mplib(Solver):
    """Asks a worker process; only its planning is timed, not what happens here."""

    def __init__(self, python: Path) -> None:
        self._process = subprocess.Popen(
            [str(python), str(_WORKER)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    @property
    @override
    def name(self) -> str:
        return "mplib"

    @override
    def solve(self, query: MotionQuery, seed: int) -> Answer:
        assert self._process.stdin is not None  # noqa: S101 - it is a pipe
        assert self._process.stdout is not None  # noqa: S101 - it is a pipe
        self._process.stdin.write(json.dumps(_asked(query, seed)) + "\n")
        self._process.stdin.flush()
        answer = json.loads(self._process.stdout.readline())
        return Answer(
            waypoints_rad=tuple(map(joints, answer["path"])),
            spent_s=answer["spent_s"],
            reason=answer["status"],
        )

    def close(self) -> None:
        """End the worker."""
        self._process.communicate()


def _asked(query: MotionQuery, seed: int) -> dict[str, Any]:
    scene = query.scene
    grow_m = scene.clearance_m / 2.0 + _RESERVE_M
    links: dict[str, Any] = {}
    carrier: dict[str, RobotId] = {}
    chain: list[dict[str, Any]] = []
    for robot, arm in scene.robots.items():
        chain += _joints_of(robot, arm)
        for link in arm.description.links:
            links[link_name(robot, link.name)] = _grown(link.shape, grow_m)
            carrier[link_name(robot, link.name)] = robot
    still: dict[str, Any] = {}
    for body in scene.bodies.values():
        placement = body.placement
        if isinstance(placement, Attachment):
            tip = link_name(placement.robot, scene.robots[placement.robot].description.tip)
            chain.append(_fixed(body.id, tip, placement.tip_T_body))
            links[body.id] = _grown(body.shape, grow_m)
            carrier[body.id] = placement.robot
        else:
            still[body.id] = _grown(body.shape, grow_m, placement)
    start, goal = _named(query)
    return {
        "seed": seed,
        "budget_s": BUDGET_S,
        "links": links,
        "still": still,
        "joints": chain,
        "tips": [link_name(r, s.description.tip) for r, s in scene.robots.items()],
        "start": start,
        "goal": goal,
        "moves": _moved(query),
        "standing": [n for n, r in carrier.items() if r not in query.robots],
        "off": list(_left_out(query, [*links])),
    }


def _named(query: MotionQuery) -> tuple[dict[str, float], dict[str, float]]:
    """Return start and goal of all joints by name."""
    start = {
        link_name(r, j.name): q
        for r, s in query.scene.robots.items()
        for j, q in zip(s.description.movable_joints, s.q_rad, strict=True)
    }
    return start, {**start, **dict(zip(_moved(query), query.goal_rad, strict=True))}


def _moved(query: MotionQuery) -> list[str]:
    """Return the names of the joints of those who move."""
    arms = query.scene.robots
    return [link_name(r, j.name) for r in query.robots for j in arms[r].description.movable_joints]


def _joints_of(robot: RobotId, arm: RobotInScene) -> Iterator[dict[str, Any]]:
    description = arm.description
    yield _fixed(link_name(robot, description.root), "world", arm.world_T_base)
    for joint in description.joints:
        child, parent = link_name(robot, joint.child), link_name(robot, joint.parent)
        if joint.kind is JointKind.FIXED:
            yield _fixed(child, parent, joint.parent_T_joint)
            continue
        yield {
            "name": link_name(robot, joint.name),
            "kind": "revolute",
            "parent": parent,
            "child": child,
            "pose": _numbers(joint.parent_T_joint),
            "axis": list(joint.axis),
            "limits": [joint.lower_rad, joint.upper_rad],
            "speed": joint.velocity_rad_s,
        }


def _fixed(child: str, parent: str, pose: Pose) -> dict[str, Any]:
    name = f"{child} on {parent}"
    return {"name": name, "kind": "fixed", "parent": parent, "child": child, "pose": _numbers(pose)}


def _left_out(query: MotionQuery, names: list[str]) -> Iterator[tuple[str, str]]:
    """Yield the pairs of links that the motion does not change, or that are near by design."""
    layout = ProofScenes().of(query.scene).layout
    table = tables_of(layout, query.robots)[0]
    is_close = np.bincount(table.name, table.is_neighbour, len(table.names)) > 0
    counted = {pair for pair, close in zip(table.names, is_close, strict=True) if not close}
    for a, b in combinations(names, 2):
        if pair_of(a, b) not in counted:
            yield a, b


def _grown(shape: Shape, by_m: float, frame: Pose | None = None) -> list[dict[str, Any]]:
    """Return convex parts that stand out by so much, each with its pose in a link or the world."""
    frame = frame or Pose()
    parts: list[dict[str, Any]] = []
    for part in shape:
        match part:
            case Box(size_m=size, body_T_box=pose):
                grown = [s + 2.0 * by_m for s in size]
                parts.append({"box": grown, "pose": _numbers(frame @ pose)})
            case Hull(points_m=points):
                ball = by_m * _directions()
                cloud = (np.array(points)[:, None] + ball[None]).reshape(-1, 3)
                parts.append({"points": cloud.tolist(), "pose": _numbers(frame)})
    return parts


def _directions() -> Any:  # noqa: ANN401 - an array
    rows = np.array([d for d in product((-1.0, 0.0, 1.0), repeat=3) if any(d)])
    return rows / np.linalg.norm(rows, axis=1, keepdims=True)


def _numbers(pose: Pose) -> list[float]:
    return [*pose.position_m, *pose.quaternion_wxyz]
