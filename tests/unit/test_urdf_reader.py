"""The URDF reader: what is read, and what is refused with which words."""

from __future__ import annotations

import math
import os
import struct
from pathlib import Path

import numpy as np
import pytest

from sitewright.errors import CellRejectedError
from sitewright.foundation.shapes import Box, Hull
from sitewright.robot_team.description import Description, JointKind
from sitewright.robot_team.formats.hulls import hull_facets
from sitewright.robot_team.formats.mesh_points import read_points
from sitewright.robot_team.formats.urdf import read_urdf

TETRAHEDRON = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
TRIANGLES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
BOX = '<collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision>'
LIMIT = '<limit lower="-1" upper="1" velocity="2" effort="3"/>'


def arm(
    *,
    base: str = BOX,
    joint_type: str = "revolute",
    joint: str = LIMIT,
    child: str = "hand",
    extra: str = "",
    hand: str = "",
) -> str:
    return f"""<robot name="small-arm">
      <link name="base">{base}</link><link name="hand">{hand}</link>
      <joint name="j1" type="{joint_type}">
        <parent link="base"/><child link="{child}"/>{joint}
      </joint>{extra}
    </robot>"""


def read(folder: Path, text: str, **options: str) -> Description:
    file = folder / "arm.urdf"
    file.write_text(text, encoding="utf-8")
    return read_urdf(file, root=options.get("root"), tip=options.get("tip"))


def refusal(folder: Path, text: str, **options: str) -> str:
    with pytest.raises(CellRejectedError) as caught:
        read(folder, text, **options)
    return str(caught.value)


def write_binary_stl(path: Path, *, cut_off: int = 0) -> None:
    data = bytes(80) + struct.pack("<I", len(TRIANGLES))
    for triangle in TRIANGLES:
        corners = [x for k in triangle for x in TETRAHEDRON[k]]
        data += struct.pack("<12fH", 0.0, 0.0, 0.0, *corners, 0)
    path.write_bytes(data[: len(data) - cut_off])


def write_ascii_stl(path: Path) -> None:
    facets = [
        "facet normal 0 0 0\nouter loop\n"
        + "".join("vertex {} {} {}\n".format(*TETRAHEDRON[k]) for k in triangle)
        + "endloop\nendfacet\n"
        for triangle in TRIANGLES
    ]
    path.write_text(f"solid t\n{''.join(facets)}endsolid t\n", encoding="utf-8")


def write_obj(path: Path) -> None:
    lines = ["v {} {} {}".format(*p) for p in TETRAHEDRON] + ["vn 0 0 1", "f 1 3 2"]
    path.write_text("\n".join(lines), encoding="utf-8")


def mesh(name: str, scale: str = "") -> str:
    return f'<collision><geometry><mesh filename="{name}" {scale}/></geometry></collision>'


def test_a_small_arm_is_read_with_its_tree_and_limits(tmp_path: Path) -> None:
    description = read(tmp_path, arm())
    (joint,) = description.joints
    assert (description.name, description.root, description.tip) == ("small-arm", "base", "hand")
    assert joint.kind is JointKind.REVOLUTE
    assert (joint.lower_rad, joint.upper_rad, joint.velocity_rad_s) == (-1.0, 1.0, 2.0)
    assert joint.axis == (1.0, 0.0, 0.0)
    assert description.links[0].shape == (Box((0.1, 0.2, 0.3)),)
    assert description.urdf == str((tmp_path / "arm.urdf").resolve())


def test_origins_turn_and_shift_shapes_and_axes_become_unit_vectors(tmp_path: Path) -> None:
    turned = BOX.replace(
        "<collision>", '<collision><origin xyz="1 0 0" rpy="0 0 1.5707963267948966"/>'
    )
    description = read(tmp_path, arm(base=turned, joint=LIMIT + '<axis xyz="0 0 5"/>'))
    (box,) = description.links[0].shape
    assert max(v[0] for v in box.vertices_m()) == pytest.approx(1.1)
    assert max(v[1] for v in box.vertices_m()) == pytest.approx(0.05)
    assert description.joints[0].axis == (0.0, 0.0, 1.0)


def test_a_cylinder_becomes_a_prism_that_holds_it_all(tmp_path: Path) -> None:
    cylinder = '<collision><geometry><cylinder radius="0.1" length="1"/></geometry></collision>'
    (prism,) = read(tmp_path, arm(base=cylinder)).links[0].shape
    assert isinstance(prism, Hull)
    angles = np.linspace(0.0, 2.0 * math.pi, 200)
    rim = np.stack([0.1 * np.cos(angles), 0.1 * np.sin(angles), np.full(200, 0.5)], axis=1)
    facets = hull_facets(np.array(prism.points_m))
    assert facets.excess_m(rim).max() <= 1e-12
    assert facets.volume_m3() <= 1.02 * math.pi * 0.01


