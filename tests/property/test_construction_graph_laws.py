"""Laws of the construction graph, for any model that the checks accept."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st

from builders_building import PLACE, STUD_M, component, model, piece
from sitewright.building_model.as_built import InstallRecord, fold
from sitewright.building_model.check_references import cycle_in
from sitewright.building_model.component import Component
from sitewright.building_model.model import BuildingModel, Relation, RelationKind
from sitewright.construction_graph.build import InstalledPiece, SiteChanges, graph_of
from sitewright.construction_graph.graph import JOBSITE, ConstructionGraph, TargetNode
from sitewright.construction_graph.queries import accessible_materials, is_ready
from sitewright.construction_graph.queue import target_queue
from sitewright.construction_graph.update import install
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import translation
from sitewright.robot_team.cell import Cell, StockPlace

CELL = Cell(
    robot_by_id={},
    end_effector_by_id={},
    stock_place_by_id={PLACE: StockPlace(id=PLACE, world_T_stock=translation(2.0, 0.0, 0.3))},
)
KINDS = ("stud", "plate")


@st.composite
def models(draw: st.DrawFn) -> BuildingModel:
    """A model whose construction parents point backwards, with stock enough for all targets."""
    count = draw(st.integers(1, 6))
    names = draw(st.permutations([f"t{n}" for n in range(count)]))
    components = []
    for index, name in enumerate(names):
        parents = draw(st.lists(st.sampled_from(names[:index]), unique=True)) if index else []
        kind = draw(st.sampled_from(KINDS))
        order = draw(st.none() | st.integers(0, 3))
        components.append(component(name, kind=kind, on=parents, ground=not parents, order=order))
    relations = [
        Relation(kind=RelationKind.BEFORE, a=a.id, b=b.id)
        for k, a in enumerate(components)
        for b in components[k + 1 :]
        if draw(st.integers(0, 5)) == 0
    ]
    pieces = [
        piece(f"m{n}", kind=c.type, size_m=STUD_M)
        for n, c in enumerate(draw_more(draw, components))
    ]
    shuffled = draw(st.permutations(pieces))
    cut = draw(st.integers(0, len(shuffled)))
    stacks = [s for s in (shuffled[:cut], shuffled[cut:]) if s]
    return model(*components, stacks=stacks, relations=relations)


def draw_more(draw: st.DrawFn, components: list[Component]) -> list[Component]:
    spare = draw(st.lists(st.sampled_from(components), max_size=3))
    return [*components, *spare]


def built_up(model_: BuildingModel, steps: int) -> tuple[ConstructionGraph, list[InstallRecord]]:
    """Install as far as the stacks allow, at most `steps` targets."""
    graph, records = graph_of(model_, CELL), []
    for number in range(steps):
        choice = next(
            (
                (node, pieces[0].id)
                for name in target_queue(graph)
                if isinstance(node := graph.node_by_id[name], TargetNode)
                and is_ready(graph, node)
                and (pieces := accessible_materials(graph, node))
            ),
            None,
        )
        if choice is None:
            break
        node, material = choice
        measured = translation(0.001 * number, 0.0, 0.5)
        graph = install(graph, material, node.id, measured)
        records.append(InstallRecord(target=node.id, material=material, world_T_measured=measured))
    return graph, records


@given(model_=models(), steps=st.integers(0, 6))
@settings(max_examples=60, deadline=None)
def test_the_graph_is_always_a_dag_with_one_root(model_: BuildingModel, steps: int) -> None:
    graph, _ = built_up(model_, steps)
    parents = {i: n.construction_parents for i, n in graph.node_by_id.items()}
    assert cycle_in(parents) == ()
    assert all(p == JOBSITE or p in parents for ps in parents.values() for p in ps)
    assert all(parents.values()), "only the jobsite has no construction parent"
    assert JOBSITE not in parents


@given(model_=models(), steps=st.integers(0, 6))
@settings(max_examples=60, deadline=None)
def test_a_buried_piece_is_never_offered(model_: BuildingModel, steps: int) -> None:
    graph, records = built_up(model_, steps)
    used = {r.material for r in records}
    tops = {
        next(i for i in reversed(s.items) if i not in used)
        for s in model_.stacks
        if set(s.items) - used
    }
    for node in graph.node_by_id.values():
        if isinstance(node, TargetNode):
            offered = {m.id for m in accessible_materials(graph, node)}
            assert offered <= tops
            assert offered == {t for t in tops if graph.node_by_id[t].type == node.type}


@given(model_=models(), steps=st.integers(0, 6))
@settings(max_examples=60, deadline=None)
def test_the_graph_of_the_as_built_model_is_the_updated_graph(
    model_: BuildingModel, steps: int
) -> None:
    graph, records = built_up(model_, steps)
    assert graph_of(fold(model_, records), CELL) == graph
    installed = {
        r.target: InstalledPiece(material=r.material, world_T_component=r.world_T_measured)
        for r in records
    }
    assert graph_of(model_, CELL, SiteChanges(installed=installed)) == graph


@given(model_=models())
@settings(max_examples=60, deadline=None)
def test_the_queue_holds_every_target_once_after_what_it_waits_for(model_: BuildingModel) -> None:
    graph = graph_of(model_, CELL)
    queue = target_queue(graph)
    place = {t: k for k, t in enumerate(queue)}
    nodes = {i: n for i, n in graph.node_by_id.items() if isinstance(n, TargetNode)}
    assert sorted(queue) == sorted(nodes)
    for name, node in nodes.items():
        assert all(place[p] < place[name] for p in node.construction_parents if p != JOBSITE)
    assert all(place[a] < place[b] for a, b in graph.comes_before)


@given(model_=models(), data=st.data())
@settings(max_examples=40, deadline=None)
def test_the_order_of_records_does_not_matter(model_: BuildingModel, data: st.DataObject) -> None:
    _, records = built_up(model_, 6)
    shuffled = data.draw(st.permutations(records))
    assert fold(model_, shuffled) == fold(model_, records)


@given(model_=models(), data=st.data())
@settings(max_examples=40, deadline=None)
def test_a_model_with_any_cycle_is_told(model_: BuildingModel, data: st.DataObject) -> None:
    graph = graph_of(model_, CELL)
    queue = target_queue(graph)
    first = data.draw(st.sampled_from(queue))
    above = [t for t in queue if _rests_on(graph, t, first)]
    last = data.draw(st.sampled_from(above))
    looped = replace(
        model_.component_by_id[first],
        construction_parents=(*model_.component_by_id[first].construction_parents, last),
    )
    everything = {**model_.component_by_id, first: looped}
    cycle = cycle_in({i: c.construction_parents for i, c in everything.items()})
    assert first in cycle
    assert cycle[0] == cycle[-1]


def _rests_on(graph: ConstructionGraph, upper: ComponentId, lower: ComponentId) -> bool:
    return upper == lower or any(
        p != JOBSITE and _rests_on(graph, p, lower)
        for p in graph.node_by_id[upper].construction_parents
    )
