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
    if objects_in(model, thing, {}) > _MAX_PIECES:
        message = f"its block puts more than {_MAX_PIECES} objects into the world."
        raise BadBlockError("G6", message, "Nest blocks less.")
    return list(_expanded(model, thing, lambda p: p))


def objects_in(
    model: Any,  # noqa: ANN401
    thing: Any,  # noqa: ANN401
    known: dict[str, int],
    above: tuple[str, ...] = (),
) -> int:
    """Return how many objects it stands for, itself included; blocks in blocks multiply.

    Args:
        model: The opened file.
        thing: One of its objects.
        known: Counts of blocks that were met; it grows.
        above: Blocks that hold it.

    Raises:
        BadBlockError: As for `pieces_of`.
    """
    import rhino3dm

    if not isinstance(thing.Geometry, rhino3dm.InstanceReference):
        return 1
    identity = str(thing.Geometry.ParentIdefId)
    if identity not in known:
        block = _block(model, identity, above)
        held = (model.Objects.FindId(str(n)) for n in block.GetObjectIds())
        inner = (*above, identity)
        known[identity] = 1 + sum(objects_in(model, h, known, inner) for h in held if h is not None)
    return known[identity]


def _block(model: Any, identity: str, above: tuple[str, ...]) -> Any:  # noqa: ANN401
    """Return the definition of a block that is held by others."""
    block = model.InstanceDefinitions.FindId(identity)
    if block is None:
        raise BadBlockError("G6", "its block definition is missing.", "In Rhino: purge, insert it.")
    if identity in above or len(above) >= _MAX_DEPTH:
        raise BadBlockError("G6", f"block {block.Name!r} holds itself.", "Redefine the block.")
    if not block.GetObjectIds():
        message = f"block {block.Name!r} is empty here (linked to another file?)."
        raise BadBlockError("G7", message, "In Rhino: embed the block, save again.")
    return block


def _expanded(
    model: Any,  # noqa: ANN401
    thing: Any,  # noqa: ANN401
    place: Callable[[Vector], Vector],
) -> Iterator[Placed]:
    import rhino3dm

    reference = thing.Geometry
    if not isinstance(reference, rhino3dm.InstanceReference):
        yield Placed(thing=thing, place=place)
        return
    inner = _after(place, _map(reference.Xform))
    for number in model.InstanceDefinitions.FindId(str(reference.ParentIdefId)).GetObjectIds():
        held = model.Objects.FindId(str(number))
        if held is not None:
            yield from _expanded(model, held, inner)


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
