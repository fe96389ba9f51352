"""A drawing that carries what was built is the same design; whatever else it says is new."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from builders_building import component, ids, model, stock
from sitewright.app.marked_files import as_designed
from sitewright.building_model.component import Layer
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.site_state import PlacedPiece, SiteState
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import Pose, translation

SILL, STUD = ids("sill", "stud")


def design(count: int = 3) -> BuildingModel:
    return model(component("sill"), component("stud"), stacks=[stock(count)])


def site(**piece_by_target: str) -> SiteState:
    """Return a site on which targets were installed, each made of a piece."""
    placed = {
        ComponentId(t): PlacedPiece(
            piece=ComponentId(p),
            world_T_wanted=Pose(),
            world_T_measured=Pose(),
            robot=RobotId("r"),
        )
        for t, p in piece_by_target.items()
    }
    return SiteState(placed=placed, installed=tuple(placed))


def marked(drawn: BuildingModel, name: str, layer: Layer, **changes: Any) -> BuildingModel:
    """Return what is read of a drawing after an object was moved to another layer."""
    there = replace(drawn.component_by_id[ComponentId(name)], layer=layer, **changes)
    stacks = tuple(replace(s, items=tuple(i for i in s.items if i != name)) for s in drawn.stacks)
    return replace(
        drawn,
        component_by_id={**drawn.component_by_id, there.id: there},
        stacks=tuple(s for s in stacks if s.items),
    )


def used(drawn: BuildingModel, name: str) -> BuildingModel:
    """Return the drawing after a piece was used: drawn only, where it was drawn."""
    at = translation(5.0, 5.0, 0.0)
    return marked(drawn, name, Layer.AS_DESIGNED, world_T_component=at)


def test_what_the_runs_built_and_used_is_no_change() -> None:
    drawn = used(marked(design(), "sill", Layer.AS_BUILT), "piece-3")
    assert as_designed(drawn, design(), site(sill="piece-3")) == design()


def test_a_pile_that_was_used_up_is_there_again() -> None:
    drawn = used(used(design(2), "piece-2"), "piece-1")
    assert drawn.stacks == ()
    assert as_designed(drawn, design(2), site(sill="piece-2", stud="piece-1")) == design(2)


def test_a_drawing_without_marks_stays_as_it_is() -> None:
    assert as_designed(design(), design(), site(sill="piece-3")) == design()


def test_what_no_run_built_is_what_its_layer_says() -> None:
    drawn = used(marked(design(), "stud", Layer.AS_BUILT), "piece-2")
    found = as_designed(drawn, design(), site(sill="piece-3"))
    assert found.component_by_id[STUD].layer is Layer.AS_BUILT
    assert found.component_by_id[ComponentId("piece-2")].layer is Layer.AS_DESIGNED
    assert found == drawn


def test_what_was_built_and_is_drawn_otherwise_now_stays_a_change() -> None:
    moved = translation(1.0, 0.0, 0.0)
    drawn = marked(design(), "sill", Layer.AS_BUILT, world_T_component=moved)
    found = as_designed(drawn, design(), site(sill="piece-3")).component_by_id[SILL]
    assert (found.layer, found.world_T_component) == (Layer.TARGET, moved)


def test_new_stock_lies_above_what_the_pile_had() -> None:
    grown = model(component("sill"), component("stud"), stacks=[stock(4)])
    drawn = used(grown, "piece-3")
    (pile,) = as_designed(drawn, design(), site(sill="piece-3")).stacks
    assert pile.items == ids("piece-1", "piece-2", "piece-3", "piece-4")
