"""Where a tool tip may stand to drive a fastener: tilts about the operation's axis."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

from sitewright.building_model.component import FastenerSpec, Process, SurfacePatch
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.foundation.pose import Pose, Vector, add, rotation, scale
from sitewright.robot_team.cell import EndEffector
from sitewright.robot_team.gripper import mount_T_tcp

_TILTS_DEG = (0.0, 2.5, 5.0, 10.0)
_DIRECTIONS = 8
_YAWS_DEG = (0.0, 90.0, 180.0, 270.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Spot:
    """One operation of a target, placed in the world.

    Attributes:
        world_T_operation: z is the driving direction, or points into the painted face.
        through: What stands already and the fastener enters first, to end in the target's own
            piece; None if it enters that one first.
        into: What a fastener through the target's own piece ends in; None for a finish.
    """

    operation: OperationId
    process: Process
    target: ComponentId
    world_T_operation: Pose
    through: ComponentId | None = None
    into: ComponentId | None = None
    fastener: FastenerSpec | None = None
    patch: SurfacePatch | None = None
    needs_hold: bool = False
    after: tuple[OperationId, ...] = field(default=())

    def body(self, piece: ComponentId) -> ComponentId:
        """Return what the tool's tip stands on, given the piece at the target."""
        return piece if self.through is None else self.through

    def receiver(self, piece: ComponentId) -> ComponentId | None:
        """Return what a fastener ends in, given the piece at the target; None for a finish."""
        return self.into if self.through is None else piece


@dataclass(frozen=True, slots=True, kw_only=True)
class ToolPose:
    """A tip pose for a tool in contact with its spot."""

    world_T_tip: Pose
    back_off: Vector
    label: str


def tool_poses(spot: Spot, tool: EndEffector, *, has_yaw: bool = True) -> Iterator[ToolPose]:
    """Yield tool poses for a fastener, upright first, then leaning up to the tool's limit.

    A leaning flat tip stands off by its half width times the sine of the tilt, so that its
    edge touches and does not enter the wood.
    """
    tcp_T_tip = mount_T_tcp(tool.description).inverse()
    for tilt_deg in _TILTS_DEG:
        tilt = math.radians(tilt_deg)
        if tilt > tool.max_tilt_rad + 1e-9:
            return
        for world_T_tcp, label in _leaning(spot.world_T_operation, tool, tilt, tilt_deg):
            for yaw_deg in _YAWS_DEG if has_yaw else (0.0,):
                turned = world_T_tcp @ rotation((0.0, 0.0, 1.0), math.radians(yaw_deg))
                yield ToolPose(
                    world_T_tip=turned @ tcp_T_tip,
                    back_off=scale(turned.z_axis, -1.0),
                    label=label,
                )


def _leaning(
    world_T_operation: Pose, tool: EndEffector, tilt: float, tilt_deg: float
) -> Iterator[tuple[Pose, str]]:
    stand_off_m = tool.nose_half_width_m * math.sin(tilt)
    shift = scale(world_T_operation.z_axis, -stand_off_m)
    placed = Pose(add(world_T_operation.position_m, shift), world_T_operation.quaternion_wxyz)
    for k in range(_DIRECTIONS if tilt else 1):
        bearing = 2.0 * math.pi * k / _DIRECTIONS
        axis = (math.cos(bearing), math.sin(bearing), 0.0)
        label = (
            f"tilt {tilt_deg:g} deg about {math.degrees(bearing):.0f} deg" if tilt else "upright"
        )
        yield placed @ rotation(axis, tilt), label
