"""A project is made whole or not at all, and keeps what its file says of itself."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitewright.app import importing
from sitewright.app.import_records import imported_source, read_record
from sitewright.app.importing import ImportOptions, import_file
from sitewright.app.project import ProjectError
from sitewright.building_model.formats.native import read_building
from sitewright.journal.blobs import write_whole

CORNERS = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
FACES = "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"


@pytest.fixture
def block(tmp_path: Path) -> Path:
    file = tmp_path / "block.obj"
    file.write_text(f"o block\n{CORNERS}{FACES}", encoding="ascii")
    return file


@pytest.mark.parametrize("dies_at", range(1, 4))
@pytest.mark.parametrize("exists", [False, True])
def test_an_import_that_dies_leaves_no_project(
    block: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    dies_at: int,
    exists: bool,  # noqa: FBT001
) -> None:
    out, count = tmp_path / "project", 0
    if exists:
        out.mkdir()

    def dying(path: Path, data: bytes) -> None:
        nonlocal count
        count += 1
        if count == dies_at:
            raise OSError("the disk is full")
        write_whole(path, data)

    monkeypatch.setattr(importing, "write_whole", dying)
    with pytest.raises(ProjectError, match="full"):
        import_file(block, out, ImportOptions(unit="m"))
    assert out.exists() == exists
    assert not (out / "building.json").exists()
    assert [p.name for p in tmp_path.iterdir() if p.name.startswith(".")] == []
    monkeypatch.undo()
    assert import_file(block, out, ImportOptions(unit="m")).targets_total == 1


def test_what_was_read_and_how_is_kept(tmp_path: Path) -> None:
    ifc = pytest.importorskip("builders_ifc", reason="needs the extra 'ifc'")
    words = tmp_path / "words.toml"
    words.write_text("[layers]\n", encoding="utf-8")
    out = tmp_path / "project"
    panel = ifc.wall_panel().write(tmp_path / "panel.ifc")
    import_file(panel, out, ImportOptions(unit="m", map_file=words))
    model = read_building(out / "building.json")
    source = imported_source(model)
    assert source is not None
    assert source.options["unit"] == "m"
    kept = str(source.options["map_file"])
    assert (out / kept).read_bytes() == words.read_bytes()
    assert read_record(out, source).component_by_id == model.component_by_id


def test_where_an_ifc_file_lies_on_earth_is_kept(tmp_path: Path) -> None:
    ifc = pytest.importorskip("builders_ifc", reason="needs the extra 'ifc'")
    draft = ifc.wall_panel()
    crs = draft.file.create_entity("IfcProjectedCRS", Name="EPSG:25832")
    draft.file.create_entity(
        "IfcMapConversion",
        SourceCRS=draft.context,
        TargetCRS=crs,
        Eastings=691000.0,
        Northings=5335000.0,
        OrthogonalHeight=519.5,
    )
    file = draft.write(tmp_path / "panel.ifc")
    import_file(file, tmp_path / "project")
    model = read_building(tmp_path / "project" / "building.json")
    survey = model.raw["survey"]
    assert survey == {
        "Eastings": 691000.0,
        "Northings": 5335000.0,
        "OrthogonalHeight": 519.5,
        "crs": "EPSG:25832",
    }
