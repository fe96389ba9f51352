"""Writes moved robots and stock places into a cell file: the rest of it, comments too, stays."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import tomlkit

from sitewright.app.locks import locked
from sitewright.app.model_writing import refuse_open_run
from sitewright.app.project import Project, ProjectError
from sitewright.errors import SitewrightError
from sitewright.foundation.pose import Pose
from sitewright.journal.blobs import write_whole
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.formats.cell_toml import read_cell

_KEYS = {"robot": "world_T_base", "stock_place": "world_T_stock", "fixture": "world_T_fixture"}
_STATION = ("station", "world_T_station")
_DIGITS = 10
_SAME_M, _SAME_RAD = 1e-6, 1e-6


def write_cell(project: Project, changed: Cell) -> Path:
    """Put a changed cell's poses into the project's cell file; return where the old one is kept.

    Args:
        project: With the cell that its file holds.
        changed: The same cell with robots, stock places, fixtures and stations elsewhere.

    Raises:
        OpenRunError: A run is not finished.
        ProjectError: The file was changed meanwhile.
        SitewrightError: The changed file does not mean what it should.
    """
    file = project.cell_file
    backup = file.with_name(f"{file.name}.bak")
    with locked(project.folder / "runs" / "lock", "The project"):
        refuse_open_run(project.folder, project.model)
        data = file.read_bytes()
        if _poses(read_cell(file)) != _poses(project.cell):
            raise ProjectError(f"{file} was changed meanwhile. Try again.")
        text = with_poses(data.decode("utf-8-sig"), project.cell, changed)
        _require_meant(file, text, changed)
        write_whole(backup, data)
        write_whole(file, text.encode())
    return backup


def with_poses(text: str, before: Cell, after: Cell) -> str:
    """Return a cell file with the poses that differ between two cells changed."""
    document = tomlkit.parse(text)
    old = _poses(before)
    for (kind, name), pose in _poses(after).items():
        if pose == old[kind, name]:
            continue
        for table in document.get(kind, []):
            if table["id"] == name:
                key = _STATION[1] if kind == _STATION[0] else _KEYS[kind]
                if kind != _STATION[0] or key in table:
                    _set_pose(table, key, pose)
    return tomlkit.dumps(document)


def _set_pose(table: Any, key: str, pose: Pose) -> None:  # noqa: ANN401 - what tomlkit parses to
    """Change numbers where they stand, so that all around them stays as it was written."""
    if key not in table:
        table[key] = tomlkit.inline_table()
    rows = {"p_m": pose.position_m, "q_wxyz": pose.quaternion_wxyz}
    for name, values in rows.items():
        numbers = [round(v, _DIGITS) + 0.0 for v in values]
        if name not in table[key]:
            if numbers != [1.0, 0.0, 0.0, 0.0]:
                table[key][name] = numbers
            continue
        for k, number in enumerate(numbers):
            if abs(float(table[key][name][k]) - number) > 10.0**-_DIGITS:
                table[key][name][k] = number


def _poses(cell: Cell) -> Mapping[tuple[str, str], Pose]:
    return dict(_all_poses(cell))


def _all_poses(cell: Cell) -> Iterator[tuple[tuple[str, str], Pose]]:
    for robot in cell.robot_by_id.values():
        yield ("robot", robot.id), robot.world_T_base
    for place in cell.stock_place_by_id.values():
        yield ("stock_place", place.id), place.world_T_stock
    for fixture in cell.fixture_by_id.values():
        yield ("fixture", fixture.id), fixture.world_T_fixture
    for station in cell.station_by_id.values():
        yield ("station", station.id), station.world_T_station


def _require_meant(file: Path, text: str, expected: Cell) -> None:
    """Read the new text back before anything is written; URDF paths are relative to its place."""
    trial = file.with_name(f".{file.name}.trial")
    try:
        trial.write_text(text, encoding="utf-8")
        found = _poses(read_cell(trial))
    finally:
        trial.unlink(missing_ok=True)
    for key, pose in _poses(expected).items():
        other = found.get(key)
        if (
            other is None
            or other.distance_to_m(pose) > _SAME_M
            or other.angle_to_rad(pose) > _SAME_RAD
        ):
            raise SitewrightError(f"The changed {file.name} would not mean what it should: {key}.")
