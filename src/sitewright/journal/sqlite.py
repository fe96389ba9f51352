"""The journal in SQLite: append-only, chained, synced before anything starts."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Self

import apsw

from sitewright.journal.errors import (
    JournalBusyError,
    JournalCorruptError,
    JournalFullError,
    JournalTooNewError,
    RefusedByJournalError,
)
from sitewright.journal.record import GENESIS, Entry, Record, broken_link, chained
from sitewright.journal.reserve import free_reserve, make_reserve
from sitewright.journal.schema import COLUMNS, PRAGMAS, SCHEMA, SCHEMA_TEXTS, SCHEMA_VERSION

_INSERT = f"INSERT INTO event({', '.join(COLUMNS)}) VALUES ({', '.join('?' * len(COLUMNS))})"  # noqa: S608 -- constant names
_SELECT = f"SELECT {', '.join(COLUMNS)} FROM event"  # noqa: S608 -- constant names
_BUSY_MS = 2_000
_HEADER_BYTES = 100
_NOT_TRUSTED = (
    apsw.CorruptError,
    apsw.NotADBError,
    apsw.SQLError,
    apsw.FormatError,
    UnicodeDecodeError,
    TypeError,
)
_BUSY = (apsw.BusyError, apsw.LockedError)
_NOT_WRITTEN = (apsw.FullError, apsw.IOError, apsw.CantOpenError, apsw.ReadOnlyError, OSError)


class SqliteJournal:
    """One run's journal, opened for writing by one process.

    Opening checks the database, its schema text and the whole chain; what fails is a
    `JournalCorruptError`, and nothing is started from it.
    """

    def __init__(self, path: Path, *, vfs: str = "") -> None:
        """Open or create the journal at `path`; `vfs` names an apsw VFS (fault injection)."""
        self.path, self._vfs = path, vfs
        make_reserve(path)
        is_new = not path.exists()
        if not is_new and 0 < path.stat().st_size < _HEADER_BYTES:  # SQLite takes it as empty
            raise JournalCorruptError(path, "it is shorter than a database header")
        self._db = self._connect()
        try:
            if is_new or self._is_blank():
                self._create()
            self._head, self._seq = self._verify()
        except _NOT_TRUSTED as error:
            self._db.close(force=True)
            raise JournalCorruptError(path, str(error)) from error
        except _NOT_WRITTEN as error:
            self._db.close(force=True)
            raise JournalFullError(path, str(error)) from error
        except _BUSY as error:
            self._db.close(force=True)
            raise JournalBusyError(path) from error
        except BaseException:
            self._db.close(force=True)
            raise

    @property
    def head(self) -> bytes:
        """Hash of the last record; 32 zero bytes while there is none."""
        return self._head

    def append(self, entry: Entry) -> Record:
        """Write one event and return only when it is on the disk.

        After an error at COMMIT the database is opened again and its tail decides whether
        the event was written: an exception there does not mean "not written".
        """
        record = chained(entry, seq=self._seq + 1, prev=self._head)
        try:
            self._insert(record)
        except apsw.ConstraintError as error:
            raise RefusedByJournalError(self.path, entry.kind, str(error)) from error
        except _BUSY as error:
            raise JournalBusyError(self.path) from error
        except _NOT_WRITTEN as error:
            self._recover(record, error)
        self._head, self._seq = record.hash, record.seq
        return record

    def records(self) -> Iterator[Record]:
        """Return all records in order."""
        return (_record(row) for row in self._db.execute(f"{_SELECT} ORDER BY seq"))

    def close(self) -> None:
        """Move the log into the file and let go."""
        with contextlib.suppress(apsw.Error):
            self._db.pragma("wal_checkpoint(truncate)")
        self._db.close()

    def __enter__(self) -> Self:
        """Return the open journal."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close it."""
        self.close()

    def _connect(self) -> apsw.Connection:
        flags = apsw.SQLITE_OPEN_READWRITE | apsw.SQLITE_OPEN_CREATE
        vfs = self._vfs or None
        try:
            db = apsw.Connection(str(self.path), flags=flags, vfs=vfs)
        except _NOT_WRITTEN as error:
            raise JournalFullError(self.path, str(error)) from error
        db.set_busy_timeout(_BUSY_MS)
        try:
            for name, wanted in PRAGMAS.items():
                db.pragma(name, wanted)
                found = db.pragma(name)
                if found != wanted:
                    raise JournalFullError(self.path, f"SQLite keeps {name}={found}, not {wanted}")
        except _NOT_TRUSTED as error:
            db.close(force=True)
            raise JournalCorruptError(self.path, str(error)) from error
        except _NOT_WRITTEN as error:
            db.close(force=True)
            raise JournalFullError(self.path, str(error)) from error
        except _BUSY as error:
            db.close(force=True)
            raise JournalBusyError(self.path) from error
        return db

    def _is_blank(self) -> bool:
        """Return whether a crash came between the file's creation and its schema."""
        return not self._db.execute("SELECT 1 FROM sqlite_schema LIMIT 1").fetchall()

    def _create(self) -> None:
        with self._db:
            for statement in SCHEMA:
                self._db.execute(statement).fetchall()
            self._db.pragma("user_version", SCHEMA_VERSION)

    def _verify(self) -> tuple[bytes, int]:
        version = self._db.pragma("user_version")
        if isinstance(version, int) and version > SCHEMA_VERSION:
            raise JournalTooNewError(self.path, version, SCHEMA_VERSION)
        result = self._db.execute("PRAGMA integrity_check(1)").fetchall()
        if result != [("ok",)]:
            raise JournalCorruptError(self.path, str(result[0][0]))
        rows = self._db.execute("SELECT sql FROM sqlite_schema WHERE sql NOTNULL").fetchall()
        if {row[0] for row in rows} != SCHEMA_TEXTS:
            raise JournalCorruptError(self.path, "its schema is not the one that was written")
        records = list(self.records())
        problem = broken_link(records)
        if problem:
            raise JournalCorruptError(self.path, problem)
        return (records[-1].hash, records[-1].seq) if records else (GENESIS, 0)

    def _insert(self, record: Record) -> None:
        self._db.execute("BEGIN IMMEDIATE")
        try:
            self._db.execute(_INSERT, [getattr(record, name) for name in COLUMNS]).fetchall()
            self._db.execute("COMMIT")
        except BaseException:
            with contextlib.suppress(apsw.Error):
                self._db.execute("ROLLBACK")
            raise

    def _recover(self, record: Record, cause: Exception) -> None:
        """Decide by rereading whether `record` is there; spend the reserve and try once more."""
        freed = free_reserve(self.path)
        with contextlib.suppress(apsw.Error):
            self._db.close(force=True)
        self._db = self._connect()
        try:
            if self._has(record):
                return
            if not freed:
                raise JournalFullError(self.path, str(cause)) from cause
            self._insert(record)
        except _NOT_WRITTEN as error:
            raise JournalFullError(self.path, str(error)) from error

    def _has(self, record: Record) -> bool:
        found = self._db.execute("SELECT hash FROM event WHERE seq = ?", [record.seq]).fetchall()
        return found == [(record.hash,)]


def _record(row: tuple[Any, ...]) -> Record:
    return Record(**dict(zip(COLUMNS, row, strict=True)))


def read_records(path: Path) -> tuple[Record, ...]:
    """Return the verified records of a journal that another process may be writing.

    Call it in a process of its own when the writer lives: closing the last handle of the
    same file in one process would drop the writer's locks.
    """
    if not path.exists():
        raise JournalCorruptError(path, "there is no such file")
    try:
        db = apsw.Connection(str(path), flags=apsw.SQLITE_OPEN_READONLY)
        try:
            db.set_busy_timeout(_BUSY_MS)  # another reader may be recovering the log of a crash
            blank = not db.execute("SELECT 1 FROM sqlite_schema LIMIT 1").fetchall()
            rows = [] if blank else db.execute(f"{_SELECT} ORDER BY seq").fetchall()
        finally:
            db.close(force=True)
        records = tuple(_record(row) for row in rows)
        problem = broken_link(records)
    except _BUSY as error:
        raise JournalBusyError(path) from error
    except (*_NOT_TRUSTED, apsw.Error) as error:
        raise JournalCorruptError(path, str(error)) from error
    if problem:
        raise JournalCorruptError(path, problem)
    return records
