"""Ids of imported components, and whom a file means by an id or a name."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from sitewright.building_model.formats.user_text import word
from sitewright.errors import Problem, did_you_mean
from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.ids import ComponentId

_STRANGE = re.compile(r"[^A-Za-z0-9_$.\-]")
_MAX_ID = 64
_DIGEST = 8


@dataclass(frozen=True, slots=True, kw_only=True)
class Named:
    """The names of one component to be."""

    id: ComponentId
    source_id: str
    name: str


def usable_id(source_id: str) -> ComponentId:
    """Return a source id in our characters; one that had to change much ends in its own hash."""
    plain = _STRANGE.sub("_", source_id)
    if len(plain) <= _MAX_ID and plain.replace("_", ""):
        return ComponentId(plain)
    digest = sha256_hex(source_id)[:_DIGEST]
    return ComponentId(f"{plain[: _MAX_ID - _DIGEST - 1]}-{digest}")


def double_ids(named: Sequence[Named]) -> Iterator[Problem]:
    """Yield ids that several components have."""
    sources = defaultdict(list)
    for one in named:
        sources[one.id].append(one.source_id)
    for name, all_of_it in sources.items():
        if len(all_of_it) > 1:
            shown = ", ".join(all_of_it[:3])
            yield Problem(
                code="D1",
                severity="E",
                where=name,
                message=f"{len(all_of_it)} components have this id ({shown}).",
                fix="Give each its own 'sitewright.id', or remove the copies.",
                source_id=all_of_it[0],
            )


class Directory:
    """Finds components by id, source id or unique name."""

    def __init__(self, named: Iterable[Named]) -> None:
        everyone = list(named)
        self._ids = {n.id for n in everyone}
        self._by_source: Mapping[str, ComponentId] = {n.source_id: n.id for n in everyone}
        self._by_name = {n.name: n.id for n in everyone if n.name}
        self._count = Counter(n.name for n in everyone if n.name)

    def by_source(self, source_id: str) -> ComponentId | None:
        """Return the component made of a part of the file."""
        return self._by_source.get(source_id)

    def find(self, reference: str, child: Named, what: str) -> ComponentId | Problem:
        """Return whom a reference means, or why nobody knows.

        Args:
            reference: An id, a source id or a name.
            child: Who refers to it.
            what: ``parent``, ``component of operation 'n1'``.
        """
        if reference in self._ids:
            return ComponentId(reference)
        if reference in self._by_source:
            return self._by_source[reference]
        name = word(reference)  # as the names of components were taken
        count = self._count[name]
        if count == 1:
            return self._by_name[name]
        if count > 1:
            message = f"{what} {reference!r} matches {count} components."
            return _refused("N1", child, message, "Use ids, or rename them.")
        known = {*self._ids, *self._count}
        message = f"{what} {reference!r} does not exist.{did_you_mean(reference, known)}"
        return _refused("P1", child, message, "Correct the reference, or export what it names too.")


def _refused(code: str, child: Named, message: str, fix: str) -> Problem:
    return Problem(
        code=code,
        severity="E",
        where=child.id,
        message=message,
        fix=fix,
        source_id=child.source_id,
    )
