"""Ids that sort, locks that die with their process, keys that stay."""

from __future__ import annotations

import os
import stat
from pathlib import Path
from uuid import UUID

import pytest

from builders_run import Clock
from sitewright.app.clock import SystemClock, boot_id
from sitewright.app.ids import UuidSource
from sitewright.app.locks import LockedError, locked
from sitewright.app.run_folder import installation_key, next_run_folder, refuse_network_folder


class Still(Clock):
    """A clock that stands, then goes back."""

    def __init__(self) -> None:
        super().__init__()
        self.looks = 0

    def utc_ns(self) -> int:  # type: ignore[explicit-override]
        self.looks += 1
        return self.now_ns - (10_000_000 if self.looks > 50 else 0)


def test_ids_are_uuids_of_version_7_that_sort_by_creation_whatever_the_clock_does() -> None:
    source = UuidSource(Still())
    ids = [source.new() for _ in range(100)]
    assert ids == sorted(set(ids))
    assert {(UUID(i).version, UUID(i).variant) for i in ids} == {
        (7, "specified in RFC 4122"),
    }


def test_the_monotonic_clock_never_goes_back() -> None:
    clock = SystemClock()
    times = [clock.monotonic_ns() for _ in range(50)]
    assert times == sorted(times)
    assert clock.utc_ns() > 1_600_000_000_000_000_000
    assert boot_id() == boot_id()


def test_a_lock_names_its_holder_and_is_free_after_him(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "lock"
    with (
        locked(path, "The cell"),
        pytest.raises(LockedError, match=f"by process {os.getpid()}"),
        locked(path, "The cell"),
    ):
        pass
    with locked(path, "The cell"):
        pass


def test_a_lock_dies_with_its_process(tmp_path: Path) -> None:
    path, (reader, writer) = tmp_path / "lock", os.pipe()
    child = os.fork()
    if child == 0:  # pragma: no cover -- another process
        with locked(path, "The cell"):
            os.write(writer, b"x")
            os.close(writer)
            os.kill(os.getpid(), 9)
    assert os.read(reader, 1) == b"x"
    os.waitpid(child, 0)
    os.close(reader)
    os.close(writer)
    with locked(path, "The cell"):
        pass


def test_the_installation_key_is_made_once_and_private(tmp_path: Path) -> None:
    key = installation_key(tmp_path / "state")
    assert len(key) == 32
    assert installation_key(tmp_path / "state") == key
    assert stat.S_IMODE((tmp_path / "state" / "approval.key").stat().st_mode) == 0o600


def test_run_folders_are_numbered_and_sort(tmp_path: Path) -> None:
    names = []
    for _ in range(12):
        folder = next_run_folder(tmp_path)
        folder.create()
        names.append(folder.run)
    assert names == sorted(names)
    assert names[-1].startswith("0012-")


def test_a_local_folder_is_no_network_folder(tmp_path: Path) -> None:
    refuse_network_folder(tmp_path)
