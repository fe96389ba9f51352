"""Builds the collision scene of the cell from what was sensed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from sitewright.foundation.ids import BodyId, ComponentId, EndEffectorId, RobotId, StationId
from sitewright.foundation.pose import Pose, Vector, translation
from sitewright.foundation.shapes import Shape
from sitewright.planning_twin.fastening import Spot
from sitewright.planning_twin.scene import Attachment, Body, RobotInScene, SceneSnapshot
from sitewright.robot_team.cell import Cell, EndEffector, EndEffectorKind, Robot
from sitewright.robot_team.description import Joints
from sitewright.robot_team.gripper import finger_shapes, mount_T_fingers, palm_shape

_SAME_DIAMETER_M = 0.00005


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
    _scene: SceneSnapshot | None = field(default=None, init=False, repr=False, compare=False)


def scene_of(site: Jobsite) -> SceneSnapshot:
    """Return the scene with all materials, installed components, zones, tools and robots.

    A site never changes, so the scene is made once: engines know it again by its identity.
    """
    scene = site._scene  # noqa: SLF001 - remembered on the site itself
    if scene is None:
        scene = _made_scene(site)
        object.__setattr__(site, "_scene", scene)
    return scene


def _made_scene(site: Jobsite) -> SceneSnapshot:
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
    bodies = [Body(id=BodyId(tool.id), shape=palm_shape(tool.description), placement=placement)]
    if tool.kind is EndEffectorKind.GRIPPER:
        within = min(max(aperture_m, 0.0), tool.opens_to_m)
        shapes = finger_shapes(tool.description)
        bodies += [
            Body(
                id=finger_body(tool.id, name), shape=shapes[name], placement=_shifted(placement, at)
            )
            for name, at in mount_T_fingers(tool.description, within).items()
        ]
    return bodies


def _shifted(placement: Pose | Attachment, mount_T_body: Pose) -> Pose | Attachment:
    if isinstance(placement, Attachment):
        return Attachment(placement.robot, placement.tip_T_body @ mount_T_body)
    return placement @ mount_T_body


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


def with_tool(site: Jobsite, robot: RobotId, tool: EndEffector) -> Jobsite:
    """Return the site as it is when a robot has changed to an end effector."""
    arm = site.arms[robot]
    if arm.mounted == tool.id:
        return site
    docked = {i: s for i, s in site.docked.items() if i != tool.id}
    if arm.mounted is not None and (old := site.cell.end_effector_by_id[arm.mounted]).station:
        docked[old.id] = old.station
    changed = replace(arm, mounted=tool.id, aperture_m=0.0)
    return replace(site, arms={**site.arms, robot: changed}, docked=docked)


def tool_for(site: Jobsite, robot: Robot, spot: Spot) -> EndEffector | None:
    """Return the tool with which a robot does an operation: the mounted one if it fits."""
    mounted = site.arms[robot.id].mounted
    order = sorted(robot.end_effectors, key=lambda i: (i != mounted, i))
    for tool_id in order:
        tool = site.cell.end_effector_by_id[tool_id]
        if tool_id != mounted and tool_id not in site.docked:
            continue
        if spot.process in tool.processes and drives(tool, spot):
            return tool
    return None


def drives(tool: EndEffector, spot: Spot) -> bool:
    """Tell whether a fastener is in a tool's range; a finish needs none."""
    fastener = spot.fastener
    return fastener is None or any(
        r.type == fastener.type
        and abs(r.d_m - fastener.d_m) < _SAME_DIAMETER_M
        and r.l_min_m <= fastener.l_m <= r.l_max_m
        for r in tool.fasteners
    )


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
