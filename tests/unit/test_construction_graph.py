"""The construction relationship graph: build, questions, update, queue."""

from __future__ import annotations

from dataclasses import replace

import pytest

from builders_building import EXAMPLES, PLACE, component, ids, model, nail, piece, stock
from sitewright.building_model.as_built import InstallRecord, UnknownInstallationError, fold
from sitewright.building_model.component import Layer
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.model import Relation, RelationKind
from sitewright.construction_graph.build import (
    InstalledPiece,
    MovedPiece,
    SiteChanges,
    graph_of,
)
from sitewright.construction_graph.graph import JOBSITE, NOWHERE, ConstructionGraph, TargetNode
from sitewright.construction_graph.queries import (
    accessible_materials,
    children,
    is_ready,
    leaves,
    missing_before,
    nearest_material,
)
from sitewright.construction_graph.queue import construction_queue, target_queue
from sitewright.construction_graph.update import WrongInstallationError, install, move_piece
from sitewright.foundation.ids import ComponentId, OperationId, StationId, StockPlaceId
from sitewright.foundation.pose import Pose, translation
from sitewright.robot_team.cell import Cell, StockPlace
from sitewright.robot_team.formats.cell_toml import read_cell

CELL = Cell(
    robot_by_id={},
    end_effector_by_id={},
    stock_place_by_id={PLACE: StockPlace(id=PLACE, world_T_stock=translation(2.0, 0.0, 0.3))},
    world_T_model=translation(0.0, 0.0, 0.4),
)
SILL, STUD = ids("sill", "stud")


def frame(*, stacks: int = 1) -> ConstructionGraph:
    piles = [[piece(f"{k}.{n}") for n in (1, 2, 3)] for k in range(1, stacks + 1)]
    return graph_of(
        model(component("sill", ground=True), component("stud", on=["sill"]), stacks=piles), CELL
    )


def target(graph: ConstructionGraph, name: str) -> TargetNode:
    node = graph.node_by_id[ComponentId(name)]
    assert isinstance(node, TargetNode)
    return node


def offered(graph: ConstructionGraph, name: str) -> list[str]:
    return [m.id for m in accessible_materials(graph, target(graph, name))]


def test_everything_hangs_under_the_jobsite() -> None:
    graph = frame()
    assert children(graph, JOBSITE) == ids("1.1", "sill")
    assert children(graph, SILL) == (STUD,)
    assert leaves(graph) == ids("1.3", "stud")


def test_poses_are_in_the_world() -> None:
    graph = frame()
    assert graph.node_by_id[SILL].world_T_component.position_m == pytest.approx((0, 0, 0.42))
    middle = graph.node_by_id[ids("1.2")[0]].world_T_component
    assert middle.position_m == pytest.approx((2.0, 0.0, 0.36))


def test_only_the_top_of_a_stack_is_accessible() -> None:
    assert offered(frame(stacks=2), "sill") == ["1.3", "2.3"]


def test_a_piece_of_another_type_section_length_or_material_does_not_fit() -> None:
    wanted = component("sill", ground=True, material="C24")
    piles = [
        [piece("a", kind="beam", material="C24")],
        [piece("b", size_m=(1.8, 0.09, 0.05), material="C24")],
        [piece("c", size_m=(1.9, 0.09, 0.04), material="C24")],
        [piece("d", material="C30")],
        [piece("e", material="C24", size_m=(1.801, 0.04, 0.09))],
    ]
    assert offered(graph_of(model(wanted, stacks=piles), CELL), "sill") == ["e"]


def test_the_nearest_piece_is_chosen_and_ties_go_by_id() -> None:
    piles = [[piece("a")], [piece("b")], [piece("c")]]
    sensed = {
        ComponentId("a"): translation(3, 0, 0),
        ComponentId("b"): translation(1, 0, 0),
        ComponentId("c"): translation(-1, 0, 0),
    }
    built = model(component("sill", ground=True), stacks=piles)
    graph = graph_of(built, CELL, SiteChanges(sensed=sensed))
    sill = target(graph, "sill")
    assert nearest_material(graph, sill, [(0.0, 0.0, 0.0)]) == graph.node_by_id[ids("b")[0]]
    far = nearest_material(graph, sill, [(0.0, 9.0, 0.0), (4.0, 0.0, 0.0)])
    assert far == graph.node_by_id[ids("a")[0]]
    assert nearest_material(graph_of(model(component("x")), CELL), sill, [(0, 0, 0)]) is None


def test_installing_renames_the_piece_and_exposes_the_next() -> None:
    graph = frame()
    measured = translation(0.001, 0.0, 0.42)
    after = install(graph, ids("1.3")[0], SILL, measured)
    node = after.node_by_id[SILL]
    assert (node.layer, node.material_used, node.label) == (Layer.AS_BUILT, "1.3", "sill")
    assert node.world_T_component == measured
    assert node.construction_parents == (JOBSITE,)
    assert ids("1.3")[0] not in after.node_by_id
    assert offered(after, "stud") == ["1.2"]
    assert ids("1.3")[0] in graph.node_by_id


def test_a_buried_piece_cannot_be_installed() -> None:
    with pytest.raises(WrongInstallationError, match=r"buried under 1\.3"):
        install(frame(), ids("1.2")[0], SILL, Pose())


@pytest.mark.parametrize(("piece_id", "target_id"), [("1.3", "1.2"), ("stud", "sill"), ("x", "y")])
def test_only_pieces_become_targets(piece_id: str, target_id: str) -> None:
    with pytest.raises(WrongInstallationError, match="no such piece or target"):
        install(frame(), ComponentId(piece_id), ComponentId(target_id), Pose())


