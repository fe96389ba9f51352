"""Merges a changed design into one that its user went on with: a three-way merge of facts.

Three models meet: what was read of the file before (`base`), what it has become by hand (`mine`),
and what is read of the file now (`theirs`). A fact that only the file changed is taken from it, a
fact that only the user changed stays; where both changed it otherwise, one of them wins and the
conflict is told.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from enum import StrEnum
from typing import Any, TypeVar

from sitewright.building_model.component import Component
from sitewright.building_model.model import BuildingModel, Relation, Stack
from sitewright.building_model.same_value import is_same
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, subtract, translation

Entry = TypeVar("Entry", Component, Stack, Relation)
_BY_KEY = ("raw", "ext")
"""Facts of a component that are merged key by key."""
_OF_THE_FILE = ("source",)
"""Facts that only the file knows."""


class Preference(StrEnum):
    """Who wins where file and user both changed a fact."""

    MINE = "mine"
    FILE = "file"


@dataclass(frozen=True, slots=True, kw_only=True)
class Conflict:
    """A fact that file and user changed differently.

    Attributes:
        where: Component, stack or relation; empty for the whole model.
        key: Which fact of it; empty if all of it is gone on one side.
        mine: The user's value; None if there is none.
        file: The file's value, likewise.
        taken: Who won.
    """

    where: str
    key: str
    mine: object
    file: object
    taken: Preference


@dataclass(slots=True)
class _Merge:
    """Collects the conflicts of one merge."""

    prefer: Preference
    conflicts: list[Conflict] = field(default_factory=list)

    def value(self, where: str, key: str, base: object, mine: object, theirs: object) -> Any:  # noqa: ANN401 - any fact
        """Return the merged value of one fact."""
        if is_same(mine, theirs) or is_same(base, theirs):
            return mine
        if is_same(base, mine):
            return theirs
        self.conflicts.append(
            Conflict(where=where, key=key, mine=mine, file=theirs, taken=self.prefer)
        )
        return mine if self.prefer is Preference.MINE else theirs

    def mapping(
        self,
        where: str,
        base: Mapping[str, Any],
        mine: Mapping[str, Any],
        theirs: Mapping[str, Any],
    ) -> dict[str, Any]:
        """Return a mapping merged key by key; None stands for a key that is not there."""
        keys = sorted({*base, *mine, *theirs})
        merged = {k: self.value(where, k, base.get(k), mine.get(k), theirs.get(k)) for k in keys}
        return {k: v for k, v in merged.items() if v is not None}

    def entries(
        self,
        base: Mapping[str, Entry],
        mine: Mapping[str, Entry],
        theirs: Mapping[str, Entry],
        merged: Callable[[Entry, Entry, Entry], Entry],
    ) -> dict[str, Entry]:
        """Return entries merged one by one; what one side removed and the other kept is gone."""
        result: dict[str, Entry] = {}
        for key in dict.fromkeys([*mine, *theirs]):
            found = self._entry(key, base.get(key), mine.get(key), theirs.get(key), merged)
            if found is not None:
                result[key] = found
        return result

    def _entry(
        self,
        key: str,
        base: Entry | None,
        mine: Entry | None,
        theirs: Entry | None,
        merged: Callable[[Entry, Entry, Entry], Entry],
    ) -> Entry | None:
        if mine is None or theirs is None:
            return self._one_sided(key, base, mine, theirs)
        return merged(base if base is not None else theirs, mine, theirs)

    def _one_sided(
        self, key: str, base: Entry | None, mine: Entry | None, theirs: Entry | None
    ) -> Entry | None:
        """Return an entry that only one side has: new there, or removed on the other side."""
        if base is None:
            return mine if mine is not None else theirs
        left = mine if mine is not None else theirs
        if not is_same(base, left):
            gone = Preference.FILE if theirs is None else Preference.MINE
            self.conflicts.append(Conflict(where=key, key="", mine=mine, file=theirs, taken=gone))
        return None


def merged_design(
    base: BuildingModel,
    mine: BuildingModel,
    theirs: BuildingModel,
    prefer: Preference = Preference.MINE,
) -> tuple[BuildingModel, list[Conflict]]:
    """Return the merged design, and the facts that both sides changed.

    Args:
        base: What was read of the file before.
        mine: The design as it is now; without what was inferred.
        theirs: What is read of the changed file, in the coordinates of `mine`.
        prefer: Who wins a conflict. A component that one side removed is gone in any case.
    """
    merge = _Merge(prefer)
    components = merge.entries(
        _by_id(base), _by_id(mine), _by_id(theirs), lambda b, m, t: _component(merge, b, m, t)
    )
    relations = merge.entries(
        _relations(base),
        _relations(mine),
        _relations(theirs),
        lambda b, m, t: _whole(merge, b, m, t),
    )
    stacks = merge.entries(
        _stacks(base), _stacks(mine), _stacks(theirs), lambda b, m, t: _stack(merge, b, m, t)
    )
    known = components.keys()
    whole: dict[str, Any] = {
        name: merge.value("", name, getattr(base, name), getattr(mine, name), getattr(theirs, name))
        for name in ("rules", "gravity", "ground_z_m", "site_T_model")
    }
    by_key: dict[str, Any] = {
        name: merge.mapping("", getattr(base, name), getattr(mine, name), getattr(theirs, name))
        for name in ("materials", "component_types", "raw")
    }
    return replace(
        mine,
        component_by_id={ComponentId(i): components[i] for i in sorted(components)},
        relations=tuple(r for r in relations.values() if r.a in known and r.b in known),
        stacks=tuple(_still_there(s, known) for s in stacks.values()),
        **whole,
        **by_key,
    ), merge.conflicts


def in_coordinates_of(design: BuildingModel, other: BuildingModel) -> BuildingModel:
    """Return a design with the shift of another one taken off its file's coordinates."""
    by_m = subtract(design.origin_shift_m, other.origin_shift_m)
    if not any(by_m):
        return design
    piled = {i for s in design.stacks for i in s.items}
    x, y, z = by_m
    is_laid = design.site_T_model != Pose()
    return replace(
        design,
        site_T_model=design.site_T_model @ translation(-x, -y, -z) if is_laid else Pose(),
        component_by_id={
            i: c if i in piled else _shifted(c, by_m) for i, c in design.component_by_id.items()
        },
        origin_shift_m=other.origin_shift_m,
    )


