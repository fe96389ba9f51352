"""The SQLite journal: append-only, chained, and honest about a bad disk."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import apsw
import pytest
from typing_extensions import override

from sitewright.journal.blobs import BlobStore
from sitewright.journal.errors import (
    JournalBusyError,
    JournalCorruptError,
    JournalFullError,
    JournalTooNewError,
    RefusedByJournalError,
)
from sitewright.journal.record import GENESIS, Entry, broken_link
from sitewright.journal.sqlite import SqliteJournal, read_records


def entry(number: int = 1, kind: str = "run_started", **body: object) -> Entry:
    return Entry(
        event_id=f"event-{number}",
        run_id="run-1",
        t_utc_ns=number,
        t_mono_ns=number,
        boot_id="boot",
        actor="controller",
        kind=kind,
        version=1,
        body={"number": number, **body},  # type: ignore[dict-item]
    )


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "journal.db"


@pytest.fixture
def filled(path: Path) -> Path:
    with SqliteJournal(path) as journal:
        for number in range(1, 21):
            journal.append(entry(number, text="x" * 200))
    return path


def test_what_was_appended_is_read_back_in_order(path: Path) -> None:
    with SqliteJournal(path) as journal:
        first, second = journal.append(entry(1)), journal.append(entry(2, text="hoch ü"))
        assert list(journal.records()) == [first, second]
    with SqliteJournal(path) as journal:
        assert list(journal.records()) == [first, second]
        assert journal.head == second.hash
    assert read_records(path) == (first, second)
    assert second.value() == {"number": 2, "text": "hoch ü"}
    assert (first.prev, second.prev) == (GENESIS, first.hash)


@pytest.mark.parametrize(
    "statement",
    [
        "UPDATE event SET body = '{}' WHERE seq = 1",
        "DELETE FROM event WHERE seq = 1",
        """INSERT OR REPLACE INTO event SELECT 1, 'other', run_id, t_utc_ns, t_mono_ns, boot_id,
        actor, kind, version, body, prev, hash FROM event WHERE seq = 1""",
    ],
)
def test_the_database_refuses_to_change_a_record(path: Path, statement: str) -> None:
    with SqliteJournal(path) as journal:
        journal.append(entry(1))
        with pytest.raises(apsw.ConstraintError):
            journal._db.execute(statement).fetchall()


def test_a_second_intent_or_outcome_of_a_command_is_refused_by_the_database(path: Path) -> None:
    with SqliteJournal(path) as journal:
        journal.append(entry(1, "skill_intent", command_id="c", approval_id="a", step=1))
        journal.append(entry(2, "skill_outcome", command_id="c"))
        with pytest.raises(RefusedByJournalError):
            journal.append(entry(3, "skill_intent", command_id="c", approval_id="b", step=1))
        with pytest.raises(RefusedByJournalError):
            journal.append(entry(4, "skill_outcome", command_id="c"))
        with pytest.raises(RefusedByJournalError):
            journal.append(entry(5, "skill_intent", command_id="d", approval_id="a", step=1))
        journal.append(entry(6, "skill_intent", command_id="d", approval_id="a", step=2))
        assert [r.seq for r in journal.records()] == [1, 2, 3]


def test_a_body_that_is_too_long_is_refused_before_the_disk(path: Path) -> None:
    with SqliteJournal(path) as journal, pytest.raises(ValueError, match="65536"):
        journal.append(entry(1, text="x" * 70_000))


def without_triggers(path: Path, *statements: str) -> None:
    """Edit as an attacker with the file: triggers dropped, edit made, triggers put back."""
    db = apsw.Connection(str(path))
    triggers = db.execute("SELECT name, sql FROM sqlite_schema WHERE type='trigger'").fetchall()
    for name, _ in triggers:
        db.execute(f"DROP TRIGGER {name}")
    for statement in statements:
        db.execute(statement).fetchall()
    for _, sql in triggers:
        db.execute(str(sql))
    db.close()


@pytest.mark.parametrize(
    "statement",
    [
        "UPDATE event SET body = json_set(body, '$.number', 99) WHERE seq = 7",
        "UPDATE event SET actor = 'somebody' WHERE seq = 7",
        "UPDATE event SET t_utc_ns = 5 WHERE seq = 7",
        "DELETE FROM event WHERE seq = 7",
        "DELETE FROM event WHERE seq < 5",
        "UPDATE event SET seq = CASE seq WHEN 7 THEN 30 ELSE seq END",
    ],
)
def test_an_edited_journal_is_not_opened(filled: Path, statement: str) -> None:
    without_triggers(filled, statement)
    with pytest.raises(JournalCorruptError, match="cannot be trusted"):
        SqliteJournal(filled)
    with pytest.raises(JournalCorruptError):
        read_records(filled)


def test_a_journal_without_its_guards_is_not_opened(filled: Path) -> None:
    db = apsw.Connection(str(filled))
    db.execute("DROP INDEX approval_once")
    db.close()
    with pytest.raises(JournalCorruptError, match="schema"):
        SqliteJournal(filled)


@pytest.mark.parametrize("share", [0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99])
def test_a_journal_cut_in_the_middle_is_an_error_and_stays_as_it_is(
    filled: Path, share: float
) -> None:
    data = filled.read_bytes()
    cut = data[: int(len(data) * share) or 1]
    filled.write_bytes(cut)
    with pytest.raises(JournalCorruptError):
        SqliteJournal(filled)
    assert filled.read_bytes() == cut


def test_flipped_bytes_are_noticed_or_change_nothing(filled: Path) -> None:
    whole, records = filled.read_bytes(), read_records(filled)
    refused = 0
    for position in range(0, len(whole), 397):
        flipped = bytearray(whole)
        flipped[position] ^= 0x10
        filled.write_bytes(flipped)
        try:
            with SqliteJournal(filled) as journal:
                assert tuple(journal.records()) == records
        except JournalCorruptError:
            refused += 1
    assert refused > 5


def test_a_file_that_is_no_database_is_corrupt(path: Path) -> None:
    path.write_bytes(b"this is no journal" * 100)
    with pytest.raises(JournalCorruptError):
        SqliteJournal(path)


def test_a_newer_schema_is_refused_and_named(filled: Path) -> None:
    db = apsw.Connection(str(filled))
    db.pragma("user_version", 2)
    db.close()
    with pytest.raises(JournalTooNewError, match="newer version"):
        SqliteJournal(filled)


def test_a_crash_before_the_schema_leaves_a_usable_file(path: Path) -> None:
    path.touch()
    with SqliteJournal(path) as journal:
        assert journal.append(entry(1)).seq == 1


class FullDisk(apsw.VFS):
    """Fails writes of the log on demand, as a full or broken disk does."""

    def __init__(self, name: str, failure: type[apsw.Error]) -> None:
        self.name, self.failure = name, failure
        self.writes_left, self.reserve = -1, Path()
        super().__init__(name, base="unix")

    @override
    def xOpen(self, name: str | apsw.URIFilename | None, flags: list[int]) -> FullDiskFile:
        return FullDiskFile(name, flags, self)

    def charge(self) -> None:
        if self.writes_left == 0 and self.reserve.exists():
            raise self.failure("no space")
        self.writes_left -= self.writes_left > 0


class FullDiskFile(apsw.VFSFile):
    def __init__(
        self, name: str | apsw.URIFilename | None, flags: list[int], disk: FullDisk
    ) -> None:
        self.disk = disk
        super().__init__("unix", name, flags)

    @override
    def xWrite(self, data: bytes, offset: int) -> None:
        self.disk.charge()
        super().xWrite(data, offset)


@pytest.fixture(params=[apsw.FullError, apsw.IOError])
def disk(request: pytest.FixtureRequest) -> Iterator[FullDisk]:
    vfs = FullDisk(f"full-{request.node.name}-{os.getpid()}", request.param)
    yield vfs
    vfs.unregister()


@pytest.mark.parametrize("after_writes", [0, 1, 2, 3])
def test_the_reserve_lets_the_last_outcome_be_written(
    path: Path, disk: FullDisk, after_writes: int
) -> None:
    journal = SqliteJournal(path, vfs=disk.name)
    journal.append(entry(1))
    disk.reserve, disk.writes_left = path.with_name("reserve.bin"), after_writes
    journal.append(entry(2))
    assert [r.seq for r in journal.records()] == [1, 2]
    assert after_writes > 1 or not disk.reserve.exists()
    journal.close()


def test_a_disk_that_stays_full_is_an_error_and_the_journal_stays_whole(
    path: Path, disk: FullDisk
) -> None:
    journal = SqliteJournal(path, vfs=disk.name)
    first = journal.append(entry(1))
    disk.reserve, disk.writes_left = path, 0  # the reserve does not help
    with pytest.raises(JournalFullError, match="not recorded"):
        journal.append(entry(2))
    disk.writes_left = -1
    assert journal.append(entry(3)).prev == first.hash
    journal.close()
    assert [r.event_id for r in read_records(path)] == ["event-1", "event-3"]


def test_a_real_file_size_limit_loses_nothing_that_was_acknowledged(path: Path) -> None:
    code = f"""
