"""What a changed file does to a model, for people: components by name, lengths in millimetres."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sitewright.app.model_changes import Change
    from sitewright.building_model.merging import Conflict
    from sitewright.building_model.model import BuildingModel

_LONGEST = 80
_UNTOLD = ("origins", "source")
_LENGTHS = ("ground_z_m", "com_m")


def change_lines(
    changes: Sequence[Change], before: BuildingModel, after: BuildingModel
) -> Iterator[str]:
    """Yield a line per fact: ``+`` new, ``-`` gone, ``~`` another value; relations are counted."""
    relations: Counter[str] = Counter()
    for change in changes:
        if change.key in _UNTOLD:
            continue
        if _is_relation(change):
            sign = "+" if change.old is None else "-" if change.new is None else "~"
            relations[f"{sign} {_relation_kind(change)}"] += 1
            continue
        yield _line(change, before, after)
    for kind, count in sorted(relations.items()):
        yield f"{kind}: {count} (--json lists them)"


def conflict_lines(conflicts: Sequence[Conflict]) -> Iterator[str]:
    """Yield a line per fact that you and the file changed, with who won."""
    for conflict in conflicts:
        name = ".".join(n for n in (conflict.where, conflict.key) if n)
        what = "you and the file changed it"
        if conflict.mine is None:
            what = "you removed it, the file changed it"
        elif conflict.file is None:
            what = "the file removed it, you had changed it"
        winner = "yours stays" if conflict.taken.value == "mine" else "the file's is taken"
        yield f"! {name}: {what}; {winner}"


def _line(change: Change, before: BuildingModel, after: BuildingModel) -> str:
    name = ".".join(n for n in (_name(change.where, before, after), change.key) if n)
    why = f"  ({change.why})" if change.why else ""
    if not change.key:
        sign, entry = ("+", change.new) if change.old is None else ("-", change.old)
        return f"{sign} {name}{_described(entry)}{why}"
    if change.key == "world_T_component":
        return f"~ {name}: {_motion(change.old, change.new)}{why}"
    old, new = _short(change.key, change.old), _short(change.key, change.new)
    if change.old is None:
        return f"+ {name}: {new}{why}"
    return f"- {name}: {old}" if change.new is None else f"~ {name}: {old} -> {new}{why}"


def _name(where: str, before: BuildingModel, after: BuildingModel) -> str:
    for model in (after, before):
        found = next((c for i, c in model.component_by_id.items() if i == where), None)
        if found is not None:
            own = found.name and found.name != where
            return f"{where} ({found.name})" if own else where
    return where


def _is_relation(change: Change) -> bool:
    entry = change.new if change.new is not None else change.old
    return not change.key and isinstance(entry, Mapping) and "kind" in entry


def _relation_kind(change: Change) -> str:
    entry: Any = change.new if change.new is not None else change.old
    return f"relations {entry['kind']}"


def _described(entry: Any) -> str:  # noqa: ANN401 - any JSON value
    if not isinstance(entry, Mapping) or "geometry" not in entry:
        return ""
    return f": {entry['layer']}, {entry['type']}, {_shape(entry['geometry'])}"


def _motion(old: Any, new: Any) -> str:  # noqa: ANN401 - poses as JSON
    if old is None or new is None:
        return _short("", new)
    by = [_mm(b - a) for a, b in zip(old["p_m"], new["p_m"], strict=True)]
    inner = abs(sum(a * b for a, b in zip(old["q_wxyz"], new["q_wxyz"], strict=True)))
    turned_deg = math.degrees(2.0 * math.acos(min(1.0, inner)))
    words = f"moved by ({', '.join(by)}) mm"
    return f"{words}, turned by {turned_deg:.1f} deg" if turned_deg > 1e-2 else words  # noqa: PLR2004


def _shape(geometry: Any) -> str:  # noqa: ANN401 - a shape as JSON
    match geometry:
        case {"box": {"size_m": size}}:
            return f"{' x '.join(_mm(s) for s in size)} mm"
        case {"extrusion": {"profile_m": profile, "depth_m": depth}}:
            return f"profile of {len(profile)} corners, {_mm(depth)} mm"
        case {"convex": {"points_m": points}}:
            return f"convex shape of {len(points)} corners"
        case _:
            return str(next(iter(geometry), "shape"))


def _short(key: str, value: Any) -> str:  # noqa: ANN401 - any JSON value
    if value is None:
        return "none"
    if key == "geometry":
        return _shape(value)
    if key == "operations":
        return f"{len(value)} operations ({', '.join(o['id'] for o in value)})"[:_LONGEST]
    if key in _LENGTHS and isinstance(value, int | float):
        return f"{_mm(value)} mm"
    text = f"{len(value)} entries" if isinstance(value, list) and len(value) > 4 else str(value)  # noqa: PLR2004 - a short list
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}..."


def _mm(length_m: float) -> str:
    text = f"{length_m * 1000.0:.1f}"
    return "0" if text in {"0.0", "-0.0"} else text.removesuffix(".0")
