"""Whether two facts of a building model say the same, to the accuracy of a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from typing import Any

SAME = 1e-6
"""Numbers this near are one number: a micrometre, far below what a program exports."""


def is_same(one: Any, other: Any) -> bool:  # noqa: ANN401 -- any fact
    """Return whether two values are equal, numbers to `SAME`."""
    if isinstance(one, float | int) and isinstance(other, float | int):
        return one is other or abs(one - other) <= SAME
    if isinstance(one, str) or isinstance(other, str):
        return bool(one == other)
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(is_same(one[k], other[k]) for k in one)
    if isinstance(one, Sequence) and isinstance(other, Sequence):
        return len(one) == len(other) and all(map(is_same, one, other))
    if is_dataclass(one) and type(one) is type(other):
        names = (f.name for f in fields(one))
        return all(is_same(getattr(one, n), getattr(other, n)) for n in names)
    return bool(one == other)
