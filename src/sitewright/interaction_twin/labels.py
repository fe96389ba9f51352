"""Names that people see for the ids of the site."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sitewright.building_model.component import Component, Operation, Process
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.statuses import where_it_fell
from sitewright.robot_team.cell import Cell, StationKind

_WORD = re.compile(r"[\w$.-]+")
"""What ids are made of."""
_DRAWN = re.compile(r"keep-out-(\d+)")
"""How the zones that people draw are called."""
DRAWN_ZONE = "keep-out zone {number}"
BARE_FLANGE = "bare-"
"""Prefix of the end effector that stands for an empty flange."""


class Kind(StrEnum):
    """What an id stands for."""

    COMPONENT = "component"
    PIECE = "piece"
    OPERATION = "operation"
    STOCK_PLACE = "stock-place"
    STATION = "station"
    PREPARATION = "preparation"
    END_EFFECTOR = "end-effector"
    BARE_FLANGE = "bare-flange"
    ROBOT = "robot"
    DRAWN_ZONE = "drawn-zone"
    FIXTURE = "fixture"
    ZONE = "zone"
    UNKNOWN = "unknown"


@dataclass(frozen=True, slots=True)
class Label:
    """A name with what it names.

    Attributes:
        of: Id of the component that an operation belongs to; empty for all others.
        process: Process of an operation.
    """

    kind: Kind
    name: str
    of: str = ""
    process: str = ""


@dataclass(frozen=True, slots=True)
class Labels:
    """Labels by id; an unknown id is its own name, so nothing is ever hidden."""

    label_by_id: Mapping[str, Label] = field(default_factory=dict)

    def label(self, site_id: str) -> Label:
        """Return the label of an id."""
        found = self.label_by_id.get(site_id)
        if found is not None:
            return found
        if site_id.startswith(BARE_FLANGE):
            return Label(Kind.BARE_FLANGE, site_id)
        drawn = _DRAWN.fullmatch(site_id)
        if drawn is not None:
            return Label(Kind.DRAWN_ZONE, DRAWN_ZONE.format(number=drawn[1]))
        return Label(Kind.UNKNOWN, site_id)

    def name(self, site_id: str) -> str:
        """Return the name that people see."""
        return self.label(site_id).name

    def body(self, body_id: str) -> str:
        """Return the name of a body of the scene; a link goes by its robot or end effector."""
        owner, _, link = body_id.partition("/")
        return self.name(owner if link and owner in self.label_by_id else body_id)

    def told(self, text: str) -> str:
        """Return a text of the controller or a planner with every id in it by its name.

        An id of digits alone stays, since it could as well be a figure.
        """
        return _WORD.sub(lambda word: self._told_word(word.group()), text)

    def _told_word(self, word: str) -> str:
        site_id = word.rstrip(".")
        found = self.label_by_id.get(site_id)
        if found is None and _DRAWN.fullmatch(site_id):
            found = self.label(site_id)
        if found is None or site_id.isdigit():
            return word
        of = f" of {self.name(found.of)}" if found.of else ""
        return f"{found.name}{of}{word[len(site_id) :]}"


def labels_of(model: BuildingModel, cell: Cell) -> Labels:
    """Return the labels of everything that a plan can mention."""
    found = _labels_of_cell(cell)
    stocked = {item for stack in model.stacks for item in stack.items}
    for component in model.component_by_id.values():
        kind = Kind.PIECE if component.id in stocked else Kind.COMPONENT
        name = component.name or component.id
        found[component.id] = Label(kind, name)
        if kind is Kind.PIECE:
            found[where_it_fell(component.id)] = Label(Kind.UNKNOWN, f"where {name} lies")
        found |= _operation_labels(component)
    return Labels(found)


def _labels_of_cell(cell: Cell) -> dict[str, Label]:
    stations = cell.station_by_id.values()
    kinds: dict[Kind, Iterable[str]] = {
        Kind.FIXTURE: cell.fixture_by_id,
        Kind.ZONE: cell.zone_by_id,
        Kind.ROBOT: cell.robot_by_id,
        Kind.END_EFFECTOR: cell.end_effector_by_id,
        Kind.STATION: [s.id for s in stations if s.kind is not StationKind.PREPARATION],
        Kind.PREPARATION: [s.id for s in stations if s.kind is StationKind.PREPARATION],
        Kind.STOCK_PLACE: cell.stock_place_by_id,
    }
    return {i: Label(kind, cell.name_by_id.get(i, i)) for kind, ids in kinds.items() for i in ids}


def _operation_labels(component: Component) -> dict[str, Label]:
    """Number the operations of a component by process: nail 1, nail 2, area 1."""
    numbers: dict[Process, int] = {}
    found: dict[str, Label] = {}
    for operation in component.operations:
        numbers[operation.process] = numbers.get(operation.process, 0) + 1
        found[operation.id] = _operation_label(component, operation, numbers[operation.process])
    return found


def _operation_label(component: Component, operation: Operation, number: int) -> Label:
    noun = _NOUN.get(operation.process, operation.process.value)
    return Label(Kind.OPERATION, f"{noun} {number}", of=component.id, process=operation.process)


_NOUN: Mapping[Process, str] = {
    Process.NAIL: "nail",
    Process.SCREW: "screw",
    Process.PAINT: "face",
    Process.DRILL: "hole",
}
