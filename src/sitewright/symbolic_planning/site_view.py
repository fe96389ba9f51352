"""What the predicate evaluators look at: graph, robot states and the twin's geometric facts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.foundation.ids import (
    ComponentId,
    EndEffectorId,
    OperationId,
    RobotId,
    StationId,
)
from sitewright.robot_team.cell import Cell

PlaceId = str
"""Site id of a PDDL place: stock place, target, operation (fastener or finish), station."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotStatus:
    """Symbolic state of one robot, derived from what was sensed.

    Attributes:
        place: Where its tip is; None is in transit.
        mounted: End effector on its flange; None is a bare flange.
        holding: Piece of material in its gripper, off its place.
        steadying: Target whose piece it holds at the target pose; then `holding` is None.
    """

    place: PlaceId | None
    mounted: EndEffectorId | None
    holding: ComponentId | None = None
    steadying: ComponentId | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class GeometricFacts:
    """What the planning twin knows of a target, from its batch check and from refusals.

    Times are in seconds; a missing reach time means that the robot cannot reach the place.
    """

    can_reach: frozenset[tuple[RobotId, PlaceId]] = frozenset()
    can_grasp: frozenset[tuple[RobotId, EndEffectorId, ComponentId]] = frozenset()
    can_place: frozenset[tuple[RobotId, ComponentId, ComponentId]] = frozenset()
    can_set_down: frozenset[tuple[RobotId, ComponentId, PlaceId]] = frozenset()
    excludes: frozenset[tuple[RobotId, PlaceId, PlaceId]] = frozenset()
    tacks: frozenset[tuple[OperationId, ComponentId]] = frozenset()
    reach_time_s: Mapping[tuple[RobotId, PlaceId], float] = field(default_factory=dict)
    skill_time_s: Mapping[tuple[RobotId, str], float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class Errand:
    """A piece to be brought to a buffer before its target, or another one, is built.

    Attributes:
        place: Buffer station.
    """

    piece: ComponentId
    place: PlaceId


@dataclass(frozen=True, slots=True, kw_only=True)
class SiteView:
    """Everything that a predicate's evaluator may ask, at one moment.

    Attributes:
        graph: Construction relationship graph as it stands now.
        target: The active target (front of the queue).
        candidates: Pieces that may become it: accessible, or already held or placed.
        lies_at: Stock place or buffer station of each piece that lies on one.
        in_place: Piece that is at a target's pose but not yet installed, by target.
        standing: Targets that stand by themselves (released after their tacks).
        done_operations: Fasteners driven, finishes applied.
        docked: Tool station of each end effector that is on no robot.
        movable: Further pieces that may be grasped and set down elsewhere, being in the way.
        errand: What is to be done instead of installing the target, if not that.
    """

    graph: ConstructionGraph
    cell: Cell
    target: ComponentId
    candidates: tuple[ComponentId, ...]
    robot_status: Mapping[RobotId, RobotStatus]
    lies_at: Mapping[ComponentId, PlaceId]
    in_place: Mapping[ComponentId, ComponentId] = field(default_factory=dict)
    standing: frozenset[ComponentId] = frozenset()
    done_operations: frozenset[OperationId] = frozenset()
    docked: Mapping[EndEffectorId, StationId] = field(default_factory=dict)
    geometry: GeometricFacts = field(default_factory=GeometricFacts)
    movable: tuple[ComponentId, ...] = ()
    errand: Errand | None = None
