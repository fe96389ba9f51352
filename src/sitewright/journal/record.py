"""One record of the journal: its envelope, its canonical body and the hash that chains it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from sitewright.foundation.canonical import Json, canonical_json

GENESIS = bytes(32)
"""What the first record has as `prev`."""
MAX_BODY_BYTES = 65_536
_PREFIX = b"sitewright-journal/1\0"


@dataclass(frozen=True, slots=True, kw_only=True)
class Record:
    """An event as it is stored.

    Attributes:
        seq: 1 for the first record of a journal, without gaps.
        t_utc_ns: Wall clock when it was appended.
        t_mono_ns: Monotonic clock of the same boot.
        boot_id: Tells which boot the monotonic clock belongs to.
        actor: Who caused it: ``controller``, or a person's name.
        body: Canonical JSON text.
        prev: Hash of the record before.
        hash: SHA-256 over all the above.
    """

    seq: int
    event_id: str
    run_id: str
    t_utc_ns: int
    t_mono_ns: int
    boot_id: str
    actor: str
    kind: str
    version: int
    body: str
    prev: bytes
    hash: bytes

    def value(self) -> Mapping[str, Json]:
        """Return the parsed body."""
        parsed: Mapping[str, Json] = json.loads(self.body)
        return parsed


@dataclass(frozen=True, slots=True, kw_only=True)
class Entry:
    """What an author gives; the journal adds number, previous hash and hash."""

    event_id: str
    run_id: str
    t_utc_ns: int
    t_mono_ns: int
    boot_id: str
    actor: str
    kind: str
    version: int
    body: Mapping[str, Json]


def chained(entry: Entry, *, seq: int, prev: bytes) -> Record:
    """Return the entry as the record that follows the one with hash `prev`."""
    body = canonical_json(entry.body)
    if len(body.encode()) > MAX_BODY_BYTES:
        size = len(body.encode())
        raise ValueError(f"event {entry.kind!r} has {size} bytes; a body holds {MAX_BODY_BYTES}")
    columns = (
        seq,
        entry.event_id,
        entry.run_id,
        entry.t_utc_ns,
        entry.t_mono_ns,
        entry.boot_id,
        entry.actor,
        entry.kind,
        entry.version,
        body,
    )
    return Record(
        seq=seq,
        event_id=entry.event_id,
        run_id=entry.run_id,
        t_utc_ns=entry.t_utc_ns,
        t_mono_ns=entry.t_mono_ns,
        boot_id=entry.boot_id,
        actor=entry.actor,
        kind=entry.kind,
        version=entry.version,
        body=body,
        prev=prev,
        hash=chain_hash(prev, columns),
    )


def chain_hash(prev: bytes, columns: Iterable[int | str]) -> bytes:
    """Return SHA-256 over `prev` and each column as type byte, length and bytes."""
    digest = hashlib.sha256(_PREFIX + prev)
    for column in columns:
        if isinstance(column, int):
            tag, data = b"i", str(column).encode()
        else:
            tag, data = b"s", column.encode()
        digest.update(tag + len(data).to_bytes(8, "big") + data)
    return digest.digest()


def columns_of(record: Record) -> tuple[int | str, ...]:
    """Return the hashed columns of a record in their order."""
    return (
        record.seq,
        record.event_id,
        record.run_id,
        record.t_utc_ns,
        record.t_mono_ns,
        record.boot_id,
        record.actor,
        record.kind,
        record.version,
        record.body,
    )


def broken_link(records: Iterable[Record]) -> str:
    """Return what is wrong with a chain of records in one sentence; empty if it is whole."""
    prev = GENESIS
    for seq, record in enumerate(records, start=1):
        if record.seq != seq:
            return f"record {seq} is missing; the next one is {record.seq}"
        if record.prev != prev:
            return f"record {seq} does not follow record {seq - 1}"
        if chain_hash(prev, columns_of(record)) != record.hash:
            return f"record {seq} was changed after it was written"
        prev = record.hash
    return ""
