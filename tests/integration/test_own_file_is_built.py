"""A file of one's own making, drawn anywhere, is imported, completed and built in simulation."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sitewright.cli.main import exit_code

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]

_FACES = ((1, 4, 3, 2), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8))


def solid(name: str, low: tuple[float, float, float], high: tuple[float, float, float]) -> str:
    """Return an OBJ object, a box of eight corners; faces count corners from the last ones."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    corners = [(x, y, z) for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
    lines = [f"o {name}", *(f"v {x} {y} {z}" for x, y, z in corners)]
    lines += ["f " + " ".join(str(k - 9) for k in face) for face in _FACES]
    return "\n".join(lines)


def test_an_obj_drawn_anywhere_is_built(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    drawn = tmp_path / "shed.obj"
    sill = solid("sill", (10.0, 5.0, 1.0), (10.1, 7.0, 1.06))
    post = solid("post", (10.0, 5.0, 1.06), (10.1, 5.1, 2.0))
    drawn.write_text(f"{sill}\n{post}\n", encoding="utf-8")
    project = str(tmp_path / "shed")
    assert exit_code(["import", str(drawn), "--unit", "m", "-o", project]) == 0
    assert exit_code(["infer", project, "--write"]) == 0
    assert exit_code(["check", project]) == 0
    capsys.readouterr()
    assert exit_code(["run", project, "--approve", "auto", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["targets_installed"] == told["targets_total"] == 2
    assert told["unallowed_contacts"] == 0
