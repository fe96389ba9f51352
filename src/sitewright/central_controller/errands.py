"""Errands: a piece brought to a buffer, to be taken differently, by another robot, or cleared."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sitewright.central_controller.design import Design
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.touching import lies_on
from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.foundation.ids import BodyId, ComponentId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.jobsite import Jobsite, PieceShape
from sitewright.planning_twin.setting_down import is_taken, pose_on
from sitewright.planning_twin.task import Task
from sitewright.robot_team.cell import Cell, StationKind
from sitewright.symbolic_planning.site_view import Errand


def buffers(cell: Cell) -> dict[str, Pose]:
    """Return the world pose of each buffer station's surface, by station."""
    stations = cell.station_by_id.values()
    return {s.id: s.world_T_station for s in stations if s.kind is StationKind.BUFFER}


def free_buffers(
    cell: Cell, world_T_pieces: Mapping[ComponentId, Pose], piece: ComponentId
) -> list[str]:
    """Return the buffers on which nothing lies, or just the piece itself."""
    return [
        place
        for place, surface in buffers(cell).items()
        if not is_taken(world_T_pieces, surface, by_other_than=piece)
    ]


def lying_on_buffer(
    context: SiteContext, piece: ComponentId, shape: PieceShape, world_T_surface: Pose
) -> SiteContext:
    """Return the context as if a piece lay on a buffer, and in nobody's gripper."""
    seen = context.observation
    pose = pose_on(world_T_surface, shape, seen.world_T_piece[piece])
    robots = {
        r: replace(state, gripped=None) if state.gripped == piece else state
        for r, state in seen.robots.items()
    }
    there = replace(seen, robots=robots, world_T_piece={**seen.world_T_piece, piece: pose})
    return replace(context, observation=there)


def errand_task(
    design: Design,
    graph: ConstructionGraph,
    context: SiteContext,
    site: Jobsite,
    errand: Errand,
) -> Task:
    """Return an errand as the twin sees it: a target without operations, on the buffer."""
    piece, surface = errand.piece, buffers(design.cell)[errand.place]
    return Task(
        target=ComponentId(errand.place),
        world_T_target=pose_on(surface, site.pieces[piece], site.world_T_piece[piece]),
        candidates=(piece,),
        touches=tuple(BodyId(f) for f in design.cell.fixture_by_id),
        lies_on={piece: lies_on(design, graph, context, piece)},
        buffers={errand.place: surface},
    )
