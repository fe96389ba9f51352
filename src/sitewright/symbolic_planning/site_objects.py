"""The objects of a problem: things of the site with a PDDL name and a PDDL type."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from sitewright.building_model.component import Operation
from sitewright.errors import BuildingModelError
from sitewright.foundation.ids import ComponentId
from sitewright.robot_team.cell import Capability, EndEffectorKind, Robot, StationKind
from sitewright.symbolic_planning.site_index import SiteIndex, bare_flange

_FREE_PLACE = "place"


@dataclass(frozen=True, slots=True)
class SiteObject:
    """One object.

    Attributes:
        name: In PDDL, e.g. ``m4``.
        type: Of the domain.
        site_id: Of the model or cell, or of a bare flange.
        label: For people; a comment in the problem.
    """

    name: str
    type: str
    site_id: str
    label: str


_Kind = tuple[str, str, str]
"""Type, site id and label, before a name is given."""


def site_objects(site: SiteIndex) -> tuple[SiteObject, ...]:
    """Return all objects of the problem: by kind, within a kind by id.

    Raises:
        BuildingModelError: Two things of the site have the same id.
    """
    robots = sorted(site.view.cell.robot_by_id.values(), key=lambda r: r.id)
    named = [
        *_named("r", ((r.subtype.value, r.id, r.model) for r in robots)),
        *_named("e", _end_effectors(site)),
        *_bare_flanges(robots),
        *_named("t", (("target", t, _label(site, t)) for t in site.targets)),
        *_named("m", (("thing", m, _label(site, m)) for m in site.things)),
        *_named("c", (("fastener", c, _words(site, o)) for c, o in site.fasteners.items())),
        *_named("f", (("finish", f, _words(site, o)) for f, o in site.finishes.items())),
        *_named("p", (("preparation-station", p, r) for r, p in site.preparation.items())),
        *_named("s", (("stock-place", p, "") for p in _stock_places(site))),
        *_named("w", (("tool-station", p, "") for p in _tool_stations(site))),
    ]
    known = {o.site_id for o in named}
    elsewhere = ((_FREE_PLACE, p, "a robot is here") for p in site.occupied if p not in known)
    found = (*named, *_named("x", elsewhere))
    _check_unique(found)
    return found


def _named(prefix: str, kinds: Iterable[_Kind]) -> list[SiteObject]:
    return [
        SiteObject(f"{prefix}{number}", type_name, site_id, label)
        for number, (type_name, site_id, label) in enumerate(sorted(kinds, key=_by_id), start=1)
    ]


def _by_id(kind: _Kind) -> str:
    return kind[1]


def _end_effectors(site: SiteIndex) -> list[_Kind]:
    types = {EndEffectorKind.GRIPPER: "gripper", EndEffectorKind.TOOL: "tool"}
    used = {e for r in site.view.cell.robot_by_id.values() for e in r.end_effectors}
    used |= {s.mounted for s in site.view.robot_status.values() if s.mounted is not None}
    known = site.view.cell.end_effector_by_id
    return [(types[known[e].kind], e, known[e].description.name) for e in used]


def _bare_flanges(robots: Iterable[Robot]) -> list[SiteObject]:
    return [
        SiteObject(f"bare-r{number}", "end-effector", bare_flange(robot.id), "bare flange")
        for number, robot in enumerate(robots, start=1)
        if Capability.TOOL_CHANGING in robot.can
    ]


def _stock_places(site: SiteIndex) -> set[str]:
    """Where a piece of this problem lies, buffers, and where a robot stands at the stock."""
    cell = site.view.cell
    places = {site.view.lies_at[m] for m in site.things if m in site.view.lies_at}
    places |= {s.id for s in cell.station_by_id.values() if s.kind is StationKind.BUFFER}
    return places | {p for p in site.occupied if p in cell.stock_place_by_id}


def _tool_stations(site: SiteIndex) -> list[str]:
    stations = site.view.cell.station_by_id.values()
    return [s.id for s in stations if s.kind is StationKind.TOOL]


def _label(site: SiteIndex, component: ComponentId) -> str:
    node = site.view.graph.node_by_id.get(component)
    return node.label if node is not None else ""


def _words(site: SiteIndex, operation: Operation) -> str:
    return f"{operation.process} of {_label(site, site.target_of[operation.id])}"


def _check_unique(objects: Iterable[SiteObject]) -> None:
    seen: dict[str, SiteObject] = {}
    for found in objects:
        other = seen.setdefault(found.site_id, found)
        if other is not found:
            raise BuildingModelError(
                f"{found.site_id!r} names both a {other.type} and a {found.type}; "
                "give one of them another id."
            )
