"""Hostile files meet the import command: one clear error each, nothing left, little memory."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from builders_foreign import OBJ
from command_server import CommandServer, command_server
from hostile_inputs import Hostile, rows
from sitewright.app.importing import import_file
from sitewright.errors import ModelRejectedError

MAX_MB = 300.0
MAX_CHARS = 4_000


@pytest.fixture(scope="module")
def importer() -> Iterator[CommandServer]:
    with command_server() as server:
        yield server


@pytest.mark.parametrize("row", list(rows()), ids=lambda row: row.id)
def test_a_hostile_file_is_one_clear_error_and_leaves_nothing(
    importer: CommandServer, tmp_path: Path, row: Hostile
) -> None:
    if row.id.startswith("compas_timber"):
        pytest.importorskip("compas_timber", reason="needs the extra 'timber'")
    file = tmp_path / row.name
    file.write_bytes(row.content)
    answer = importer.run("import", str(file), "-o", str(tmp_path / "out"), *row.options)
    said = answer["said"]
    assert answer["code"] == row.exit_code, said[:MAX_CHARS]
    if row.exit_code:
        assert [p.name for p in tmp_path.iterdir()] == [row.name]
        assert said.startswith("error: ")
    assert all(words in said for words in row.says), said[:MAX_CHARS]
    assert len(said) < MAX_CHARS
    assert "Traceback" not in said
    assert "bug" not in said
    assert answer["peak_mb"] < MAX_MB


def test_what_is_no_ordinary_file_is_refused(importer: CommandServer, tmp_path: Path) -> None:
    pipe, loop, out = tmp_path / "pipe.3dm", tmp_path / "loop.ifc", tmp_path / "out"
    os.mkfifo(pipe)
    loop.symlink_to(loop)
    long = tmp_path / ("x" * 300)
    said = {
        pipe: "no ordinary file",
        loop: "symbolic links",
        long: "File name too long",
        tmp_path / "lost.obj": "no such file",
        Path("/dev/zero"): "no ordinary file",
        Path("/proc/self/environ"): "empty",
    }
    for path, words in said.items():
        answer = importer.run("import", str(path), "-o", str(out))
        assert answer["code"] == 3, path
        assert f"E E2 {path.name}" in answer["said"]
        assert words in answer["said"]
    answer = importer.run("import", str(tmp_path), "-o", str(out))
    assert answer["code"] == 2
    assert "is a directory" in answer["said"]
    assert not out.exists()


def test_a_file_that_may_not_be_read_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "a.obj"
    file.write_bytes(OBJ)

    def denied(_: Path) -> bytes:  # chmod does not stop root
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "read_bytes", denied)
    with pytest.raises(ModelRejectedError, match=r"E2 a\.obj: it cannot be read: Permission"):
        import_file(file, tmp_path / "out")


@pytest.mark.parametrize("where", ["file/out", "file", "/proc/1/out", "x" * 300])
def test_a_place_that_cannot_be_written_is_an_error_and_no_bug(
    importer: CommandServer, tmp_path: Path, where: str
) -> None:
    (tmp_path / "file").write_bytes(OBJ)
    answer = importer.run(
        "import", str(tmp_path / "file"), "--unit", "m", "-o", str(tmp_path / where)
    )
    assert answer["code"] in {2, 3}, answer["said"]
    assert "bug" not in answer["said"]
    assert [p.name for p in tmp_path.iterdir()] == ["file"]
