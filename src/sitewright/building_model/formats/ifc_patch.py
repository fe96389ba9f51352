"""Child side of the IFC export: what to add to a file, as lines of its DATA section.

Runs in a child process (`import_process`) with a request file; opens the IFC file, adds
entities in memory and returns only these. Nothing that the file holds is changed.
"""

from __future__ import annotations

import itertools
import json
import uuid
from collections.abc import Mapping
from datetime import datetime
from pathlib import Path
from typing import Any

from sitewright.building_model.formats.ifc_attributes import BUILT_SET
from sitewright.building_model.formats.ifc_reader import open_file
from sitewright.building_model.formats.unreadable import UnreadableError

_OLD = "IFC2X3"
_DONE = "COMPLETED"


def lines_as_asked(request_path: str) -> dict[str, Any]:
    """Return ``{lines, missing}`` for a request ``{ifc, seed, written_at, records, expected}``.

    Raises:
        ModelRejectedError: The IFC file cannot be read.
    """
    request = json.loads(Path(request_path).read_text(encoding="utf-8"))
    try:
        return _answer(request)
    except UnreadableError as error:
        raise error.of(Path(request["ifc"])) from None


def _answer(request: Mapping[str, Any]) -> dict[str, Any]:
    file, _ = open_file(request["ifc"])
    wanted = [*request["expected"], *(r["source_id"] for r in request["records"])]
    missing = [i for i in wanted if _by_guid(file, i) is None]
    records = [r for r in request["records"] if r["source_id"] not in missing]
    lines = _Patch(file, request["seed"], request["written_at"]).lines(records) if records else []
    return {"lines": lines, "missing": missing}


def _by_guid(file: Any, identity: str) -> Any:  # noqa: ANN401 - untyped entities throughout
    try:
        return file.by_guid(identity)
    except RuntimeError:
        return None


class _Patch:
    """Adds entities to an open file and remembers which."""

    def __init__(self, file: Any, seed: str, written_at: str) -> None:  # noqa: ANN401
        self._file, self._seed, self._written_at = file, seed, written_at
        self._is_old = file.schema == _OLD
        self._new: list[Any] = []
        self._history = self._owner_history()

    def lines(self, records: list[dict[str, Any]]) -> list[str]:
        """Return the lines for property sets, one schedule, its tasks and their order."""
        name = self._set_name()
        tasks = []
        for record in records:
            element = self._file.by_guid(record["source_id"])
            self._property_set(name, element, record)
            if record["is_task"]:
                tasks.append(self._task(element, record))
        if tasks:
            self._schedule(tasks, [r["built_at"] for r in records if r["built_at"]])
        return [e.to_string() for e in self._new]

    def _set_name(self) -> str:
        """Return a name that no property set of the file has, so that nothing is hidden."""
        taken = {s.Name for s in self._file.by_type("IfcPropertySet")}
        names = [BUILT_SET, *(f"{BUILT_SET}_{n}" for n in range(2, len(taken) + 3))]
        return next(n for n in names if n not in taken)

    def _property_set(self, name: str, element: Any, record: Mapping[str, Any]) -> None:  # noqa: ANN401
        properties = [
            self._add(
                "IfcPropertySingleValue",
                Name=key,
                NominalValue=self._file.create_entity(kind, value),
            )
            for key, kind, value in record["properties"]
        ]
        key = record["source_id"]
        own = self._root("IfcPropertySet", key, Name=name, HasProperties=properties)
        self._root(
            "IfcRelDefinesByProperties",
            key,
            RelatedObjects=[element],
            RelatingPropertyDefinition=own,
        )

    def _task(self, element: Any, record: Mapping[str, Any]) -> Any:  # noqa: ANN401
        key = record["source_id"]
        label = "TaskId" if self._is_old else "Identification"
        values: dict[str, Any] = {label: record["component"], "IsMilestone": False}
        if record["is_done"]:
            values["Status"] = _DONE
        if not self._is_old:
            values["PredefinedType"] = "INSTALLATION"
            if record["built_at"]:
                values["TaskTime"] = self._add("IfcTaskTime", ActualFinish=record["built_at"])
        task = self._root("IfcTask", key, Name=f"Install {record['component']}", **values)
        self._root("IfcRelAssignsToProduct", key, RelatedObjects=[task], RelatingProduct=element)
        return task

    def _schedule(self, tasks: list[Any], times: list[str]) -> None:
        created, started = (
            max(times, default=self._written_at),
            min(times, default=self._written_at),
        )
        kind = "WorkControlType" if self._is_old else "PredefinedType"
        values: dict[str, Any] = {kind: "ACTUAL"}
        if self._is_old:
            values["Identifier"] = "sitewright"
        schedule = self._root(
            "IfcWorkSchedule",
            "schedule",
            Name="Sitewright as-built",
            CreationDate=self._moment(self._written_at if self._is_old else created),
            StartTime=self._moment(started),
            **values,
        )
        self._root("IfcRelAssignsToControl", "all", RelatedObjects=tasks, RelatingControl=schedule)
        lag = {"TimeLag": 0.0} if self._is_old else {}
        for before, after in itertools.pairwise(tasks):
            self._root(
                "IfcRelSequence",
                f"{before.GlobalId}-{after.GlobalId}",
                RelatingProcess=before,
                RelatedProcess=after,
                SequenceType="FINISH_START",
                **lag,
            )

    def _moment(self, time: str) -> Any:  # noqa: ANN401
        """Return a point in time: text, or entities in the old schema."""
        if not self._is_old:
            return time
        at = datetime.fromisoformat(time)
        date = self._add(
            "IfcCalendarDate", DayComponent=at.day, MonthComponent=at.month, YearComponent=at.year
        )
        zone = self._add("IfcCoordinatedUniversalTimeOffset", HourOffset=0, Sense="AHEAD")
        clock = self._add(
            "IfcLocalTime",
            HourComponent=at.hour,
            MinuteComponent=at.minute,
            SecondComponent=float(at.second),
            Zone=zone,
        )
        return self._add("IfcDateAndTime", DateComponent=date, TimeComponent=clock)

    def _owner_history(self) -> Any:  # noqa: ANN401
        """Return an owner history where the schema demands one."""
        if not self._is_old:
            return None
        if found := self._file.by_type("IfcOwnerHistory"):
            return found[0]
        firm = self._add("IfcOrganization", Name="Sitewright")
        person = self._add("IfcPerson", FamilyName="Sitewright")
        user = self._add("IfcPersonAndOrganization", ThePerson=person, TheOrganization=firm)
        program = self._add(
            "IfcApplication",
            ApplicationDeveloper=firm,
            Version="1",
            ApplicationFullName="Sitewright",
            ApplicationIdentifier="sitewright",
        )
        at = int(datetime.fromisoformat(self._written_at).timestamp())
        return self._add(
            "IfcOwnerHistory",
            OwningUser=user,
            OwningApplication=program,
            ChangeAction="ADDED",
            CreationDate=at,
        )

    def _root(self, kind: str, key: str, **values: Any) -> Any:  # noqa: ANN401
        from ifcopenshell import guid

        own = uuid.uuid5(uuid.NAMESPACE_URL, f"sitewright:{self._seed}:{kind}:{key}")
        return self._add(
            kind, GlobalId=guid.compress(own.hex), OwnerHistory=self._history, **values
        )

    def _add(self, kind: str, **values: Any) -> Any:  # noqa: ANN401
        entity = self._file.create_entity(kind, **values)
        self._new.append(entity)
        return entity