def test_a_target_is_ready_when_what_carries_it_stands() -> None:
    graph = frame()
    assert is_ready(graph, target(graph, "sill"))
    assert missing_before(graph, target(graph, "stud")) == (SILL,)
    after = install(graph, ids("1.3")[0], SILL, Pose())
    assert is_ready(after, target(after, "stud"))


def test_relations_order_what_does_not_carry_each_other() -> None:
    a, b, c = (component(i, ground=True) for i in "abc")
    relations = [
        Relation(kind=RelationKind.BEFORE, a=b.id, b=a.id),
        Relation(kind=RelationKind.BLOCKS, a=b.id, b=c.id),
    ]
    graph = graph_of(model(a, b, c, stacks=[stock(3)], relations=relations), CELL)
    assert target_queue(graph) == ids("c", "b", "a")
    assert missing_before(graph, target(graph, "a")) == (b.id,)
    assert missing_before(graph, target(graph, "b")) == (c.id,)


def test_support_relations_make_construction_parents() -> None:
    a, b = component("a", ground=True), component("b")
    carries = Relation(kind=RelationKind.SUPPORTS, a=a.id, b=b.id)
    graph = graph_of(model(a, b, stacks=[stock(2)], relations=[carries]), CELL)
    assert graph.node_by_id[b.id].construction_parents == (a.id,)


def test_the_order_only_breaks_ties() -> None:
    parts = (
        component("late", ground=True, order=9),
        component("early", ground=True, order=1),
        component("none", ground=True),
        component("zz", on=["late"], order=0),
    )
    graph = graph_of(model(*parts, stacks=[stock(4)]), CELL)
    assert target_queue(graph) == ids("early", "late", "zz", "none")


def test_each_target_has_its_queue_of_operations() -> None:
    nails = [nail(f"n{k}", on=["stud", "sill"], at_m=(0.1 * k, 0, 0.02)) for k in (1, 2, 3)]
    nails[0] = replace(nails[0], after=(OperationId("n3"),))
    stud = component("stud", on=["sill"], operations=tuple(nails))
    graph = graph_of(model(component("sill", ground=True), stud, stacks=[stock(2)]), CELL)
    queue = construction_queue(graph)
    assert [q.target for q in queue] == ["sill", "stud"]
    assert queue[1].operations == ("n2", "n3", "n1")


def test_the_frame_is_built_supports_first() -> None:
    project = EXAMPLES / "wooden_frame"
    graph = graph_of(read_building(project / "building.json"), read_cell(project / "cell.toml"))
    queue = construction_queue(graph)
    assert [q.target for q in queue] == ["support-1", "support-2", "stud-1", "stud-2", "stud-3"]
    assert [len(q.operations) for q in queue] == [0, 0, 4, 4, 4]


def test_a_piece_on_the_buffer_is_accessible_there_and_uncovers_its_stack() -> None:
    built = model(component("sill", ground=True), stacks=[stock(2)])
    buffer = StockPlaceId(StationId("buffer"))
    moved = {ComponentId("piece-2"): MovedPiece(place=buffer, world_T_component=Pose())}
    graph = graph_of(built, CELL, SiteChanges(moved=moved))
    assert offered(graph, "sill") == ["piece-1", "piece-2"]
    assert graph == move_piece(graph_of(built, CELL), ComponentId("piece-2"), buffer, Pose())


def test_a_piece_in_a_gripper_is_not_offered() -> None:
    graph = move_piece(frame(), ids("1.3")[0], NOWHERE, Pose())
    assert offered(graph, "sill") == ["1.2"]


@pytest.mark.parametrize(("name", "words"), [("sill", "no piece of stock"), ("1.1", "buried")])
def test_only_a_top_piece_can_be_moved(name: str, words: str) -> None:
    with pytest.raises(WrongInstallationError, match=words):
        move_piece(frame(), ComponentId(name), NOWHERE, Pose())


def test_a_queue_of_targets_that_wait_for_each_other_is_an_error() -> None:
    a, b = component("a", on=["b"]), component("b", on=["a"])
    with pytest.raises(ValueError, match="wait for each other: a, b"):
        target_queue(graph_of(model(a, b), CELL))


def test_a_consumed_piece_is_gone_and_what_lay_on_it_comes_down() -> None:
    built = model(component("sill", ground=True), stacks=[stock(3)])
    graph = graph_of(built, CELL, SiteChanges(consumed=frozenset(ids("piece-2"))))
    assert graph.node_by_id[ids("piece-3")[0]].construction_parents == ids("piece-1")
    assert offered(graph, "sill") == ["piece-3"]


def test_the_as_built_model_gives_the_same_graph() -> None:
    built = model(component("sill", ground=True), component("stud", on=["sill"]), stacks=[stock(3)])
    measured = translation(0.002, 0.0, 0.421)
    record = InstallRecord(
        target=SILL, material=ComponentId("piece-3"), world_T_measured=measured, robot="r1"
    )
    now = SiteChanges(
        installed={
            SILL: InstalledPiece(material=ComponentId("piece-3"), world_T_component=measured)
        }
    )
    expected = install(graph_of(built, CELL), ComponentId("piece-3"), SILL, measured)
    assert graph_of(fold(built, [record]), CELL) == expected
    assert graph_of(built, CELL, now) == expected


def test_a_record_of_an_unknown_target_is_refused() -> None:
    record = InstallRecord(
        target=ComponentId("gone"), material=ComponentId("p"), world_T_measured=Pose()
    )
    with pytest.raises(UnknownInstallationError, match="not in the design"):
        fold(model(), [record])
