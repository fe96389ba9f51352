"""Turns the cell, its pieces and what holds what into a MuJoCo model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import chain, repeat

from sitewright.foundation.ids import ComponentId, EndEffectorId, RobotId
from sitewright.foundation.mjcf.model import (
    Axis,
    Freedom,
    Inertial,
    MjcfModel,
    Servo,
    Solid,
    Weld,
)
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.robot_team.cell import Cell, EndEffector, Robot
from sitewright.robot_team.description import Description, Joint, JointKind, Link
from sitewright.robot_team.drivers.mujoco.fixings import Fixings
from sitewright.robot_team.piece import Piece

ARM_STIFFNESS = (3e5, 3e5, 2e5, 4e4, 4e4, 2e4)
"""Of the drives of turning joints from the base to the wrist, N m/rad; further ones as the last."""
RAIL_STIFFNESS_N_M = 5e6
FINGER_STIFFNESS_N_M = 2e5
FINGER_FORCE_N = 1500.0
_PAD_FRICTION = 1.0
_WOOD_FRICTION = 0.6


@dataclass(frozen=True, slots=True, kw_only=True)
class Contents:
    """What does not change while a cell runs.

    Attributes:
        density_kg_m3: Of each piece, so that shape and mass agree.
    """

    cell: Cell
    pieces: Mapping[ComponentId, Piece]
    density_kg_m3: Mapping[ComponentId, float]


def link_body(robot: RobotId, link: str) -> str:
    """Return the name of a robot's link, as everywhere in pairs."""
    return f"{robot}/{link}"


def joint_name(owner: str, joint: str) -> str:
    """Return the name of a joint of a robot or an end effector."""
    return f"{owner}:{joint}"


def finger_joints(tool: EndEffector) -> tuple[Joint, ...]:
    """Return the prismatic joints of a gripper."""
    return tuple(j for j in tool.description.joints if j.kind is JointKind.PRISMATIC)


def tool_body(tool: EndEffector, link: str) -> str:
    """Return the name of an end effector's link: the mount has the tool's own name."""
    if link == tool.description.root:
        return tool.id
    finger = next((j.name for j in finger_joints(tool) if j.child == link), None)
    return f"{tool.id}/{link if finger is None else finger.removeprefix('finger_')}"


def tool_bodies(tool: EndEffector) -> tuple[str, ...]:
    """Return the names of all bodies of an end effector."""
    return tuple(tool_body(tool, link.name) for link in tool.description.links)


def pad_bodies(tool: EndEffector) -> tuple[str, ...]:
    """Return the names of a gripper's fingers."""
    return tuple(tool_body(tool, j.child) for j in finger_joints(tool))


def model_of(
    contents: Contents, fixings: Fixings, blind_pairs: Iterable[tuple[str, str]]
) -> MjcfModel:
    """Return the simulation of the whole cell.

    Args:
        contents: The cell and its pieces.
        fixings: What is fixed to what at present.
        blind_pairs: Bodies of one robot that touch in every posture; they never collide.
    """
    cell = contents.cell
    tools = {
        i: cell.end_effector_by_id[i] for i in (*fixings.mounted.values(), *fixings.world_T_docked)
    }
    solids = [
        *(_fixture(f.id, f.shape, f.world_T_fixture) for f in cell.fixture_by_id.values()),
        *(_tool(tools[i], pose) for i, pose in fixings.world_T_docked.items()),
        *(_robot(r, _mounted(tools, fixings, r)) for r in cell.robot_by_id.values()),
        *(_piece(p, contents.density_kg_m3[p.id]) for p in contents.pieces.values()),
    ]
    fingers = [
        (joint_name(t.id, a.name), joint_name(t.id, b.name))
        for t in tools.values()
        if len(finger_joints(t)) > 1
        for a, b in [finger_joints(t)[:2]]
    ]
    return MjcfModel(
        name="cell",
        solids=tuple(solids),
        servos=tuple(_servos(cell, tools.values())),
        welds=tuple(_welds(fixings)),
        excluded=tuple(
            sorted({*blind_pairs, *_neighbours(cell, tools.values()), *_joined(fixings)})
        ),
        coupled=tuple(fingers),
    )


def robot_alone(robot: Robot, tool: EndEffector | None) -> MjcfModel:
    """Return one robot with its tool and nothing else, to find which bodies always touch."""
    tools = [] if tool is None else [tool]
    cell = Cell(robot_by_id={robot.id: robot}, end_effector_by_id={})
    return MjcfModel(
        name=robot.id,
        solids=(_robot(robot, tool),),
        excluded=tuple(sorted(set(_neighbours(cell, tools)))),
    )


def _mounted(
    tools: Mapping[EndEffectorId, EndEffector], fixings: Fixings, robot: Robot
) -> EndEffector | None:
    tool = fixings.mounted.get(robot.id)
    return None if tool is None else tools[tool]


def _fixture(name: str, shape: Shape, pose: Pose) -> Solid:
    return Solid(name=name, parent_T_body=pose, shape=shape, friction=_WOOD_FRICTION)


