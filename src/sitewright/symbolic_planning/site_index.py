"""A site view with what its evaluators look up again and again, worked out once."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from sitewright.building_model.component import Operation, Process
from sitewright.construction_graph.graph import NOWHERE, MaterialNode, TargetNode
from sitewright.foundation.ids import ComponentId, EndEffectorId, OperationId, RobotId, StationId
from sitewright.robot_team.cell import Capability, Cell, StationKind
from sitewright.symbolic_planning.site_view import PlaceId, SiteView

FASTENING_PROCESSES = frozenset({Process.NAIL, Process.SCREW, Process.DRILL})
FINISHING_PROCESSES = frozenset({Process.PAINT})


@dataclass(frozen=True, slots=True, kw_only=True)
class SiteIndex:
    """What predicates are evaluated on.

    Attributes:
        targets: Targets of this problem: the active one, and any that a robot still steadies.
        things: Pieces of this problem: candidates, movable ones, whatever is held or placed.
        fasteners: Operations of the targets that drive something, by id.
        finishes: Operations of the targets that treat a surface, by id.
        target_of: Target of each of these operations.
        driven_after: Pairs (operation, fastener that must be driven before it).
        occupied: Places where a robot is.
        covered: Pieces on which another one lies.
        preparation: Preparation station of each robot.
        bare_dock: Where a robot's bare flange "docks", so that a tool can be put away.
    """

    view: SiteView
    targets: tuple[ComponentId, ...]
    things: tuple[ComponentId, ...]
    fasteners: Mapping[OperationId, Operation]
    finishes: Mapping[OperationId, Operation]
    target_of: Mapping[OperationId, ComponentId]
    driven_after: frozenset[tuple[OperationId, OperationId]]
    occupied: frozenset[PlaceId]
    covered: frozenset[ComponentId]
    preparation: Mapping[RobotId, PlaceId]
    bare_dock: Mapping[EndEffectorId, StationId]


def index_site(view: SiteView) -> SiteIndex:
    """Return the view with its look-up tables."""
    targets = _targets(view)
    operations = [(op, t) for t in targets for op in _operations(view, t)]
    fasteners = {op.id: op for op, _ in operations if op.process in FASTENING_PROCESSES}
    finishes = {op.id: op for op, _ in operations if op.process in FINISHING_PROCESSES}
    tacks = {c for c, _ in view.geometry.tacks}
    return SiteIndex(
        view=view,
        targets=targets,
        things=_things(view),
        fasteners=fasteners,
        finishes=finishes,
        target_of={op.id: t for op, t in operations},
        driven_after=_driven_after(fasteners, finishes.values(), tacks),
        occupied=frozenset(s.place for s in view.robot_status.values() if s.place is not None),
        covered=_covered(view),
        preparation={r: preparation_place(view.cell, r) for r in view.cell.robot_by_id},
        bare_dock=_bare_docks(view),
    )


def preparation_place(cell: Cell, robot: RobotId) -> PlaceId:
    """Return the robot's preparation station: the cell's, else the home posture's own name."""
    stations = sorted(
        s.id
        for s in cell.station_by_id.values()
        if s.kind is StationKind.PREPARATION and s.robot == robot
    )
    return stations[0] if stations else f"home-{robot}"


def bare_flange(robot: RobotId) -> EndEffectorId:
    """Return the id of the "end effector" that a robot without one has mounted."""
    return EndEffectorId(f"bare-{robot}")


def _targets(view: SiteView) -> tuple[ComponentId, ...]:
    steadied = {s.steadying for s in view.robot_status.values() if s.steadying is not None}
    return tuple(sorted({view.target, *steadied}))


def _things(view: SiteView) -> tuple[ComponentId, ...]:
    held = {s.holding for s in view.robot_status.values() if s.holding is not None}
    placed = {view.in_place[t] for t in _targets(view) if t in view.in_place}
    return tuple(sorted({*view.candidates, *view.movable, *held, *placed}))


def _covered(view: SiteView) -> frozenset[ComponentId]:
    """Return the pieces on which another lies; one in a gripper or at its target covers none."""
    lifted = {s.holding for s in view.robot_status.values()} | set(view.in_place.values())
    return frozenset(
        below
        for node in view.graph.node_by_id.values()
        if isinstance(node, MaterialNode) and node.id not in lifted and node.place != NOWHERE
        for below in node.construction_parents
    )


def _operations(view: SiteView, target: ComponentId) -> tuple[Operation, ...]:
    node = view.graph.node_by_id.get(target)
    return node.operations if isinstance(node, TargetNode) else ()


def _driven_after(
    fasteners: Mapping[OperationId, Operation],
    finishes: Iterable[Operation],
    tacks: set[OperationId],
) -> frozenset[tuple[OperationId, OperationId]]:
    """Return the designer's order, and a chain through each connection that has none.

    Which of four like nails comes first does not matter; a fixed order keeps the search small.
    Those that tack the piece come first in the chain, or releasing it could wait for ever.
    """
    pairs = {
        (op.id, b) for op in (*fasteners.values(), *finishes) for b in op.after if b in fasteners
    }
    connections: dict[tuple[ComponentId, ...], list[OperationId]] = defaultdict(list)
    for op in fasteners.values():
        connections[op.on].append(op.id)
    ordered = {x for pair in pairs for x in pair}
    for members in connections.values():
        if ordered.isdisjoint(members):
            chain = sorted(members, key=lambda c: c not in tacks)
            pairs.update(zip(chain[1:], chain, strict=False))
    return frozenset(pairs)


def _bare_docks(view: SiteView) -> dict[EndEffectorId, StationId]:
    docks: dict[EndEffectorId, StationId] = {}
    for robot in view.cell.robot_by_id.values():
        mounted = view.robot_status[robot.id].mounted
        if Capability.TOOL_CHANGING not in robot.can or mounted is None:
            continue
        station = view.cell.end_effector_by_id[mounted].station
        if station is not None:
            docks[bare_flange(robot.id)] = station
    return docks