import resource, signal, sys
sys.path[:0] = {sys.path!r}
from pathlib import Path
from test_journal import entry
from sitewright.errors import JournalError
from sitewright.journal.sqlite import SqliteJournal
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
journal = SqliteJournal(Path({str(path)!r}))
resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, 200_000))
number = 0
try:
    while True:
        journal.append(entry(number + 1, text="y" * 3000))
        number += 1
except JournalError:
    print(number)
"""
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parent)}
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment
    )
    acknowledged = int(done.stdout)
    assert acknowledged > 10
    assert len(read_records(path)) == acknowledged
    assert resource.getrlimit(resource.RLIMIT_FSIZE)[0] == resource.RLIM_INFINITY


def test_a_chain_names_the_first_record_that_is_wrong(filled: Path) -> None:
    records = read_records(filled)
    assert broken_link(records) == ""
    changed = (*records[:3], replace(records[3], body="{}"), *records[4:])
    assert "record 4 was changed" in broken_link(changed)
    assert "record 5 is missing" in broken_link(records[:4] + records[5:])
    swapped = (records[0], replace(records[2], seq=2), *records[3:])
    assert "record 2 does not follow" in broken_link(swapped)


def test_a_blob_is_found_by_its_hash_and_a_changed_one_is_refused(tmp_path: Path) -> None:
    store = BlobStore(tmp_path / "blobs")
    digest = store.put(b"trajectory")
    assert store.put(b"trajectory") == digest
    assert store.get(digest) == b"trajectory"
    assert [p.name for p in (tmp_path / "blobs").iterdir()] == [digest]
    (tmp_path / "blobs" / digest).write_bytes(b"trajectorz")
    with pytest.raises(JournalCorruptError, match="changed"):
        store.get(digest)
    with pytest.raises(JournalCorruptError, match="cannot be read"):
        store.get("0" * 64)


def test_a_journal_that_is_locked_is_busy_and_not_corrupt(
    filled: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sitewright.journal.sqlite._BUSY_MS", 20)
    other = apsw.Connection(str(filled))
    other.execute("PRAGMA locking_mode=exclusive; BEGIN EXCLUSIVE").fetchall()
    try:
        for look in (read_records, SqliteJournal):
            with pytest.raises(JournalBusyError, match="locked"):
                look(filled)
    finally:
        other.close()
    assert read_records(filled)