def _piece(piece: Piece, density_kg_m3: float) -> Solid:
    return Solid(
        name=piece.id,
        parent_T_body=piece.world_T_piece,
        shape=piece.shape,
        density_kg_m3=density_kg_m3,
        axis=Axis(name=piece.id, freedom=Freedom.FREE),
        friction=_WOOD_FRICTION,
    )


def _robot(robot: Robot, tool: EndEffector | None) -> Solid:
    hung = {} if tool is None else {robot.description.tip: _tool(tool, Pose())}
    return _tree(
        robot.description,
        robot.description.root,
        owner=robot.id,
        names={link.name: link_body(robot.id, link.name) for link in robot.description.links},
        pose=robot.world_T_base,
        hung=hung,
    )


def _tool(tool: EndEffector, pose: Pose) -> Solid:
    names = {link.name: tool_body(tool, link.name) for link in tool.description.links}
    tree = _tree(
        tool.description, tool.description.root, owner=tool.id, names=names, pose=pose, hung={}
    )
    return _with_pads(tree, frozenset(pad_bodies(tool)))


def _with_pads(solid: Solid, pads: frozenset[str]) -> Solid:
    """Return the bodies of an end effector with pads that do not slip."""
    return replace(
        solid,
        friction=_PAD_FRICTION if solid.name in pads else solid.friction,
        children=tuple(_with_pads(child, pads) for child in solid.children),
    )


def _tree(  # noqa: PLR0913 - a link, its names, its place and what hangs on it
    description: Description,
    root: str,
    *,
    owner: str,
    names: Mapping[str, str],
    pose: Pose,
    hung: Mapping[str, Solid],
    joint: Joint | None = None,
) -> Solid:
    link = next(part for part in description.links if part.name == root)
    children = tuple(
        _tree(
            description,
            below.child,
            owner=owner,
            names=names,
            pose=below.parent_T_joint,
            hung=hung,
            joint=below,
        )
        for below in description.joints
        if below.parent == root
    )
    solid = Solid(
        name=names[root],
        parent_T_body=pose,
        shape=link.shape,
        inertial=_inertial(link),
        axis=_axis(owner, joint),
        is_weightless=True,
        friction=_WOOD_FRICTION,
        children=children,
    )
    return replace(solid, children=(*children, hung[root])) if root in hung else solid


def _inertial(link: Link) -> Inertial | None:
    if link.mass_kg == 0.0:
        return None
    return Inertial(mass_kg=link.mass_kg, com_m=link.com_m, inertia_kg_m2=link.inertia_kg_m2)


def _axis(owner: str, joint: Joint | None) -> Axis | None:
    if joint is None or joint.kind is JointKind.FIXED:
        return None
    freedom = Freedom.SLIDE if joint.kind is JointKind.PRISMATIC else Freedom.HINGE
    return Axis(
        name=joint_name(owner, joint.name),
        freedom=freedom,
        direction=joint.axis,
        limits=(joint.lower_rad, joint.upper_rad),
    )


def _servos(cell: Cell, tools: Iterable[EndEffector]) -> Iterable[Servo]:
    for robot in cell.robot_by_id.values():
        turning = chain(ARM_STIFFNESS, repeat(ARM_STIFFNESS[-1]))
        for joint in robot.description.movable_joints:
            is_rail = joint.kind is JointKind.PRISMATIC
            yield Servo(
                joint=joint_name(robot.id, joint.name),
                stiffness=RAIL_STIFFNESS_N_M if is_rail else next(turning),
            )
    for tool in tools:
        for joint in finger_joints(tool):
            yield Servo(
                joint=joint_name(tool.id, joint.name),
                stiffness=FINGER_STIFFNESS_N_M,
                force_limit=FINGER_FORCE_N,
            )


def _welds(fixings: Fixings) -> Iterable[Weld]:
    for robot, grip in fixings.grips.items():
        yield Weld(
            name=f"grip {robot}",
            body=fixings.mounted[robot],
            other=grip.piece,
            body_T_other=grip.tool_T_piece,
        )
    for number, joined in enumerate(fixings.connections):
        yield Weld(
            name=f"connection {number}",
            body=joined.into,
            other=joined.through,
            body_T_other=joined.through_T_into.inverse(),
        )


def _neighbours(cell: Cell, tools: Iterable[EndEffector]) -> Iterable[tuple[str, str]]:
    """Links that a joint connects, and all of one end effector among themselves."""
    for robot in cell.robot_by_id.values():
        for joint in robot.description.joints:
            yield _pair(link_body(robot.id, joint.parent), link_body(robot.id, joint.child))
    for tool in tools:
        names = tool_bodies(tool)
        yield from (_pair(a, b) for k, a in enumerate(names) for b in names[:k])


def _joined(fixings: Fixings) -> Iterable[tuple[str, str]]:
    """Nailed pieces are pressed together by the nail, not by contact forces."""
    return (_pair(c.through, c.into) for c in fixings.connections)


def _pair(a: str, b: str) -> tuple[str, str]:
    return (a, b) if a <= b else (b, a)
