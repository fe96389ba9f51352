"""The MuJoCo text says what the model's values say."""

from __future__ import annotations

import math
import re

import mujoco
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sitewright.foundation.mjcf.model import (
    Axis,
    Freedom,
    Inertial,
    MjcfModel,
    Servo,
    Solid,
    Weld,
)
from sitewright.foundation.mjcf.text import mjcf_text
from sitewright.foundation.pose import Pose, from_axis_angle, translation
from sitewright.foundation.shapes import Box, Hull

CUBE = (Box((0.1, 0.1, 0.1)),)
TETRAHEDRON = Hull(((0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.1)))


def compiled(*solids: Solid, **more: object) -> mujoco.MjModel:
    model = MjcfModel(name="test", solids=solids, **more)  # type: ignore[arg-type]
    return mujoco.MjModel.from_xml_string(mjcf_text(model))


def free(name: str, pose: Pose = Pose()) -> Solid:  # noqa: B008 - a value
    axis = Axis(name=name, freedom=Freedom.FREE)
    return Solid(name=name, parent_T_body=pose, shape=CUBE, density_kg_m3=500.0, axis=axis)


def test_the_same_model_gives_the_same_text() -> None:
    model = MjcfModel(name="test", solids=(free("a"), Solid(name="b", shape=(TETRAHEDRON,))))
    assert mjcf_text(model) == mjcf_text(model)


def test_names_with_slashes_quotes_and_brackets_survive() -> None:
    m = compiled(free('robot/<link> "1" & 2'))
    assert m.body(1).name == 'robot/<link> "1" & 2'


def test_a_hull_that_two_bodies_share_is_written_once() -> None:
    text = mjcf_text(
        MjcfModel(
            name="test",
            solids=tuple(Solid(name=n, shape=(TETRAHEDRON,)) for n in ("a", "b")),
        )
    )
    assert len(re.findall("<mesh ", text)) == 1
    assert mujoco.MjModel.from_xml_string(text).ngeom == 2


def test_mass_comes_from_density_or_from_the_inertial() -> None:
    inertial = Inertial(mass_kg=7.0, com_m=(0, 0, 0.1), inertia_kg_m2=(1, 0, 0, 1, 0, 1))
    heavy = Solid(
        name="heavy",
        shape=CUBE,
        inertial=inertial,
        axis=Axis(name="h", freedom=Freedom.HINGE),
    )
    m = compiled(free("light"), heavy)
    assert m.body("light").mass == pytest.approx(0.5)
    assert m.body("heavy").mass == pytest.approx(7.0)


def test_inertia_is_written_in_the_order_that_mujoco_reads() -> None:
    inertial = Inertial(
        mass_kg=1.0, com_m=(0, 0, 0), inertia_kg_m2=(0.2, 0.01, 0.02, 0.3, 0.03, 0.4)
    )
    m = compiled(Solid(name="a", inertial=inertial, axis=Axis(name="a", freedom=Freedom.HINGE)))
    axes = np.zeros(9)
    mujoco.mju_quat2Mat(axes, m.body("a").iquat)
    turned = axes.reshape(3, 3) @ np.diag(m.body("a").inertia) @ axes.reshape(3, 3).T
    wanted = ((0.2, 0.01, 0.02), (0.01, 0.3, 0.03), (0.02, 0.03, 0.4))
    assert turned == pytest.approx(np.array(wanted))


@settings(max_examples=25, deadline=None)
@given(
    numbers=st.tuples(*[st.floats(-3, 3) for _ in range(6)]).filter(
        lambda n: math.hypot(*n[3:]) > 0.1
    ),
    angle=st.floats(-3, 3),
)
def test_a_body_stands_where_its_pose_says(numbers: tuple[float, ...], angle: float) -> None:
    x, y, z, *axis = numbers
    pose = Pose((x, y, z), from_axis_angle((axis[0], axis[1], axis[2]), angle))
    m = compiled(Solid(name="a", parent_T_body=pose, shape=CUBE))
    d = mujoco.MjData(m)
    mujoco.mj_forward(m, d)
    seen = Pose(tuple(d.body("a").xpos), tuple(d.body("a").xquat))
    assert seen.distance_to_m(pose) < 1e-12
    assert seen.angle_to_rad(pose) < 1e-7


def test_a_weld_holds_the_second_body_at_the_given_pose() -> None:
    offset = Pose((0.3, 0.0, 0.1), from_axis_angle((0, 0, 1), 0.5))
    weld = Weld(name="w", body="base", other="a", body_T_other=offset)
    m = compiled(Solid(name="base", shape=CUBE), free("a", offset), welds=(weld,))
    d = mujoco.MjData(m)
    for _ in range(500):
        mujoco.mj_step(m, d)
    seen = Pose(tuple(d.body("a").xpos), tuple(d.body("a").xquat))
    assert seen.distance_to_m(offset) < 1e-4
    assert seen.angle_to_rad(offset) < 1e-3


def test_excluded_bodies_do_not_collide_and_others_do() -> None:
    overlapping = (free("a"), free("b", translation(0.05, 0.0, 0.0)))
    for excluded, count in (((("a", "b"),), 0), ((), 1)):
        m = compiled(*overlapping, excluded=excluded)
        d = mujoco.MjData(m)
        mujoco.mj_forward(m, d)
        assert bool(d.ncon) is bool(count)


def test_a_servo_goes_to_its_target_and_keeps_its_force_limit() -> None:
    inertial = Inertial(mass_kg=2.0, com_m=(0, 0, 0), inertia_kg_m2=(1, 0, 0, 1, 0, 1))
    slide = Axis(name="s", freedom=Freedom.SLIDE, direction=(1, 0, 0), limits=(0.0, 0.5))
    m = compiled(
        Solid(name="finger", inertial=inertial, axis=slide, is_weightless=True),
        servos=(Servo(joint="s", stiffness=1e4, force_limit=100.0),),
    )
    d = mujoco.MjData(m)
    d.ctrl[0] = 0.2
    for _ in range(1000):
        mujoco.mj_step(m, d)
        assert abs(d.actuator_force[0]) <= 100.0 + 1e-9
    assert d.qpos[0] == pytest.approx(0.2, abs=1e-4)
