"""A Rhino file as a project: its notes follow the file, its own layer names come back."""

from __future__ import annotations

from pathlib import Path

import pytest

from builders_history import built, wrote_run
from builders_rhino import Drawing, brep_box
from sitewright.app.built_state import state_at
from sitewright.app.checking import check
from sitewright.app.exporting import Export, export_as
from sitewright.app.importing import ImportOptions, import_file
from sitewright.app.reimporting import Wishes, reimport_file
from sitewright.building_model.formats.rhino import read_rhino
from sitewright.building_model.formats.rhino_export import ForeignDrawingError
from sitewright.foundation.ids import ComponentId

pytest.importorskip("rhino3dm", reason="needs rhino3dm: pip install 'sitewright[rhino]'")

FORMULA = '%<Volume("x","False")>%'


def beam(path: Path, *, volume: str, shift_mm: float = 0.0) -> Path:
    """Draw one beam whose attribute holds a value or a formula."""
    drawing = Drawing()
    shape = brep_box((0, 0, 0), (2000, 80, 120 + shift_mm))
    text = {"sitewright.id": "beam", "sitewright.ground": "yes", "volume": volume}
    drawing.add(shape, layer="Target::Beams", text=text)
    return drawing.write(path)


def told(folder: Path) -> set[str]:
    """Return which notes of the file a check repeats."""
    return {p.code for p in check(folder)} & {"T1", "U2", "G2", "G7"}


def renewed(file: Path, folder: Path) -> bool:
    return reimport_file(file, folder, ImportOptions(), Wishes(write=True)).is_written


def test_what_an_import_said_of_a_file_is_said_until_the_file_is_mended(tmp_path: Path) -> None:
    folder = tmp_path / "project"
    import_file(beam(tmp_path / "v1.3dm", volume=FORMULA), folder)
    assert told(folder) == {"T1"}
    assert renewed(beam(tmp_path / "v2.3dm", volume="0.0192"), folder)
    assert told(folder) == set()
    assert not (folder / "imports" / "notes.json").exists()
    assert renewed(beam(tmp_path / "v3.3dm", volume=FORMULA), folder)
    assert told(folder) == {"T1"}


def test_a_merge_that_is_only_shown_leaves_the_notes_alone(tmp_path: Path) -> None:
    folder = tmp_path / "project"
    import_file(beam(tmp_path / "v1.3dm", volume=FORMULA), folder)
    mended = beam(tmp_path / "v2.3dm", volume="0.0192", shift_mm=5.0)
    assert reimport_file(mended, folder, ImportOptions()).changes
    assert told(folder) == {"T1"}


def ran(folder: Path, targets: list[str]) -> None:
    state = state_at(folder)
    events = []
    for target in targets:
        designed = state.design.component_by_id[ComponentId(target)].world_T_component
        events += built(state.design, target, f"p-{target}", state.world_T_model @ designed)
    wrote_run(folder, "0001-aaaa", *events)


def test_layers_with_names_of_the_users_own_are_exchanged_on_export(tmp_path: Path) -> None:
    drawing = Drawing()
    text = {"sitewright.id": "beam"}
    drawing.add(brep_box((0, 0, 0), (2000, 80, 120)), layer="Zu bauen::Balken", text=text)
    file = drawing.write(tmp_path / "x.3dm")
    words = tmp_path / "import.toml"
    words.write_text('[layers]\n"Zu bauen" = "target"\n', encoding="utf-8")
    import_file(file, tmp_path / "project", ImportOptions(map_file=words))
    ran(tmp_path / "project", ["beam"])
    copy = export_as("rhino", state_at(tmp_path / "project"), original=file).files[0]
    assert [p.layer_path for p in read_rhino(copy).parts] == ["As-Built::Balken"]


@pytest.mark.parametrize(
    ("bodies", "status", "layer"),
    [([1], "partly", "Target::Pair"), ([1, 2], "verified", "As-Built::Pair")],
)
def test_an_object_that_was_split_into_bodies_comes_back_as_one(
    tmp_path: Path, bodies: list[int], status: str, layer: str
) -> None:
    import rhino3dm

    pair = rhino3dm.Mesh()
    for x in (0.0, 5000.0):
        cube = rhino3dm.Mesh()
        for corner in ((0, 0, 0), (900, 0, 0), (0, 900, 0), (0, 0, 900)):
            cube.Vertices.Add(x + corner[0], corner[1], corner[2])
        for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)):
            cube.Faces.AddFace(*face)
        pair.Append(cube)
    drawing = Drawing()
    identity = drawing.add(pair, layer="Target::Pair")
    file = drawing.write(tmp_path / "x.3dm")
    import_file(file, tmp_path / "project", ImportOptions(is_split=True))
    ran(tmp_path / "project", [f"{identity}.{n}" for n in bodies])
    written = export_as("rhino", state_at(tmp_path / "project"), original=file)
    (part,) = read_rhino(written.files[0]).parts
    assert part.user_text["sitewright.status"] == status
    assert part.layer_path == layer
    assert not any("is not in" in note for note in written.notes)


def test_a_drawing_that_was_saved_again_since_is_patched_as_it_is_and_that_is_said(
    tmp_path: Path,
) -> None:
    import rhino3dm

    folder, file = tmp_path / "project", beam(tmp_path / "v1.3dm", volume="1")
    import_file(file, folder)
    ran(folder, ["beam"])
    assert not any("was changed since" in n for n in copied(folder, file).notes)
    model = rhino3dm.File3dm.Read(str(file))
    model.Objects[0].Attributes.SetUserString("seen by", "the checker")
    model.Write(str(file), 8)
    copy = copied(folder, file)
    assert any("v1.3dm was changed since it was imported" in n for n in copy.notes)
    (part,) = read_rhino(copy.files[0]).parts
    assert part.user_text["seen by"] == "the checker"
    assert part.layer_path == "As-Built::Beams"


def test_a_drawing_made_anew_has_other_objects_and_is_refused(tmp_path: Path) -> None:
    folder, file = tmp_path / "project", beam(tmp_path / "v1.3dm", volume="1")
    import_file(file, folder)
    ran(folder, ["beam"])
    with pytest.raises(ForeignDrawingError, match="holds none of the objects"):
        copied(folder, beam(file, volume="1"))


def copied(folder: Path, original: Path) -> Export:
    return export_as("rhino", state_at(folder), original=original)
