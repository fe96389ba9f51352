"""Length units of files: the table, and what to say when a unit is missing or looks wrong."""

from __future__ import annotations

from collections.abc import Sequence
from statistics import median

from sitewright.errors import Problem, did_you_mean

METRES_PER_UNIT = {
    "mm": 0.001,
    "cm": 0.01,
    "dm": 0.1,
    "m": 1.0,
    "in": 0.0254,
    "ft": 0.3048,
}
_USUAL_M = (0.05, 30.0)


def unit_problems(where: str, unit_name: str | None, lengths: Sequence[float]) -> list[Problem]:
    """Return U1 if the unit is missing or unknown, U2 if it makes parts of unusual length.

    Args:
        where: Name of the file.
        unit_name: What the file or the user states, if anything.
        lengths: Length of every part in the file's own numbers.
    """
    longest = max(lengths, default=0.0)
    if unit_name is None:
        message = (
            f"it states no unit. Longest part {longest:g}: "
            f"as mm {longest / 1000.0:.4g} m, as m {longest:.4g} m."
        )
        fix = f"Pass --unit mm (or {', '.join(u for u in METRES_PER_UNIT if u != 'mm')})."
        return [Problem(code="U1", severity="E", where=where, message=message, fix=fix)]
    if unit_name not in METRES_PER_UNIT:
        message = f"unit {unit_name!r} is not known.{did_you_mean(unit_name, METRES_PER_UNIT)}"
        fix = f"Use one of {', '.join(METRES_PER_UNIT)}."
        return [Problem(code="U1", severity="E", where=where, message=message, fix=fix)]
    return unusual_lengths(where, METRES_PER_UNIT[unit_name], lengths)


def unusual_lengths(where: str, metres: float, lengths: Sequence[float]) -> list[Problem]:
    """Return U2 if the parts are of unusual length.

    Args:
        where: Name of the file.
        metres: Metres per unit of the file.
        lengths: Length of every part in the file's own numbers.
    """
    usual = median(lengths) * metres if lengths else _USUAL_M[0]
    if _USUAL_M[0] <= usual <= _USUAL_M[1]:
        return []
    fitting = [
        name
        for name, other in METRES_PER_UNIT.items()
        if _USUAL_M[0] <= median(lengths) * other <= _USUAL_M[1]
    ]
    message = f"median length {usual:.4g} m (usual {_USUAL_M[0]}-{_USUAL_M[1]:g})."
    fix = f"Did you mean {' or '.join(fitting)}?" if fitting else "Check the model's scale."
    return [Problem(code="U2", severity="W", where=where, message=message, fix=fix)]