def _shifted(component: Component, by_m: tuple[float, float, float]) -> Component:
    pose = component.world_T_component
    x, y, z = (p + d for p, d in zip(pose.position_m, by_m, strict=True))
    return replace(component, world_T_component=replace(pose, position_m=(x, y, z)))


def _component(merge: _Merge, base: Component, mine: Component, theirs: Component) -> Component:
    where, taken = mine.id, dict[str, Any]()
    for name in (f.name for f in fields(Component)):
        b, m, t = (getattr(c, name) for c in (base, mine, theirs))
        if name in _OF_THE_FILE:
            taken[name] = t if t is not None else m
        elif name in _BY_KEY:
            taken[name] = merge.mapping(where, b, m, t)
        elif name == "operations":
            taken[name] = _operations(merge, where, b, m, t)
        else:
            taken[name] = merge.value(where, name, b, m, t)
    return Component(**taken)


def _operations(
    merge: _Merge, where: str, base: Sequence[Any], mine: Sequence[Any], theirs: Sequence[Any]
) -> tuple[Any, ...]:
    """Merge operations by id, in the order of the file, the user's own ones last."""
    one, two, three = ({o.id: o for o in side} for side in (base, mine, theirs))
    order = dict.fromkeys([*three, *two])
    merged = {
        i: merge.value(where, f"operations.{i}", one.get(i), two.get(i), three.get(i))
        for i in order
    }
    return tuple(o for o in merged.values() if o is not None)


def _stack(merge: _Merge, base: Stack, mine: Stack, theirs: Stack) -> Stack:
    return Stack(
        **{
            f.name: merge.value(
                mine.id, f.name, *(getattr(s, f.name) for s in (base, mine, theirs))
            )
            for f in fields(Stack)
        }
    )


def _whole(merge: _Merge, base: Relation, mine: Relation, theirs: Relation) -> Relation:
    where = " ".join(_key(mine))
    kept: Relation = merge.value(where, "", base, mine, theirs)
    return kept


def _still_there(stack: Stack, known: Iterable[ComponentId | str]) -> Stack:
    there = set(known)
    return replace(stack, items=tuple(i for i in stack.items if i in there))


def _by_id(model: BuildingModel) -> dict[str, Component]:
    return {str(i): c for i, c in model.component_by_id.items()}


def _stacks(model: BuildingModel) -> dict[str, Stack]:
    return {str(s.id): s for s in model.stacks}


def _relations(model: BuildingModel) -> dict[str, Relation]:
    return {" ".join(_key(r)): r for r in model.relations}


def _key(relation: Relation) -> tuple[str, str, str]:
    return (relation.a, relation.kind.value, relation.b)
