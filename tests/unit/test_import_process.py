"""The child process of the importers: whatever it does, the parent gets a value and a reason."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitewright.building_model.formats.import_process import ChildFailed, Limits, run_reader

SMALL = Limits(memory_bytes=1024**3, cpu_s=1, wall_s=20.0)


def test_a_good_reader_is_heard(tmp_path: Path) -> None:
    assert run_reader("crashing_reader", tmp_path / "good", SMALL) == {"answer": 42}


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("crash", "was ended by SIGSEGV"),
        ("cpu", "was ended by SIG"),
        ("memory", "stopped with: MemoryError"),
        ("half", "gave no complete answer"),
        ("disk", "File too large"),
    ],
)
def test_a_bad_reader_is_told_by_what_ended_it(tmp_path: Path, name: str, reason: str) -> None:
    answer = run_reader("crashing_reader", tmp_path / name, SMALL)
    assert isinstance(answer, ChildFailed)
    assert reason in answer.reason


def test_a_reader_that_hangs_is_stopped(tmp_path: Path) -> None:
    answer = run_reader("crashing_reader", tmp_path / "hang", Limits(wall_s=1.0))
    assert answer == ChildFailed("took longer than 1 s")


def test_a_reader_that_does_not_exist_is_no_crash_of_ours(tmp_path: Path) -> None:
    answer = run_reader("no_such_reader", tmp_path / "x", SMALL)
    assert isinstance(answer, ChildFailed)
    assert "no_such_reader" in answer.reason
