"""Options of an import: each is honoured or refused for each kind of file, none is passed over."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from sitewright.app.import_options import REFUSED, ImportOptionError, demand_meaning
from sitewright.app.importing import ImportOptions, read_design
from sitewright.building_model.formats.detect import FileKind
from sitewright.building_model.formats.foreign_files import READERS
from sitewright.cli.main import commands

EXAMPLE = Path(__file__).parents[2] / "examples" / "wooden_frame" / "building.json"
OPTIONS = {
    "--unit": ["--unit", "mm"],
    "--map": ["--map", "import.toml"],
    "--repair": ["--repair", "hull"],
    "--split": ["--split"],
    "--group": ["--group", "panel A"],
    "--lay-flat": ["--lay-flat"],
    "--turn-over": ["--turn-over"],
}


@pytest.mark.parametrize("option", OPTIONS)
def test_a_native_building_takes_no_option_and_says_so(option: str, tmp_path: Path) -> None:
    given = OPTIONS[option]
    out = tmp_path / "p"
    run = CliRunner().invoke(commands, ["import", str(EXAMPLE), *given, "-o", str(out), "--json"])
    assert isinstance(run.exception, ImportOptionError)
    assert run.exception.exit_code == 2
    assert f"takes no {option} (" in str(run.exception)
    assert not out.exists()


def test_every_kind_that_is_read_honours_the_options_that_it_does_not_refuse() -> None:
    for kind in (*READERS, FileKind.NATIVE):
        refused = REFUSED.get(kind, {})
        demand_meaning(kind, [name for name in OPTIONS if name not in refused])
        for name in refused:
            with pytest.raises(ImportOptionError, match=name):
                demand_meaning(kind, [name])


def test_all_options_that_mean_nothing_are_named_at_once() -> None:
    with pytest.raises(ImportOptionError, match=r"--repair \(.*\) and --split \("):
        demand_meaning(FileKind.BTLX, ["--unit", "--repair", "--split"])


def test_a_map_reaches_the_beams_of_a_timber_frame(shared_data: Path, tmp_path: Path) -> None:
    pytest.importorskip("compas_timber", reason="needs the extra [timber]")
    words = tmp_path / "import.toml"
    words.write_text('[user_text]\ngroup = "category"\n', encoding="utf-8")
    file = shared_data / "timber" / "frame_house.json"
    _, model, _ = read_design(file, ImportOptions(unit="mm", map_file=words))
    assert {c.group for c in model.component_by_id.values()} > {"window", "floor"}


def test_a_map_reaches_the_bars_of_a_frame(shared_data: Path, tmp_path: Path) -> None:
    words = tmp_path / "import.toml"
    words.write_text('[user_text]\norder = "layer_id"\n', encoding="utf-8")
    file = tmp_path / "bars.json"
    document = json.loads((shared_data / "bars" / "four_frame.json").read_text())
    for number, element in enumerate(document["element_list"], 1):
        element["layer_id"] = number
    file.write_text(json.dumps(document))
    _, model, _ = read_design(file, ImportOptions(map_file=words))
    assert sorted(c.order or 0 for c in model.component_by_id.values()) == [1, 2, 3, 4]
