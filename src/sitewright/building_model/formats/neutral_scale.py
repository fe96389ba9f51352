"""Unit, origin and bounds of what a reader handed over, before anything is made of it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from statistics import median

from sitewright.building_model.formats.length_unit import (
    METRES_PER_UNIT,
    unit_problems,
    unusual_lengths,
)
from sitewright.building_model.formats.neutral import (
    BoxSolid,
    ExtrusionSolid,
    FacesSolid,
    NeutralFile,
    NeutralPart,
    NeutralSolid,
)
from sitewright.errors import Problem
from sitewright.foundation.pose import Vector, norm

MAX_PARTS = 50_000
MAX_FACES = 2_000_000
MAX_FACES_IN_ALL = 20_000_000
_FAR_M = 1000.0
_TOO_FAR_M = 1e5
_SAME_UNIT = 1e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class Scale:
    """How the numbers of a file become metres: ``metres * number - shift_m``."""

    metres: float = 1.0
    shift_m: Vector = (0.0, 0.0, 0.0)


def scale_of(where: str, file: NeutralFile, unit: str | None) -> tuple[Scale, list[Problem]]:
    """Return the scale of a file, and what is doubtful or wrong about it.

    Args:
        where: Name of the file.
        file: What was read; every number in it is finite.
        unit: Unit that the user states; it wins over the file's own.
    """
    lengths = [length for part in file.parts if (length := _length(part)) > 0.0]
    if unit is None and file.metres_per_unit is not None:
        metres, problems = file.metres_per_unit, []
    else:
        problems = [p for p in unit_problems(where, unit, lengths) if p.severity == "E"]
        if problems or unit is None:
            return Scale(metres=1.0 / _largest(file)), problems
        metres = METRES_PER_UNIT[unit]
        problems = _contradiction(where, file.metres_per_unit, unit)
    problems += unusual_lengths(where, metres, lengths)
    shift, more = _shift(where, file, metres)
    return Scale(metres=metres, shift_m=shift), [*problems, *more]


def bound_problems(file: NeutralFile, where: str) -> Iterator[Problem]:
    """Yield what is beyond all bounds: too many parts or faces, numbers that are none."""
    if len(file.parts) > MAX_PARTS:
        message = f"It holds {len(file.parts)} parts, more than {MAX_PARTS}."
        yield _problem("E2", where, message, "Export only what is to be built.")
    faces = [sum(len(s.faces) for s in p.solids if isinstance(s, FacesSolid)) for p in file.parts]
    if sum(faces) > MAX_FACES_IN_ALL:
        message = f"It holds {sum(faces)} faces, more than {MAX_FACES_IN_ALL}."
        yield _problem("E2", where, message, "Simplify its meshes.")
    for part, count in zip(file.parts, faces, strict=True):
        if count > MAX_FACES:
            message = f"It has {count} faces, more than {MAX_FACES}."
            yield _problem("E2", part.source_id, message, "Simplify its mesh.")
        if not all(math.isfinite(x) for solid in part.solids for x in _numbers(solid)):
            message = "A coordinate is not a finite number."
            yield _problem("K3", part.source_id, message, "Repair it in the model.")


def points_of(solid: NeutralSolid) -> list[Vector]:
    """Return points whose hull is the solid, in the file's unit."""
    match solid:
        case BoxSolid(file_T_box=pose, size=size):
            signs = ((x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5))
            return [pose.apply((x * size[0], y * size[1], z * size[2])) for x, y, z in signs]
        case ExtrusionSolid(file_T_profile=pose, profile=profile, depth=depth):
            return [pose.apply((x, y, z)) for z in (0.0, depth) for x, y in profile]
        case FacesSolid(vertices=vertices):
            return list(vertices)


def _largest(file: NeutralFile) -> float:
    """Return the largest coordinate, at least 1: by it any model becomes one of some metres."""
    points = (p for part in file.parts for solid in part.solids for p in points_of(solid))
    return max(1.0, max((abs(c) for p in points for c in p), default=1.0))


def _length(part: NeutralPart) -> float:
    return max((_longest(solid) for solid in part.solids), default=0.0)


def _longest(solid: NeutralSolid) -> float:
    if isinstance(solid, BoxSolid):
        return max(solid.size)
    points = points_of(solid)
    return max((max(axis) - min(axis) for axis in zip(*points, strict=True)), default=0.0)


def _numbers(solid: NeutralSolid) -> Iterable[float]:
    match solid:
        case BoxSolid():
            return (*solid.file_T_box.position_m, *solid.size)
        case ExtrusionSolid():
            outline = [x for point in solid.profile for x in point]
            return (*solid.file_T_profile.position_m, *outline, solid.depth)
        case FacesSolid():
            return (x for point in solid.vertices for x in point)


def _contradiction(where: str, stated: float | None, unit: str) -> list[Problem]:
    if stated is None or abs(stated / METRES_PER_UNIT[unit] - 1.0) < _SAME_UNIT:
        return []
    name = next((n for n, m in METRES_PER_UNIT.items() if abs(stated / m - 1.0) < _SAME_UNIT), "")
    message = f"The file states {name or f'{stated:g} m per unit'}, you say {unit}: {unit} is used."
    return [_problem("U2", where, message, "Leave out --unit if that was not meant.", "W")]


def _shift(where: str, file: NeutralFile, metres: float) -> tuple[Vector, list[Problem]]:
    middles = [
        _middle(points) for p in file.parts for s in p.solids[:1] if (points := points_of(s))
    ]
    if not middles:
        return (0.0, 0.0, 0.0), []
    x, y, z = (median(p[k] for p in middles) * metres for k in range(3))
    is_far = norm((x, y, z)) >= _FAR_M
    shift = (float(round(x)), float(round(y)), float(round(z))) if is_far else (0.0, 0.0, 0.0)
    problems = []
    if is_far:
        message = f"The model lies {norm(shift) / 1000.0:.4g} km off the origin."
        fix = "It is shifted; the shift is in 'origin_shift_m' and is restored on export."
        problems.append(_problem("O1", where, message, fix, "W"))
    return shift, [*problems, *_strays(file, metres, shift)]


def _middle(points: Sequence[Vector]) -> Vector:
    xs, ys, zs = zip(*points, strict=True)
    return (
        (min(xs) + max(xs)) / 2.0,
        (min(ys) + max(ys)) / 2.0,
        (min(zs) + max(zs)) / 2.0,
    )


def _strays(file: NeutralFile, metres: float, shift: Vector) -> Iterator[Problem]:
    for part in file.parts:
        points = (p for solid in part.solids for p in points_of(solid))
        far = max(
            (abs(c * metres - s) for p in points for c, s in zip(p, shift, strict=True)),
            default=0.0,
        )
        if far > _TOO_FAR_M:
            message = f"It reaches {far / 1000.0:.4g} km off the others."
            yield _problem("O1", part.source_id, message, "Move or delete it.")


def _problem(code: str, where: str, message: str, fix: str, severity: str = "E") -> Problem:
    return Problem(code=code, severity=severity, where=where or "file", message=message, fix=fix)
