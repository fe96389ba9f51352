"""Rules of a model: how contacts are fastened, and which stock lengths there are."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fnmatch import fnmatchcase
from math import isfinite

from sitewright.building_model.component import FastenerSpec, Process
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.canonical import Json

CONTACTS = ("any", "end-grain", "lap", "side")
_FASTEN_KEYS = frozenset(
    {"id", "kind", "through", "into", "contact", "process", "fastener", "count", "edge_m"}
)
_STOCK_KEYS = frozenset({"id", "kind", "type", "lengths_m", "kerf_m"})
_COUNT_MAX = 50


@dataclass(frozen=True, slots=True, kw_only=True)
class FastenRule:
    """How two kinds of components are fastened where they touch.

    Attributes:
        through: Type of what the fastener goes through; ``*`` stands for any letters.
        into: Type of what it ends in.
        contact: ``end-grain`` (the contact lies across the receiver's length), ``lap``
            (the two cross), ``side`` (they run along each other) or ``any``.
        edge_m: Smallest distance to an edge; never below 5 diameters and 15 mm.
    """

    id: str
    through: str
    into: str
    contact: str
    process: Process
    fastener: FastenerSpec
    count: int
    edge_m: float

    def fits(self, through: str, into: str, contact: str) -> bool:
        """Whether the rule is about such a contact."""
        return (
            fnmatchcase(through, self.through)
            and fnmatchcase(into, self.into)
            and self.contact in ("any", contact)
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class StockRule:
    """Which lengths a kind of timber is bought in.

    Attributes:
        type: Type of the components cut from it; ``*`` stands for any letters.
        kerf_m: Width of a saw cut.
    """

    id: str
    type: str
    lengths_m: tuple[float, ...]
    kerf_m: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Rules:
    """All rules of a model; the first that fits counts."""

    fasten: tuple[FastenRule, ...] = ()
    stock: tuple[StockRule, ...] = ()


def rules_from(values: Iterable[Mapping[str, Json]], file: str = "building.json") -> Rules:
    """Read rules; `ModelRejectedError` (K1) names every one that is wrong."""
    fasten: list[FastenRule] = []
    stock: list[StockRule] = []
    problems: list[Problem] = []
    for number, value in enumerate(values, start=1):
        where = str(value.get("id") or f"rules[{number}]")
        try:
            if value.get("kind") == "stock":
                stock.append(_stock(value))
            else:
                fasten.append(_fasten(value))
        except ValueError as error:
            problems.append(_wrong(where, str(error)))
    if problems:
        raise ModelRejectedError(file, problems)
    return Rules(fasten=tuple(fasten), stock=tuple(stock))


def _fasten(value: Mapping[str, Json]) -> FastenRule:
    if value.get("kind") != "fasten":
        raise ValueError(f"the kind {value.get('kind')!r} is neither 'fasten' nor 'stock'")
    _refuse_unknown(value, _FASTEN_KEYS)
    contact = _text(value, "contact", "any")
    if contact not in CONTACTS:
        raise ValueError(f"the contact {contact!r} is none of {', '.join(CONTACTS)}")
    process = _text(value, "process", "nail")
    if process not in (Process.NAIL.value, Process.SCREW.value):
        raise ValueError(f"the process {process!r} is neither 'nail' nor 'screw'")
    made = value.get("fastener")
    if not isinstance(made, Mapping):
        raise ValueError("it states no fastener {type, d_m, l_m}")  # noqa: TRY004 - one reaction
    count = value.get("count", 2)
    if not isinstance(count, int) or isinstance(count, bool) or not 1 <= count <= _COUNT_MAX:
        raise ValueError(f"the count {count!r} is no number from 1 to {_COUNT_MAX}")
    return FastenRule(
        id=_text(value, "id"),
        through=_text(value, "through", "*"),
        into=_text(value, "into", "*"),
        contact=contact,
        process=Process(process),
        fastener=FastenerSpec(
            type=_text(made, "type", process), d_m=_length(made, "d_m"), l_m=_length(made, "l_m")
        ),
        count=count,
        edge_m=_length(value, "edge_m", 0.0),
    )


def _stock(value: Mapping[str, Json]) -> StockRule:
    _refuse_unknown(value, _STOCK_KEYS)
    lengths = value.get("lengths_m")
    if not isinstance(lengths, list) or not lengths:
        raise ValueError("'lengths_m' is no list of lengths")
    return StockRule(
        id=_text(value, "id"),
        type=_text(value, "type", "*"),
        lengths_m=tuple(sorted(_length({"lengths_m": v}, "lengths_m") for v in lengths)),
        kerf_m=_length(value, "kerf_m", 0.004),
    )


def _refuse_unknown(value: Mapping[str, Json], known: frozenset[str]) -> None:
    if unknown := sorted(set(value) - known):
        raise ValueError(f"it has unknown keys: {', '.join(unknown)}")


def _text(value: Mapping[str, Json], key: str, default: str = "") -> str:
    found = value.get(key, default)
    if not isinstance(found, str) or not found:
        raise ValueError(f"{key!r} is no text")
    return found


def _length(value: Mapping[str, Json], key: str, default: float | None = None) -> float:
    found = value.get(key, default)
    if isinstance(found, bool) or not isinstance(found, int | float) or not isfinite(found):
        raise ValueError(f"{key!r} is no length in metres")
    if found < 0.0 or (found == 0.0 and default is None):
        raise ValueError(f"{key!r} must be positive")
    return float(found)


def _wrong(where: str, message: str) -> Problem:
    return Problem(
        code="K1", severity="E", where=where, message=f"Rule: {message}.", fix="Correct the rule."
    )
