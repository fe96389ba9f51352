"""Runs in mplib's own environment: reads queries as JSON lines, writes paths as JSON lines.

It imports nothing of the project. All shapes are grown by half of the clearance before they come
here, so that a path that is free keeps the clearance.
"""

from __future__ import annotations

import json
import os
import sys
import time
import warnings
from typing import Any

import mplib
import numpy as np
from mplib import ArticulatedModel, PlanningWorld
from mplib.collision_detection import fcl
from mplib.planning.ompl import FixedJoint, OMPLPlanner
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

_RETRIES = 4
_NEARLY = 0.9


def solve(query: dict[str, Any]) -> dict[str, Any]:
    """Return status and path of one query, with the CPU time of the planner alone.

    Its clock is the wall's. Where other processes took so much of it that the planner gave up
    before its budget of CPU time was spent, it gets a longer one.
    """
    model = ArticulatedModel.create_from_urdf_string(
        _urdf(query), _srdf(query), [_fcl(name, parts) for name, parts in query["links"].items()]
    )
    model.set_base_pose(mplib.Pose())  # from a string it comes without one
    names = model.get_pinocchio_model().get_joint_names()
    model.set_move_group(query["tips"])
    order = [names[k] for k in model.get_move_group_joint_indices()]
    start_q = np.array([query["start"][n] for n in order])
    goal_q = np.array([query["goal"][n] for n in order])
    model.set_qpos(np.array([query["start"][n] for n in names]), full=True)
    world = PlanningWorld([model], [_fcl(name, parts) for name, parts in query["still"].items()])
    for link in query["standing"]:
        for body in query["still"]:
            world.get_allowed_collision_matrix().set_entry(link, body, True)  # noqa: FBT003
    hits = [found for q in (start_q, goal_q) if (found := _hits(world, model, q))]
    if hits:
        return {"status": f"an end is blocked: {hits}", "path": [], "spent_s": 0.0}
    model.set_qpos(start_q)
    fixed = {FixedJoint(0, k, v) for k, v in enumerate(start_q) if order[k] not in query["moves"]}
    wall_s = query["budget_s"]
    for _ in range(_RETRIES):
        mplib.set_global_seed(query["seed"] + 1)
        start = time.process_time()
        status, path = OMPLPlanner(world=world).plan(
            start_q, [goal_q], time=wall_s, fixed_joints=fixed, simplify=True
        )
        spent_s = time.process_time() - start
        if status == "Exact solution" or spent_s > _NEARLY * query["budget_s"]:
            break
        wall_s *= 1.1 * query["budget_s"] / spent_s
    columns = [order.index(n) for n in query["moves"]]
    rows = np.asarray(path)[:, columns].tolist() if status == "Exact solution" else []
    return {"status": status, "path": rows, "spent_s": spent_s}


def _hits(world: Any, model: Any, q: Any) -> list[tuple[str, str]]:  # noqa: ANN401 - mplib's
    model.set_qpos(q)
    return [(c.link_name1, c.link_name2) for c in world.check_collision()]


def _fcl(name: str, parts: list[dict[str, Any]]) -> Any:  # noqa: ANN401 - mplib's
    shapes = [fcl.CollisionObject(_shape(part)) for part in parts]
    return fcl.FCLObject(name, mplib.Pose(), shapes, [_pose(part["pose"]) for part in parts])


def _shape(part: dict[str, Any]) -> Any:  # noqa: ANN401 - mplib's
    if "box" in part:
        return fcl.Box(np.array(part["box"]))
    points = np.array(part["points"])
    hull = ConvexHull(points)
    corners = points[hull.vertices]
    number = {int(v): k for k, v in enumerate(hull.vertices)}
    faces = []
    for simplex, equation in zip(hull.simplices, hull.equations, strict=True):
        a, b, c = (points[k] for k in simplex)
        is_outward = np.cross(b - a, c - a) @ equation[:3] > 0.0
        row = [number[int(k)] for k in simplex]
        faces.append(row if is_outward else row[::-1])
    return fcl.Convex(corners, np.array(faces, dtype=np.int32))


def _pose(numbers: list[float]) -> Any:  # noqa: ANN401 - mplib's
    return mplib.Pose(np.array(numbers[:3]), np.array(numbers[3:]))


def _urdf(query: dict[str, Any]) -> str:
    links = "".join(
        f'<link name="{name}"><inertial><mass value="1"/>'
        '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
        for name in ["world", *query["links"]]
    )
    return f'<robot name="cell">{links}{"".join(map(_joint, query["joints"]))}</robot>'


def _joint(joint: dict[str, Any]) -> str:
    w, x, y, z = joint["pose"][3:]
    rpy = Rotation.from_quat((x, y, z, w)).as_euler("xyz")
    limit = axis = ""
    if joint["kind"] != "fixed":
        axis = f'<axis xyz="{_numbers(joint["axis"])}"/>'
        low, high = joint["limits"]
        limit = (
            f'<limit lower="{low!r}" upper="{high!r}" effort="1" velocity="{joint["speed"]!r}"/>'
        )
    return (
        f'<joint name="{joint["name"]}" type="{joint["kind"]}"><parent link="{joint["parent"]}"/>'
        f'<child link="{joint["child"]}"/>'
        f'<origin xyz="{_numbers(joint["pose"][:3])}" rpy="{_numbers(rpy)}"/>{axis}{limit}</joint>'
    )


def _numbers(values: Any) -> str:  # noqa: ANN401 - a list or an array
    return " ".join(repr(float(v)) for v in values)


def _srdf(query: dict[str, Any]) -> str:
    rows = "".join(
        f'<disable_collisions link1="{a}" link2="{b}" reason="Never"/>' for a, b in query["off"]
    )
    return f'<robot name="cell">{rows}</robot>'


def main() -> None:
    """Answer every line with a line; what OMPL prints goes to the error stream."""
    warnings.simplefilter("ignore")  # of angles that are not unique
    with os.fdopen(os.dup(1), "w") as answers:
        os.dup2(2, 1)
        for line in sys.stdin:
            answers.write(json.dumps(solve(json.loads(line))) + "\n")
            answers.flush()


if __name__ == "__main__":
    main()
