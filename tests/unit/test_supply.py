"""Which piece becomes which target, and when, if everything goes in order."""

from __future__ import annotations

from builders_building import PLACE, component, ids, model, piece
from sitewright.construction_graph.build import graph_of
from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.construction_graph.supply import Supplied, supplied_in_order
from sitewright.foundation.pose import translation
from sitewright.robot_team.cell import Cell, StockPlace

CELL = Cell(
    robot_by_id={},
    end_effector_by_id={},
    stock_place_by_id={PLACE: StockPlace(id=PLACE, world_T_stock=translation(2.0, 0.0, 0.3))},
)
ORIGIN = [(0.0, 0.0, 0.0)]


def supplied(graph: ConstructionGraph) -> dict[str, Supplied]:
    return {s.target: s for s in supplied_in_order(graph, ORIGIN)}


def test_targets_take_the_tops_of_the_stacks_one_after_the_other() -> None:
    stack = [piece("low"), piece("middle"), piece("high")]
    parts = [component(n, ground=True, order=k) for k, n in enumerate(("a", "b", "c"))]
    found = supplied(graph_of(model(*parts, stacks=[stack]), CELL))
    assert [s.accessible for s in found.values()] == [ids("high"), ids("middle"), ids("low")]
    assert found["a"].others == ids("low", "middle")
    assert found["c"].others == ()


def test_a_target_whose_piece_is_buried_waits_for_those_that_uncover_it() -> None:
    stack = [piece("beam-piece", kind="beam"), piece("stud-piece")]
    beam = component("beam", kind="beam", ground=True, order=0)
    stud = component("stud", ground=True, order=1)
    found = supplied(graph_of(model(beam, stud, stacks=[stack]), CELL))
    assert list(found) == ["stud", "beam"]


def test_what_carries_comes_before_what_rests_on_it_even_if_its_piece_is_buried() -> None:
    stack = [piece("beam-piece", kind="beam"), piece("stud-piece")]
    beam = component("beam", kind="beam", ground=True)
    stud = component("stud", on=["beam"])
    found = supplied(graph_of(model(beam, stud, stacks=[stack]), CELL))
    assert list(found) == ["beam", "stud"]
    assert found["beam"].accessible == ()
    assert found["beam"].others == ids("beam-piece")
    assert found["stud"].waits_for == ids("beam")


def test_every_piece_is_used_once_at_most() -> None:
    stacks = [[piece(f"{k}.{n}") for n in range(3)] for k in range(2)]
    parts = [component(f"t{k}", ground=True) for k in range(8)]
    found = supplied(graph_of(model(*parts, stacks=stacks), CELL))
    used = [s.accessible[0] for s in found.values() if s.accessible]
    assert len(used) == len(set(used)) == 6
    assert sum(not s.accessible for s in found.values()) == 2
