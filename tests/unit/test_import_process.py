"""The child process of the importers: whatever it does, the parent gets a value and a reason."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import psutil
import pytest

from sitewright.building_model.formats.detect import FileKind
from sitewright.building_model.formats.foreign_files import (
    IMPORT_LIMITS,
    READERS,
    read_foreign,
)
from sitewright.building_model.formats.import_process import (
    ChildFailed,
    Limits,
    answer_about,
    run_child,
)
from sitewright.errors import ModelRejectedError

SMALL = Limits(memory_bytes=1024**3, cpu_s=1, wall_s=20.0)
READER = "crashing_reader:read"


def said(manner: str, path: Path = Path("x"), limits: Limits = SMALL) -> str:
    answer = run_child(READER, manner, str(path), limits=limits)
    assert isinstance(answer, ChildFailed)
    return answer.reason


def children() -> list[str]:
    return [p.name() for p in psutil.Process().children(recursive=True)]


def asked(manner: str) -> dict[str, object]:
    return dict(answer_about(Path("x"), READER, manner, "x", limits=SMALL))


def test_a_good_reader_is_heard_and_nothing_is_left_of_it() -> None:
    before = children()
    assert asked("good") == {"text": 42}
    assert children() == before


def test_what_a_library_prints_is_no_part_of_the_answer() -> None:
    assert asked("print") == {"text": 42}


@pytest.mark.parametrize(
    ("manner", "reason"),
    [
        ("crash", "was ended by SIGSEGV"),
        ("cpu", "used more than 1 s of processor time"),
        ("memory", "needs more than 1 GB of memory"),
        ("files", "Too many open files"),
        ("half", "gave no complete answer"),
        ("nan", "Out of range float"),
    ],
)
def test_a_bad_reader_is_told_by_what_ended_it(manner: str, reason: str) -> None:
    assert reason in said(manner)


def test_a_limit_that_was_hit_is_named_with_the_way_to_raise_it(tmp_path: Path) -> None:
    small = replace(IMPORT_LIMITS, memory_bytes=1024**3)
    with pytest.raises(
        ModelRejectedError, match=r"needs more than 1 GB of memory\. Export .* --reader-gb 8"
    ):
        answer_about(tmp_path / "a.obj", READER, "memory", "x", limits=small)


def test_a_reader_cannot_get_out_of_its_limits(tmp_path: Path) -> None:
    answer = answer_about(tmp_path, READER, "escape", str(tmp_path / "x"), limits=SMALL)
    assert answer["worked"] == []
    assert answer["isolated"] == 1
    assert answer["limits"] == {"AS": 1024**3, "CPU": 1, "FSIZE": 0, "NOFILE": 256, "CORE": 0}
    assert not (tmp_path / "escaped").exists() or (tmp_path / "escaped").stat().st_size == 0


@pytest.mark.parametrize("kind", READERS)
def test_every_foreign_kind_is_read_by_a_child_under_the_same_limits(
    kind: FileKind, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    started: list[list[str]] = []
    popen = subprocess.Popen

    def watched(command: list[str], **more: Any) -> Any:
        started.append(command)
        assert "PYTHONPATH" not in more["env"]
        return popen(command, **more)

    monkeypatch.setattr(subprocess, "Popen", watched)
    file = tmp_path / "bad"
    file.write_bytes(b"v 1\n")
    with pytest.raises(ModelRejectedError):
        read_foreign(file, kind)
    (command,) = started
    limits = f"{os.getpid()},{4 * 1024**3},60,0,256"
    assert command[1] == "-I"
    assert limits in command
    assert command[-2:] == [str(kind), str(file)]


def test_a_reader_may_not_write_a_single_byte(tmp_path: Path) -> None:
    file = tmp_path / "written"
    assert "File too large" in said("disk", file)
    assert not file.exists() or file.stat().st_size == 0


def test_a_reader_that_was_given_room_may_write(tmp_path: Path) -> None:
    file = tmp_path / "written"
    roomy = Limits(written_bytes=1000)
    assert run_child(READER, "disk", str(file), limits=roomy) == {"answer": {"text": 42}}
    assert file.read_bytes() == b"x"


@pytest.mark.parametrize("manner", ["hang", "deaf", "breed"])
def test_a_reader_that_does_not_end_is_stopped_with_all_that_it_started(manner: str) -> None:
    before = children()
    assert said(manner, limits=Limits(wall_s=0.5)) == "took longer than 0.5 s"
    assert children() == before
    assert not any("sleep" in name for name in children())


def test_an_endless_answer_is_not_listened_to() -> None:
    said_of_it = said("talk", limits=Limits(answer_bytes=1_000_000))
    assert said_of_it == "answered with more than 1000000 bytes"


def test_a_reader_that_does_not_exist_is_no_crash_of_ours() -> None:
    answer = run_child("no_such_reader:read", limits=SMALL)
    assert isinstance(answer, ChildFailed)
    assert "no_such_reader" in answer.reason


def test_a_refusal_comes_over_as_it_was_raised(tmp_path: Path) -> None:
    file = tmp_path / "a.obj"
    with pytest.raises(ModelRejectedError) as rejected:
        answer_about(file, READER, "refuse", str(file), limits=SMALL)
    (problem,) = rejected.value.problems
    assert str(problem) == "E E3 a.obj: it is another kind. Take the right one."


def test_a_dead_reader_is_a_refusal_that_names_the_file(tmp_path: Path) -> None:
    with pytest.raises(
        ModelRejectedError, match=r"a\.obj: the reader was ended by SIGSEGV\. Check"
    ):
        answer_about(tmp_path / "a.obj", READER, "crash", "x", limits=SMALL)


def test_a_reader_is_isolated_from_folder_and_environment(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("PYTHONPATH", "/somewhere/else")
    monkeypatch.setenv("PYTHONSTARTUP", "/somewhere/else.py")
    answer = asked("where")
    assert answer["folder"] == "/"
    assert "/somewhere/else" not in str(answer["path"])


def _may_leave_network() -> bool:
    """Ask in a process of its own whether the kernel lets us."""
    code = (
        "import sys; from sitewright.building_model.formats.import_child import leave_network; "
        "sys.exit(not leave_network())"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    return (
        subprocess.run([sys.executable, "-c", code], env=environment, check=False).returncode == 0
    )


def test_a_reader_sees_no_network_where_the_kernel_lets_us_cut_it_off() -> None:
    seen = asked("network")["interfaces"]
    if not _may_leave_network():
        pytest.skip("needs leave to make network namespaces; here the kernel denies it")
    assert seen in ([], ["lo"])  # its own loopback, which is down


_WAITING = """
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may have started us without
sys.path[:] = sys.argv[1].split(":")
from sitewright.building_model.formats.import_process import Limits, run_child
run_child("crashing_reader:read", "hang", "x", limits=Limits(wall_s=60.0))
"""


@pytest.mark.parametrize("signum", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_the_reader_dies_with_its_parent(signum: int) -> None:
    path = ":".join(str(Path(p).absolute()) for p in sys.path if p)
    with subprocess.Popen(
        [sys.executable, "-c", _WAITING, path], stderr=subprocess.DEVNULL
    ) as parent:
        child = _child_named(parent.pid, "hanging-reader")
        parent.send_signal(signum)
        parent.wait(timeout=10.0)
    _, alive = psutil.wait_procs([child], timeout=10.0)
    assert alive == []


def _child_named(parent: int, name: str) -> psutil.Process:
    for _ in range(1000):
        found = [c for c in psutil.Process(parent).children() if c.name() == name]
        if found:
            return found[0]
        time.sleep(0.01)
    raise AssertionError("the child never came up")