@pytest.mark.parametrize(
    ("name", "write"),
    [("t.stl", write_binary_stl), ("u.STL", write_ascii_stl), ("v.obj", write_obj)],
)
def test_every_mesh_format_gives_the_same_points(tmp_path: Path, name: str, write: object) -> None:
    assert callable(write)
    write(tmp_path / name)
    assert sorted(map(tuple, read_points(tmp_path / name).tolist())) == sorted(TETRAHEDRON)


def test_a_mesh_is_scaled(tmp_path: Path) -> None:
    write_obj(tmp_path / "t.obj")
    (hull,) = read(tmp_path, arm(base=mesh("t.obj", 'scale="1 1 0.001"'))).links[0].shape
    assert max(v[2] for v in hull.vertices_m()) == pytest.approx(0.001)


def test_a_package_is_looked_for_upwards_from_the_file(tmp_path: Path) -> None:
    urdf, meshes = tmp_path / "my_support" / "urdf", tmp_path / "my_support" / "meshes"
    urdf.mkdir(parents=True)
    meshes.mkdir()
    write_binary_stl(meshes / "t.stl")
    description = read(urdf, arm(base=mesh("package://my_support/meshes/t.stl")))
    assert len(description.links[0].shape) == 1


def test_an_inertia_is_turned_into_the_link_frame(tmp_path: Path) -> None:
    inertial = (
        '<inertial><origin xyz="0 0 1" rpy="1.5707963267948966 0 0"/><mass value="2"/>'
        '<inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5"/></inertial>'
    )
    link = read(tmp_path, arm(base=BOX + inertial)).links[0]
    assert (link.mass_kg, link.com_m) == (2.0, (0.0, 0.0, 1.0))
    assert link.inertia_kg_m2 == pytest.approx((1.0, 0.0, 0.0, 2.5, 0.0, 2.0))


def test_the_payload_stands_in_the_file_or_is_given(tmp_path: Path) -> None:
    file = tmp_path / "arm.urdf"
    file.write_text(arm(extra='<sitewright payload_kg="12.5"/>'), encoding="utf-8")
    assert read_urdf(file).payload_kg == 12.5
    assert read_urdf(file, payload_kg=3.0).payload_kg == 3.0


def test_only_what_hangs_below_a_given_root_is_read(tmp_path: Path) -> None:
    extra = (
        '<link name="world"/><joint name="w" type="fixed"><parent link="world"/>'
        '<child link="base"/></joint>'
    )
    description = read(tmp_path, arm(extra=extra), root="base")
    assert {link.name for link in description.links} == {"base", "hand"}
    assert [joint.name for joint in description.joints] == ["j1"]


def test_joints_are_ordered_from_the_root_outwards(tmp_path: Path) -> None:
    extra = (
        '<link name="tool0"/><link name="wrist"/>'
        '<joint name="j3" type="fixed"><parent link="wrist"/><child link="tool0"/></joint>'
        '<joint name="j2" type="prismatic"><parent link="hand"/><child link="wrist"/>'
        f"{LIMIT}</joint>"
    )
    description = read(tmp_path, arm(extra=extra))
    assert [j.name for j in description.joints] == ["j1", "j2", "j3"]
    assert [j.name for j in description.movable_joints] == ["j1", "j2"]
    assert description.tip == "tool0"


