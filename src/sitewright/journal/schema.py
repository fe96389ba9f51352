"""The journal's tables, indexes and triggers; what the database itself refuses."""

from __future__ import annotations

from collections.abc import Mapping

SCHEMA_VERSION = 1

PRAGMAS: Mapping[str, int | str] = {
    "journal_mode": "wal",
    "synchronous": 2,  # full
    "trusted_schema": 0,
    "cell_size_check": 1,
    "mmap_size": 0,
    "recursive_triggers": 1,  # else INSERT OR REPLACE passes the delete trigger
    "wal_autocheckpoint": 0,
}

COLUMNS = (
    "seq", "event_id", "run_id", "t_utc_ns", "t_mono_ns", "boot_id", "actor", "kind", "version",
    "body", "prev", "hash",
)  # fmt: skip

SCHEMA = (
    """CREATE TABLE event(
 seq INTEGER PRIMARY KEY NOT NULL CHECK(seq > 0),
 event_id TEXT NOT NULL UNIQUE,
 run_id TEXT NOT NULL,
 t_utc_ns INTEGER NOT NULL,
 t_mono_ns INTEGER NOT NULL,
 boot_id TEXT NOT NULL,
 actor TEXT NOT NULL,
 kind TEXT NOT NULL,
 version INTEGER NOT NULL,
 body TEXT NOT NULL CHECK(json_valid(body) AND octet_length(body) <= 65536),
 prev BLOB NOT NULL CHECK(length(prev) = 32),
 hash BLOB NOT NULL UNIQUE CHECK(length(hash) = 32)
) STRICT""",
    "CREATE UNIQUE INDEX one_intent ON event(body->>'$.command_id') WHERE kind='skill_intent'",
    "CREATE UNIQUE INDEX one_outcome ON event(body->>'$.command_id') WHERE kind='skill_outcome'",
    """CREATE UNIQUE INDEX approval_once ON event(body->>'$.approval_id', body->>'$.step')
 WHERE kind='skill_intent'""",
    "CREATE TRIGGER no_update BEFORE UPDATE ON event BEGIN SELECT raise(ABORT, 'append only'); END",
    "CREATE TRIGGER no_delete BEFORE DELETE ON event BEGIN SELECT raise(ABORT, 'append only'); END",
)

SCHEMA_TEXTS = frozenset(SCHEMA)
