"""A wall drawn standing in an IFC file is laid flat, completed, planned and written back."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import pytest

ifc = pytest.importorskip("builders_ifc", reason="needs the extra 'ifc'")

import ifcopenshell  # noqa: E402
from ifcopenshell.util.element import get_psets  # noqa: E402
from ifcopenshell.util.placement import get_local_placement  # noqa: E402

from sitewright.app.checking import check  # noqa: E402
from sitewright.app.import_options import ImportOptionError  # noqa: E402
from sitewright.app.importing import ImportOptions, import_file, read_design  # noqa: E402
from sitewright.app.inferring import PANEL_RULES, infer_project  # noqa: E402
from sitewright.app.planning import PlanReport, plan_project  # noqa: E402
from sitewright.app.project import Project, example_folder, open_project  # noqa: E402
from sitewright.app.reimporting import reimport_file  # noqa: E402
from sitewright.building_model.as_built import InstallRecord, fold  # noqa: E402
from sitewright.building_model.component import Component, Layer  # noqa: E402
from sitewright.building_model.formats.ifc_export import export_ifc  # noqa: E402
from sitewright.building_model.inference.stock import piece_id  # noqa: E402
from sitewright.building_model.object_states import object_states  # noqa: E402
from sitewright.building_model.shapes import extent_of, shape_of  # noqa: E402
from sitewright.construction_graph.build import graph_of  # noqa: E402
from sitewright.construction_graph.queue import target_queue  # noqa: E402
from sitewright.foundation.pose import translation  # noqa: E402
from sitewright.robot_team.skill import Skill  # noqa: E402

pytestmark = pytest.mark.slow
FLAT = ImportOptions(lays_flat=True, group="W-01")
NOW = "2030-05-01T18:00:00+00:00"


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    written: Path = ifc.framed_walls().write(tmp_path_factory.mktemp("panel") / "walls.ifc")
    return written


@pytest.fixture(scope="module")
def project(file: Path) -> Project:
    """Return the project of one wall, everything inferred that the file does not say."""
    folder = file.with_name("project")
    import_file(file, folder, FLAT)
    assert infer_project(folder, rules=Path(PANEL_RULES), write=True).is_written
    return open_project(folder)


@pytest.fixture(scope="module")
def plan(project: Project) -> PlanReport:
    return plan_project(project)


def targets(project: Project) -> list[Component]:
    return [c for c in project.model.component_by_id.values() if c.layer is Layer.TARGET]


def test_the_file_of_the_example_is_the_one_that_is_planned_here(file: Path) -> None:
    example = example_folder("wall_panel") / "walls.ifc"
    data = [f.read_text(encoding="utf-8").split("DATA;")[1] for f in (example, file)]
    assert data[0] == data[1]


def test_all_walls_at_once_are_no_panel_and_the_groups_are_named(file: Path) -> None:
    with pytest.raises(
        ImportOptionError, match=r"no panel\. Name one panel with --group: W-01, W-"
    ):
        read_design(file, ImportOptions(lays_flat=True))
    with pytest.raises(ImportOptionError, match="Did you mean W-0"):
        read_design(file, ImportOptions(lays_flat=True, group="W-1"))
    with pytest.raises(ImportOptionError, match="add --lay-flat"):
        read_design(file, ImportOptions(is_turned_over=True))


def test_one_wall_is_built_and_the_other_one_only_drawn(project: Project) -> None:
    drawn = {
        c.group for c in project.model.component_by_id.values() if c.layer is Layer.AS_DESIGNED
    }
    assert ({c.group for c in targets(project)}, drawn) == ({"W-01"}, {"W-02"})
    assert len(targets(project)) == 5


def test_it_lies_on_the_table_whole_and_the_check_finds_no_error(project: Project) -> None:
    assert [str(p) for p in check(project.folder) if p.severity == "E"] == []
    placed = [
        extent_of(shape_of(c), project.cell.world_T_model @ c.world_T_component)
        for c in targets(project)
    ]
    top = project.cell.world_T_model @ project.model.site_T_model.inverse()
    assert all(p.low_m[2] == pytest.approx(top.position_m[2], abs=1e-6) for p in placed)
    assert all(p.size_m[2] == pytest.approx(0.095, abs=1e-6) for p in placed)


def test_plates_are_nailed_into_the_ends_of_the_studs_level_and_from_outside(
    project: Project,
) -> None:
    names = {c.id: c.name for c in targets(project)}
    found = set()
    for component in targets(project):
        for operation in component.operations:
            through, into = (names[i] for i in operation.on)
            pose = project.cell.world_T_model @ component.world_T_component
            nail = pose @ operation.component_T_operation
            outside = 1.0 if through == "top plate" else -1.0
            assert nail.z_axis == pytest.approx((0.0, -outside, 0.0), abs=1e-9)
            assert nail.position_m[1] == pytest.approx(outside * 1.245, abs=1e-6)
            found.add((through, into))
    assert found == {(p, f"stud {n}") for p in ("bottom plate", "top plate") for n in (1, 2, 3)}
    assert sum(len(c.operations) for c in targets(project)) == 12


def test_every_member_is_planned_with_all_its_nails(plan: PlanReport, project: Project) -> None:
    assert (plan.targets_planned, plan.targets_total) == (5, 5)
    steps = [s for p in plan.planned for s in p.proposal.steps]
    driven = [s.call.arguments[0] for s in steps if s.call.skill == Skill.FASTEN]
    assert sorted(driven) == sorted(o.id for c in targets(project) for o in c.operations)
    order = [p.proposal.target for p in plan.planned]
    assert order == list(target_queue(graph_of(project.model, project.cell)))


def test_each_nail_is_shot_through_the_plate_into_the_stud(
    plan: PlanReport, project: Project
) -> None:
    """Whichever of the two came last: the driver is told the pieces that the design means."""
    made_of, shots = {}, {}
    for planned in plan.planned:
        for step in planned.proposal.steps:
            if step.call.skill == Skill.POSITION:
                made_of[step.call.arguments[1]] = step.call.arguments[0]
            if step.call.skill == Skill.FASTEN:
                shots[step.call.arguments[0]] = (step.params["through"], step.params["into"])
    wanted = {o.id: tuple(made_of[i] for i in o.on) for c in targets(project) for o in c.operations}
    assert shots == wanted
    owners_last = {o.on[0] == c.id for c in targets(project) for o in c.operations}
    assert owners_last == {True, False}, "both ways occur"


def test_what_was_measured_lying_is_written_where_it_stands_in_the_drawing(
    project: Project, file: Path, tmp_path: Path
) -> None:
    up_m = 0.004
    records = [
        InstallRecord(
            target=c.id,
            material=piece_id(c.id),
            world_T_measured=translation(0.0, 0.0, up_m)
            @ project.cell.world_T_model
            @ c.world_T_component,
            installed_at=NOW,
        )
        for c in targets(project)
    ]
    built = fold(project.model, records)
    states = object_states(project.model, built, project.cell.world_T_model)
    out = tmp_path / "walls_asbuilt.ifc"
    export_ifc(file, states, out, written_at=NOW)
    drawing = ifcopenshell.open(str(out))
    walls = {w.Name: w for w in drawing.by_type("IfcWall")}
    front = -get_local_placement(walls["W-01"].ObjectPlacement)[:3, 1]
    members = walls["W-01"].IsDecomposedBy[0].RelatedObjects
    assert len(members) == 5
    for member in members:
        told = get_psets(member)["Sitewright_Construction"]
        (solid,) = member.Representation.Representations[0].Items
        frame = get_local_placement(member.ObjectPlacement)
        centre_m = (frame[:3, 3] + frame[:3, 2] * solid.Depth / 2.0) / 1000.0
        measured_m = [float(x) for x in told["MeasuredCentreM"].split()]
        assert measured_m == pytest.approx(centre_m + front * up_m, abs=2e-6)
        assert told["DeviationMm"] == pytest.approx(1000.0 * up_m, abs=1e-3)
    for member in walls["W-02"].IsDecomposedBy[0].RelatedObjects:
        assert "Sitewright_Construction" not in get_psets(member)


def test_the_same_file_again_differs_in_nothing_and_needs_no_options_again(
    project: Project, file: Path
) -> None:
    found = reimport_file(file, project.folder, ImportOptions())
    assert (found.changes, found.conflicts) == ((), ())
    assert found.after.site_T_model == project.model.site_T_model


def test_nothing_is_in_its_neighbours_way_on_the_table(project: Project) -> None:
    world = [
        extent_of(shape_of(c), project.cell.world_T_model @ c.world_T_component)
        for c in targets(project)
    ]
    for one, other in combinations(world, 2):
        gaps = [max(one.low_m[k] - other.high_m[k], other.low_m[k] - one.high_m[k]) for k in (0, 1)]
        assert max(gaps) > -1e-6
