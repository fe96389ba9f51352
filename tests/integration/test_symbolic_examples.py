"""Symbolic planning of the example projects, as if every motion were possible."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitewright.building_model.formats.native import read_building
from sitewright.construction_graph.build import InstalledPiece, SiteChanges, graph_of
from sitewright.construction_graph.graph import MaterialNode, TargetNode
from sitewright.construction_graph.queries import accessible_materials, is_ready, targets
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.formats.cell_toml import read_cell
from sitewright.symbolic_planning.planner import SkillSequence
from sitewright.symbolic_planning.planners.fast_downward import FastDownward
from sitewright.symbolic_planning.problem import problem_for
from sitewright.symbolic_planning.site_index import preparation_place
from sitewright.symbolic_planning.site_view import GeometricFacts, RobotStatus, SiteView
from sitewright.symbolic_planning.vocabulary import built_in_domain

EXAMPLES = Path(__file__).parents[2] / "examples"


def everything_possible(cell: Cell, target: TargetNode, piece: MaterialNode) -> GeometricFacts:
    places = [target.id, piece.place, *cell.station_by_id, *(op.id for op in target.operations)]
    robots = cell.robot_by_id.values()
    tacks = target.operations[: target.hold_until_fasteners]
    return GeometricFacts(
        can_reach=frozenset((r.id, str(p)) for r in robots for p in places),
        can_grasp=frozenset((r.id, e, piece.id) for r in robots for e in r.end_effectors),
        can_place=frozenset((r.id, piece.id, target.id) for r in robots),
        tacks=frozenset((OperationId(op.id), target.id) for op in tacks),
    )


def plans_of(folder: Path, cell_file: str) -> list[SkillSequence]:
    model = read_building(folder / "building.json")
    cell = read_cell(folder / cell_file)
    mounted = {r.id: r.mounted for r in cell.robot_by_id.values()}
    installed: dict[ComponentId, InstalledPiece] = {}
    done: set[OperationId] = set()
    plans: list[SkillSequence] = []
    while True:
        graph = graph_of(model, cell, SiteChanges(installed=installed))
        ready = [t for t in targets(graph) if is_ready(graph, t)]
        if not ready:
            assert not targets(graph)
            return plans
        target = min(ready, key=lambda t: (t.order or 0, t.id))
        piece = accessible_materials(graph, target)[0]
        view = SiteView(
            graph=graph,
            cell=cell,
            target=target.id,
            candidates=(piece.id,),
            robot_status={
                r: RobotStatus(place=preparation_place(cell, r), mounted=mounted[r])
                for r in cell.robot_by_id
            },
            lies_at={piece.id: piece.place},
            done_operations=frozenset(done),
            docked={
                e.id: e.station
                for e in cell.end_effector_by_id.values()
                if e.station is not None and e.id not in mounted.values()
            },
            geometry=everything_possible(cell, target, piece),
        )
        plan = FastDownward().plan(problem_for(built_in_domain(), view))
        assert isinstance(plan, SkillSequence), plan
        plans.append(plan)
        done |= {op.id for op in target.operations}
        installed[target.id] = InstalledPiece(
            material=piece.id, world_T_component=target.world_T_component
        )


@pytest.mark.parametrize("cell_file", ["cell.toml", "cell.mirrored.toml"])
def test_the_wooden_frame_has_a_reproducible_plan_for_each_of_its_five_targets(
    cell_file: str,
) -> None:
    plans = plans_of(EXAMPLES / "wooden_frame", cell_file)
    skills = [c.skill for p in plans for c in p.calls]
    assert len(plans) == 5
    assert skills.count("fasten") == 12
    assert skills.count("release") == 5
    assert all(p.is_reproducible for p in plans)


def test_the_painted_stud_takes_two_tool_changes() -> None:
    plans = plans_of(EXAMPLES / "painted_frame", "cell.toml")
    changes = [c.arguments[:2] for p in plans for c in p.calls if c.skill == "change-end-effector"]
    assert changes == [("nail-gun", "screwdriver"), ("screwdriver", "paint-head")]
