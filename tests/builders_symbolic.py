"""Sites for tests of symbolic planning; an argument that is not named is irrelevant."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from sitewright.building_model.component import FastenerSpec, Layer, Operation, Process
from sitewright.construction_graph.graph import (
    JOBSITE,
    ConstructionGraph,
    MaterialNode,
    Node,
    TargetNode,
)
from sitewright.foundation.ids import (
    ComponentId,
    EndEffectorId,
    OperationId,
    RobotId,
    StationId,
    StockPlaceId,
)
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import (
    Capability,
    Cell,
    EndEffector,
    EndEffectorKind,
    FastenerRange,
    Robot,
    RobotSubtype,
    Station,
    StationKind,
    StockPlace,
)
from sitewright.robot_team.description import Description
from sitewright.symbolic_planning.site_view import GeometricFacts, RobotStatus, SiteView

HANDLING = frozenset({Capability.GRASPING, Capability.POSITIONING, Capability.RELEASING})
FINISHING = frozenset({Capability.FASTENING, Capability.FINISHING})
STUD = ComponentId("stud-1")
NAIL = FastenerSpec(type="nail", d_m=0.0031, l_m=0.09)
SCREW = FastenerSpec(type="screw", d_m=0.006, l_m=0.08)


def description(name: str) -> Description:
    return Description(name=name, links=(), joints=(), root="base", tip="tip")


def robot(name: str, subtype: RobotSubtype, mounted: str | None, fits: Iterable[str] = ()) -> Robot:
    can = {
        RobotSubtype.HANDLER: HANDLING,
        RobotSubtype.FINISHER: FINISHING,
        RobotSubtype.ALL_ROUNDER: HANDLING | FINISHING,
    }[subtype]
    end_effectors = tuple(EndEffectorId(e) for e in fits) or (
        (EndEffectorId(mounted),) if mounted else ()
    )
    changes = frozenset({Capability.TOOL_CHANGING}) if len(end_effectors) > 1 else frozenset()
    return Robot(
        id=RobotId(name),
        model="kr120",
        description=description("kr120"),
        subtype=subtype,
        can=can | changes,
        world_T_base=Pose(),
        home_q_rad=(0.0,) * 6,
        parking_q_rad=((1.0,) * 6,),
        max_acceleration_rad_s2=(5.0,) * 6,
        end_effectors=end_effectors,
        mounted=EndEffectorId(mounted) if mounted else None,
    )


def gripper(name: str) -> EndEffector:
    return EndEffector(
        id=EndEffectorId(name),
        kind=EndEffectorKind.GRIPPER,
        description=description(name),
        station=None,
        grips_m=(0.03, 0.14),
    )


def tool(name: str, process: str, fastener: FastenerSpec | None = NAIL) -> EndEffector:
    ranges = (
        (FastenerRange(type=fastener.type, d_m=fastener.d_m, l_min_m=0.05, l_max_m=0.1),)
        if fastener
        else ()
    )
    return EndEffector(
        id=EndEffectorId(name),
        kind=EndEffectorKind.TOOL,
        description=description(name),
        station=StationId("tools"),
        processes=(process,),
        fasteners=ranges,
    )


def nail(number: int, receiver: str = "support-1", **changes: object) -> Operation:
    base = Operation(
        id=OperationId(f"nail-{number:02d}"),
        process=Process.NAIL,
        on=(STUD, ComponentId(receiver)),
        fastener=NAIL,
    )
    return replace(base, **changes)  # type: ignore[arg-type]


def four_nails() -> tuple[Operation, ...]:
    return (*(nail(k, "support-1") for k in (1, 2)), *(nail(k, "support-2") for k in (3, 4)))


def graph(
    operations: Sequence[Operation] = (),
    *,
    supports: Sequence[str] = ("support-1", "support-2"),
    stack: Sequence[str] = ("piece-1", "piece-2", "piece-3"),
    is_supported: bool = True,
) -> ConstructionGraph:
    layer = Layer.AS_BUILT if is_supported else Layer.TARGET
    nodes: list[Node] = [
        Node(
            id=ComponentId(s),
            label=s,
            layer=layer,
            type="support",
            construction_parents=(JOBSITE,),
            world_T_component=Pose(),
            size_m=(2.4, 0.09, 0.14),
        )
        for s in supports
    ]
    nodes.append(
        TargetNode(
            id=STUD,
            label="Stud 1",
            layer=Layer.TARGET,
            type="stud",
            construction_parents=tuple(ComponentId(s) for s in supports) or (JOBSITE,),
            world_T_component=Pose(),
            size_m=(1.8, 0.09, 0.04),
            material_type=("stud", (0.04, 0.09), 1.8, ""),
            operations=tuple(operations),
        )
    )
    below = JOBSITE
    for piece in stack:
        nodes.append(
            MaterialNode(
                id=ComponentId(piece),
                label=piece,
                layer=Layer.MATERIAL,
                type="stud",
                construction_parents=(below,),
                world_T_component=Pose(),
                size_m=(1.8, 0.09, 0.04),
                place=StockPlaceId("stock"),
            )
        )
        below = ComponentId(piece)
    return ConstructionGraph(node_by_id={n.id: n for n in nodes})


def team(handlers: int, finishers: int) -> Cell:
    """Handlers with a gripper each, finishers with a nail gun and a screwdriver each."""
    robots: list[Robot] = []
    effectors: list[EndEffector] = []
    for k in range(1, handlers + 1):
        effectors.append(gripper(f"gripper-{k}"))
        robots.append(robot(f"handler-{k}", RobotSubtype.HANDLER, f"gripper-{k}"))
    for k in range(1, finishers + 1):
        names = (f"nail-gun-{k}", f"screwdriver-{k}")
        effectors += [tool(names[0], "nail"), tool(names[1], "screw", SCREW)]
        robots.append(robot(f"nailer-{k}", RobotSubtype.FINISHER, names[0], names))
    return cell(robots, effectors)


def cell(robots: Iterable[Robot], effectors: Iterable[EndEffector]) -> Cell:
    robots = list(robots)
    stations = [Station(id=StationId("tools"), kind=StationKind.TOOL, world_T_station=Pose())]
    stations.append(
        Station(id=StationId("buffer"), kind=StationKind.BUFFER, world_T_station=Pose())
    )
    stations += [
        Station(
            id=StationId(f"prep-{r.id}"),
            kind=StationKind.PREPARATION,
            world_T_station=Pose(),
            robot=r.id,
        )
        for r in robots
    ]
    return Cell(
        robot_by_id={r.id: r for r in robots},
        end_effector_by_id={e.id: e for e in effectors},
        station_by_id={s.id: s for s in stations},
        stock_place_by_id={
            StockPlaceId("stock"): StockPlace(id=StockPlaceId("stock"), world_T_stock=Pose())
        },
    )


def handlers_of(a_cell: Cell) -> list[Robot]:
    return [r for r in a_cell.robot_by_id.values() if Capability.GRASPING in r.can]


def geometry(
    a_cell: Cell,
    operations: Sequence[Operation],
    *,
    candidates: Sequence[str] = ("piece-3",),
    tacks: Sequence[str] = (),
    times: Mapping[tuple[RobotId, str], float] | None = None,
) -> GeometricFacts:
    """Everything is reachable by everyone who could want to be there."""
    reach: set[tuple[RobotId, str]] = set()
    grasp, place, down = set(), set(), set()
    for r in a_cell.robot_by_id.values():
        reach.add((r.id, f"prep-{r.id}"))
        if Capability.TOOL_CHANGING in r.can:
            reach.add((r.id, "tools"))
        if Capability.FASTENING in r.can or Capability.FINISHING in r.can:
            reach |= {(r.id, op.id) for op in operations}
        if Capability.GRASPING in r.can:
            reach |= {(r.id, p) for p in ("stock", "buffer", STUD)}
            for c in candidates:
                piece = ComponentId(c)
                grasp |= {(r.id, e, piece) for e in r.end_effectors}
                place.add((r.id, piece, STUD))
                down.add((r.id, piece, "buffer"))
    return GeometricFacts(
        can_reach=frozenset(reach),
        can_grasp=frozenset(grasp),
        can_place=frozenset(place),
        can_set_down=frozenset(down),
        tacks=frozenset((OperationId(c), STUD) for c in tacks),
        reach_time_s=times if times is not None else reach_times(reach),
    )


def reach_times(pairs: Iterable[tuple[RobotId, str]]) -> dict[tuple[RobotId, str], float]:
    """Different for each, so that optima are rarely tied."""
    return {pair: 2.0 + 0.1 * (k * 7 % 23) for k, pair in enumerate(sorted(pairs))}


def site(
    a_cell: Cell | None = None,
    operations: Sequence[Operation] | None = None,
    *,
    tacks: Sequence[str] = ("nail-01", "nail-02"),
    **changes: object,
) -> SiteView:
    """The case study: a stud on two supports, four nails, the first two while it is held."""
    a_cell = a_cell if a_cell is not None else team(1, 1)
    operations = four_nails() if operations is None else operations
    a_graph = graph(operations)
    mounted = {r.mounted for r in a_cell.robot_by_id.values()}
    base = SiteView(
        graph=a_graph,
        cell=a_cell,
        target=STUD,
        candidates=(ComponentId("piece-3"),),
        robot_status={
            r.id: RobotStatus(place=f"prep-{r.id}", mounted=r.mounted)
            for r in a_cell.robot_by_id.values()
        },
        lies_at={ComponentId(f"piece-{k}"): "stock" for k in (1, 2, 3)},
        docked={
            e.id: e.station
            for e in a_cell.end_effector_by_id.values()
            if e.station is not None and e.id not in mounted
        },
        geometry=geometry(a_cell, operations, tacks=tacks),
    )
    return replace(base, **changes)  # type: ignore[arg-type]


def with_geometry(view: SiteView, **changes: object) -> SiteView:
    return replace(view, geometry=replace(view.geometry, **changes))  # type: ignore[arg-type]
