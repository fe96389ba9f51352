"""Hostile files meet the import command: one clear error each, nothing left, little memory."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from builders_foreign import OBJ
from hostile_inputs import Hostile, rows
from sitewright.app.importing import import_file
from sitewright.errors import ModelRejectedError

MAX_MB = 300.0
MAX_CHARS = 4_000
_SERVER = """
import contextlib, io, json, resource, sys
sys.path[:] = json.loads(sys.argv[1])
from sitewright.building_model.formats import import_process
from sitewright.cli.main import exit_code

def peak_mb():
    status = open("/proc/self/status").read()  # rusage of a new process holds its parent's memory
    own = int(status.partition("VmHWM:")[2].split()[0])
    return max(own, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss) / 1000.0

for line in sys.stdin:
    said, quiet = io.StringIO(), contextlib.redirect_stdout(io.StringIO())
    with quiet, contextlib.redirect_stderr(said):
        code = exit_code(json.loads(line))
    print(json.dumps({"code": code, "said": said.getvalue(), "peak_mb": peak_mb()}), flush=True)
"""


@dataclass(frozen=True, slots=True)
class Importer:
    """A process that runs commands one after the other, so that its memory is its own."""

    process: subprocess.Popen[str]

    def run(self, *arguments: str) -> dict[str, Any]:
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(json.dumps(arguments) + "\n")
        self.process.stdin.flush()
        answer: dict[str, Any] = json.loads(self.process.stdout.readline())
        return answer


@pytest.fixture(scope="module")
def importer() -> Iterator[Importer]:
    command = [sys.executable, "-c", _SERVER, json.dumps(sys.path)]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        yield Importer(process)
        process.kill()


@pytest.mark.parametrize("row", list(rows()), ids=lambda row: row.id)
def test_a_hostile_file_is_one_clear_error_and_leaves_nothing(
    importer: Importer, tmp_path: Path, row: Hostile
) -> None:
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


def test_what_is_no_ordinary_file_is_refused(importer: Importer, tmp_path: Path) -> None:
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
    importer: Importer, tmp_path: Path, where: str
) -> None:
    (tmp_path / "file").write_bytes(OBJ)
    answer = importer.run(
        "import", str(tmp_path / "file"), "--unit", "m", "-o", str(tmp_path / where)
    )
    assert answer["code"] in {2, 3}, answer["said"]
    assert "bug" not in answer["said"]
    assert [p.name for p in tmp_path.iterdir()] == ["file"]
