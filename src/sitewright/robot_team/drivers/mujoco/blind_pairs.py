"""Finds the bodies of one robot that touch in every posture and so say nothing by touching."""

from __future__ import annotations

import mujoco
import numpy as np

from sitewright.foundation.mjcf.text import mjcf_text
from sitewright.robot_team.cell import EndEffector, Robot
from sitewright.robot_team.drivers.mujoco.scene import robot_alone

_POSTURES = 300
_SEED = 20260


def blind_pairs(robot: Robot, tool: EndEffector | None) -> frozenset[tuple[str, str]]:
    """Return the pairs in contact in all of many seeded random postures of a robot alone."""
    m = mujoco.MjModel.from_xml_string(mjcf_text(robot_alone(robot, tool)))
    d = mujoco.MjData(m)
    low, high = m.jnt_range.T  # turning joints, rails, fingers: all have limits
    random = np.random.default_rng(_SEED)
    found: set[tuple[int, int]] | None = None
    for _ in range(_POSTURES):
        d.qpos[m.jnt_qposadr] = random.uniform(low, high)
        mujoco.mj_kinematics(m, d)
        mujoco.mj_comPos(m, d)
        mujoco.mj_collision(m, d)
        pairs = np.sort(m.geom_bodyid[d.contact.geom], axis=1).tolist() if d.ncon else []
        touching = {(a, b) for a, b in pairs}
        found = touching if found is None else found & touching
        if not found:
            break
    names = [(m.body(a).name, m.body(b).name) for a, b in found or ()]
    return frozenset((min(pair), max(pair)) for pair in names)