def test_all_faults_of_a_file_are_told_at_once(tmp_path: Path) -> None:
    text = arm(base=BOX.replace("0.2", "nan"), joint="", child="hnad", hand="<visual/>")
    message = refusal(tmp_path, text)
    assert "not 3 finite number(s)" in message
    assert "moves but has no limits" in message
    assert "'hnad' is no link" in message
    assert "Did you mean hand?" in message
    assert "has no collision shape" in message


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (arm(joint_type="continuous"), "Make it revolute with the limits that its cables allow"),
        (arm(joint_type="floating"), "Joint type 'floating' is not supported"),
        (arm(joint=LIMIT + '<mimic joint="j0"/>'), "follows another joint"),
        (arm(joint='<limit lower="1" upper="-1" velocity="1"/>'), "cannot move between 1.0 and"),
        (arm(joint='<limit lower="0" upper="1" velocity="0"/>'), "speed limit is not positive"),
        (arm(joint='<limit lower="0" upper="1"/>'), "no attribute 'velocity'"),
        (arm(joint=LIMIT + '<axis xyz="0 0 0"/>'), "axis is zero"),
        (arm(joint=LIMIT + '<axis xyz="0 0"/>'), "not 3 finite number(s)"),
        (arm(child=""), "names no child link"),
        (arm(child="base"), "part of a loop"),
        (arm(extra='<link name="hand"/>'), "2 links have this name"),
        (arm(extra="<link/>"), "1 link(s) have no name"),
        (arm(extra='<link name="loose"/>'), "2 links are nobody's child: base, loose"),
        (
            arm(
                extra='<joint name="j2" type="fixed"><parent link="base"/>'
                '<child link="hand"/></joint>'
            ),
            "child of 2 joints: j1, j2",
        ),
        (arm(base=BOX.replace("0.1", "-0.1")), "box has no volume"),
        (arm(base="<collision/>"), "without a shape"),
        (arm(base=BOX.replace("box", "sphere")), "Collision geometry sphere is not read"),
        (arm(base=mesh("none.obj")), "Mesh 'none.obj' is not there"),
        (arm(base=mesh("package://none/a.stl")), "is not there"),
        (arm(extra='<sitewright payload_kg="-1"/>'), "payload_kg is negative"),
        (arm(base='<inertial><mass value="-2"/></inertial>'), "mass is -2.0 kg"),
        (
            arm(base='<inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="9"/></inertial>'),
            "No body can have its inertia",
        ),
        ('<robot name="empty"/>', "has no links"),
        ('<sdf version="1.9"/>', "outermost element is <sdf>"),
        ("<robot><link", "not usable XML"),
        ('<!DOCTYPE r [<!ENTITY a "b">]><robot name="&a;"/>', "DOCTYPE is not allowed"),
    ],
)
def test_a_faulty_file_is_refused_with_its_reason(tmp_path: Path, text: str, words: str) -> None:
    message = refusal(tmp_path, text)
    assert words in message
    assert "arm.urdf" in message


def test_a_loop_without_a_root_is_refused(tmp_path: Path) -> None:
    back = '<joint name="j2" type="fixed"><parent link="hand"/><child link="base"/></joint>'
    assert "part of a loop" in refusal(tmp_path, arm(extra=back))


def test_unknown_roots_and_tips_are_refused_with_a_hint(tmp_path: Path) -> None:
    assert "no link 'bse'. Name one of its links. Did you mean base?" in refusal(
        tmp_path, arm(), root="bse"
    )
    assert "no link 'hnd' below the root" in refusal(tmp_path, arm(), tip="hnd")


def test_of_several_ends_the_tip_must_be_named(tmp_path: Path) -> None:
    extra = (
        '<link name="camera"/><joint name="c" type="fixed"><parent link="base"/>'
        '<child link="camera"/></joint>'
    )
    assert "tip may be any of camera, hand" in refusal(tmp_path, arm(extra=extra))
    assert read(tmp_path, arm(extra=extra), tip="hand").tip == "hand"


def test_a_missing_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CellRejectedError, match="cannot be read: No such file"):
        read_urdf(tmp_path / "none.urdf")


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.dae", b"<COLLADA/>", "meshes of type .dae are not read"),
        ("a.obj", b"# nothing", "has no points"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n", "lie in one plane"),
        ("a.obj", b"v 0 0\n", "fewer than three numbers"),
        ("a.obj", b"v 0 0 zero\n", "could not convert"),
        ("a.obj", b"v 0 0 inf\n", "not finite"),
        ("a.stl", b"version https://git-lfs.github.com/spec/v1\n", "cut off, or no .stl"),
    ],
)
def test_a_mesh_that_cannot_be_used_is_refused(
    tmp_path: Path, name: str, content: bytes, words: str
) -> None:
    (tmp_path / name).write_bytes(content)
    assert words in refusal(tmp_path, arm(base=mesh(name)))


def test_a_binary_stl_that_is_cut_off_is_refused(tmp_path: Path) -> None:
    write_binary_stl(tmp_path / "t.stl", cut_off=20)
    assert "cut off" in refusal(tmp_path, arm(base=mesh("t.stl")))


@pytest.mark.skipif(
    "SITEWRIGHT_DATA" not in os.environ, reason="SITEWRIGHT_DATA names no folder of shared data"
)
def test_a_users_arm_gets_hulls_of_few_vertices_around_its_meshes(tmp_path: Path) -> None:
    folder = Path(os.environ["SITEWRIGHT_DATA"]) / "kuka_kr120"
    text = (folder / "kr120r2500pro.urdf").read_text(encoding="utf-8")
    prefix = "package://kuka_kr120_support/meshes/kr120r2500pro"
    description = read(tmp_path, text.replace(prefix, str(folder)))
    assert description.tip == "tool0"
    for link in description.links[:7]:
        (hull,) = link.shape
        points = read_points(folder / "collision" / f"{link.name}.stl")
        facets = hull_facets(np.array(hull.vertices_m()))
        assert facets.excess_m(points).max() <= 1e-9
        assert facets.volume_m3() <= 1.25 * hull_facets(points).volume_m3()
        assert len(hull.vertices_m()) <= 150
