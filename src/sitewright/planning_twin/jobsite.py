"""Builds the collision scene of the cell from what was sensed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.foundation.ids import BodyId, ComponentId, EndEffectorId, RobotId, StationId
from sitewright.foundation.pose import Pose, Vector, translation
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.scene import Attachment, Body, RobotInScene, SceneSnapshot
from sitewright.robot_team.cell import Cell, EndEffector, EndEffectorKind
from sitewright.robot_team.description import Joints
from sitewright.robot_team.gripper import finger_parts, palm_shape


@dataclass(frozen=True, slots=True, kw_only=True)
class PieceShape:
    """A piece of material, or an installed component, as a body.

    Attributes:
        shape: Convex pieces in the component frame.
        size_m: Box of the component in its own frame; x is its length.
    """

    shape: Shape
    size_m: Vector
    mass_kg: float


@dataclass(frozen=True, slots=True, kw_only=True)
class ArmState:
    """One robot as sensed.

    Attributes:
        tip_T_held: Pose of the held piece in the robot's tip frame, if it holds one.
    """

    q_rad: Joints
    mounted: EndEffectorId | None
    aperture_m: float = 0.0
    held: ComponentId | None = None
    tip_T_held: Pose = field(default_factory=Pose)


@dataclass(frozen=True, slots=True, kw_only=True)
class Jobsite:
    """Everything that has a place in the cell at one moment.

    Attributes:
        pieces: Shapes of all pieces and installed components that are on the site.
        world_T_piece: Sensed pose of each of them.
        obstacles: Components on the layer Virtual Collision, with their world poses.
        steadied: Pieces that stand at their target while a robot still holds them: they do not
            move with the robot, since it does not move.
    """

    cell: Cell
    pieces: Mapping[ComponentId, PieceShape]
    world_T_piece: Mapping[ComponentId, Pose]
    arms: Mapping[RobotId, ArmState]
    docked: Mapping[EndEffectorId, StationId] = field(default_factory=dict)
    obstacles: Mapping[ComponentId, tuple[Shape, Pose]] = field(default_factory=dict)
    steadied: Mapping[ComponentId, RobotId] = field(default_factory=dict)


def scene_of(site: Jobsite) -> SceneSnapshot:
    """Return the scene with all materials, installed components, zones, tools and robots."""
    cell = site.cell
    robots = {
        robot.id: RobotInScene(
            description=robot.description,
            world_T_base=robot.world_T_base,
            q_rad=site.arms[robot.id].q_rad,
        )
        for robot in cell.robot_by_id.values()
    }
    bodies = [*_fixed_bodies(site), *_docked_bodies(site), *_piece_bodies(site)]
    for robot_id, arm in site.arms.items():
        if arm.mounted is not None:
            tool = cell.end_effector_by_id[arm.mounted]
            bodies += end_effector_bodies(tool, Attachment(robot_id, Pose()), arm.aperture_m)
    return SceneSnapshot(
        robots=robots, bodies={b.id: b for b in bodies}, clearance_m=cell.clearance_m
    )


def end_effector_bodies(
    tool: EndEffector, placement: Pose | Attachment, aperture_m: float
) -> list[Body]:
    """Return an end effector as bodies: itself and, for a gripper, each finger.

    Args:
        tool: The end effector.
        placement: World pose of its mount, or the robot whose tip carries it.
        aperture_m: Opening between the fingers.
    """
    bodies = [
        Body(id=BodyId(tool.id), shape=palm_shape(tool.description), placement=placement)
    ]
    if tool.kind is EndEffectorKind.GRIPPER:
        bodies += [
            Body(id=finger_body(tool.id, name), shape=shape, placement=placement)
            for name, shape in finger_parts(tool.description, aperture_m).items()
        ]
    return bodies


def finger_body(tool: EndEffectorId, finger: str) -> BodyId:
    """Return the body id of a gripper's finger."""
    return BodyId(f"{tool}/{finger}")


def bodies_of_tool(tool: EndEffector) -> tuple[BodyId, ...]:
    """Return the body ids of an end effector, fingers included."""
    return tuple(b.id for b in end_effector_bodies(tool, Pose(), 0.0))


def with_aperture(scene: SceneSnapshot, tool: EndEffector, aperture_m: float) -> SceneSnapshot:
    """Return the scene with a mounted gripper opened or closed."""
    placement = scene.bodies[BodyId(tool.id)].placement
    for body in end_effector_bodies(tool, placement, aperture_m):
        scene = scene.with_body(body)
    return scene


def world_T_dock(cell: Cell, tool: EndEffector) -> Pose:
    """Return the world pose of an end effector's mount when it is docked."""
    if tool.station is None:
        raise ValueError(f"end effector {tool.id!r} has no tool station")
    return cell.station_by_id[tool.station].world_T_station @ tool.station_T_mount


def _fixed_bodies(site: Jobsite) -> list[Body]:
    cell = site.cell
    fixtures = [
        Body(id=BodyId(f.id), shape=f.shape, placement=f.world_T_fixture)
        for f in cell.fixture_by_id.values()
    ]
    zones = [
        Body(id=BodyId(z.id), shape=z.shape, placement=z.world_T_zone)
        for z in cell.zone_by_id.values()
    ]
    obstacles = [
        Body(id=BodyId(i), shape=shape, placement=pose)
        for i, (shape, pose) in site.obstacles.items()
    ]
    return fixtures + zones + obstacles


def _docked_bodies(site: Jobsite) -> list[Body]:
    tools = [site.cell.end_effector_by_id[i] for i in site.docked]
    return [b for t in tools for b in end_effector_bodies(t, world_T_dock(site.cell, t), 0.0)]


def _piece_bodies(site: Jobsite) -> list[Body]:
    held = {
        arm.held: Attachment(robot, arm.tip_T_held)
        for robot, arm in site.arms.items()
        if arm.held is not None and arm.held not in site.steadied
    }
    return [
        Body(
            id=BodyId(piece),
            shape=site.pieces[piece].shape,
            placement=held.get(piece, world_T_piece),
        )
        for piece, world_T_piece in site.world_T_piece.items()
    ]


def lifted(pose: Pose, direction: Vector, distance_m: float) -> Pose:
    """Return a world pose shifted along a world direction."""
    x, y, z = (c * distance_m for c in direction)
    return translation(x, y, z) @ pose
