"""The cell's own record: ledger, physical log and checkpoints in one append-only file.

Each line is one JSON object that is on disk (fsync) before the cell goes on, so that a command's
state, the effect it had on the world and the state of the physics can never disagree:

    {"kind": "opened", "checkpoint": ...}
    {"kind": "epoch", "epoch": 3}
    {"kind": "accepted", "command_id": ..., "epoch": ..., "skill": ..., "checkpoint": ...}
    {"kind": "effect", "effect": ..., "command_id": ..., ..., "checkpoint": ...}
    {"kind": "ended", "command_id": ..., "report": ..., "contacts": [...], "checkpoint": ...}

The lines of kind ``effect`` are the physical log. A last line that was cut is not part of it.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from sitewright.errors import BackendError
from sitewright.foundation.canonical import Json, canonical_json
from sitewright.foundation.ids import CommandId
from sitewright.robot_team.driver import CommandState, CommandStatus
from sitewright.robot_team.drivers.mujoco.codec import report_from_json

LOG_NAME = "cell.jsonl"
Record = dict[str, Any]


@dataclass(slots=True)
class Ledger:
    """What the records add up to.

    Attributes:
        epoch: Highest epoch that was seen.
        accepted: Skill of every accepted command, ended or not.
        ended: How commands ended.
        contacts: Unallowed contacts of all commands.
        checkpoint: The last state of the physics, as JSON.
    """

    epoch: int = 0
    accepted: dict[CommandId, str] = field(default_factory=dict)
    ended: dict[CommandId, Record] = field(default_factory=dict)
    contacts: list[Record] = field(default_factory=list)
    checkpoint: Record | None = None

    def add(self, record: Record) -> None:
        """Take one more record into account."""
        self.epoch = max(self.epoch, int(record.get("epoch", 0)))
        self.checkpoint = record.get("checkpoint", self.checkpoint)
        match record["kind"]:
            case "accepted":
                self.accepted[CommandId(record["command_id"])] = record["skill"]
            case "ended":
                self.ended[CommandId(record["command_id"])] = record["report"]
                self.contacts += record["contacts"]
            case _:
                pass  # epochs and effects change nothing here

    def status(self, command_id: CommandId) -> CommandStatus:
        """Return what is known of a command."""
        if command_id in self.ended:
            report = report_from_json(self.ended[command_id])
            return CommandStatus(state=CommandState.ENDED, report=report)
        known = command_id in self.accepted
        return CommandStatus(state=CommandState.ACCEPTED if known else CommandState.NEVER)


class CellLog:
    """Appends records to the file and keeps the ledger that they add up to."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.ledger = Ledger()
        records, valid_bytes = read_records(path)
        for record in records:
            self.ledger.add(record)
        self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        os.ftruncate(self._file, valid_bytes)
        os.lseek(self._file, 0, os.SEEK_END)
        _sync_folder(path.parent)

    def append(self, kind: str, facts: Mapping[str, Json]) -> None:
        """Write a record; it is on disk when this returns.

        Raises:
            BackendError: The disk did not take it; the log is as it was before.
        """
        record: Record = {"kind": kind, **facts}
        data = canonical_json(record).encode() + b"\n"
        whole_bytes = os.fstat(self._file).st_size
        view = memoryview(data)
        try:
            while view:
                view = view[os.write(self._file, view) :]
            os.fsync(self._file)
        except OSError as error:
            os.ftruncate(self._file, whole_bytes)  # no later record may follow half of this one
            os.lseek(self._file, 0, os.SEEK_END)
            raise BackendError(f"{self.path}: {kind} was not recorded: {error.strerror}") from error
        self.ledger.add(record)

    def close(self) -> None:
        """Close the file."""
        os.close(self._file)


def read_records(path: Path) -> tuple[list[Record], int]:
    """Return all whole records of a log, and the length of the file that they fill."""
    if not path.exists():
        return [], 0
    data = path.read_bytes()
    valid_bytes = data.rfind(b"\n") + 1
    records: list[Record] = []
    for number, line in enumerate(data[:valid_bytes].splitlines(), start=1):
        try:
            records.append(json.loads(line))
        except ValueError as error:
            raise BackendError(f"{path}, line {number} is damaged: {error}") from error
    return records, valid_bytes


def read_physical_log(path: Path) -> list[Record]:
    """Return every physical effect that really happened, in order, without checkpoints."""
    return [
        {k: v for k, v in record.items() if k not in {"kind", "checkpoint"}}
        for record in read_records(path)[0]
        if record["kind"] == "effect"
    ]


def _sync_folder(folder: Path) -> None:
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
