"""What Rhino's block instances put into the world: geometry of definitions, each at its place."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from sitewright.foundation.pose import Vector

_MAX_DEPTH = 32
_MAX_PIECES = 20_000


class BadBlockError(Exception):
    """A block gives no geometry; carries code, message and fix."""

    def __init__(self, code: str, message: str, fix: str) -> None:
        super().__init__(message)
        self.problem = [code, message, fix]


@dataclass(frozen=True, slots=True, kw_only=True)
class Placed:
    """One object of a file and the affine map that puts it into the world."""

    thing: Any
    place: Callable[[Vector], Vector]


def pieces_of(model: Any, thing: Any) -> list[Placed]:  # noqa: ANN401 - untyped library
    """Return an object itself, or all that its block puts into the world.

    Raises:
        BadBlockError: A block holds itself, is linked or missing, or there is no end to it.
    """
    pieces: list[Placed] = []
    for piece in _expanded(model, thing, lambda p: p, ()):
        pieces.append(piece)
        if len(pieces) > _MAX_PIECES:
            message = f"its block puts more than {_MAX_PIECES} objects into the world."
            raise BadBlockError("G6", message, "Nest blocks less.")
    return pieces


def _expanded(
    model: Any,  # noqa: ANN401
    thing: Any,  # noqa: ANN401
    place: Callable[[Vector], Vector],
    above: tuple[str, ...],
) -> Iterator[Placed]:
    import rhino3dm

    reference = thing.Geometry
    if not isinstance(reference, rhino3dm.InstanceReference):
        yield Placed(thing=thing, place=place)
        return
    identity = str(reference.ParentIdefId)
    block = model.InstanceDefinitions.FindId(identity)
    if block is None:
        raise BadBlockError("G6", "its block definition is missing.", "In Rhino: purge, insert it.")
    if identity in above or len(above) >= _MAX_DEPTH:
        raise BadBlockError("G6", f"block {block.Name!r} holds itself.", "Redefine the block.")
    if not block.GetObjectIds():
        message = f"block {block.Name!r} is empty here (linked to another file?)."
        raise BadBlockError("G7", message, "In Rhino: embed the block, save again.")
    inner = _after(place, _map(reference.Xform))
    for number in block.GetObjectIds():
        held = model.Objects.FindId(str(number))
        if held is not None:
            yield from _expanded(model, held, inner, (*above, identity))


def _after(
    outer: Callable[[Vector], Vector], inner: Callable[[Vector], Vector]
) -> Callable[[Vector], Vector]:
    return lambda point: outer(inner(point))


def _map(xform: Any) -> Callable[[Vector], Vector]:  # noqa: ANN401
    """Return an affine map in full precision; `ToFloatArray` has only single precision."""
    rows = [[float(getattr(xform, f"M{i}{j}")) for j in range(4)] for i in range(3)]

    def mapped(point: Vector) -> Vector:
        x, y, z = (r[0] * point[0] + r[1] * point[1] + r[2] * point[2] + r[3] for r in rows)
        return (x, y, z)

    return mapped
