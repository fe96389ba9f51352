"""Remembers what was compiled from an immutable value, for as long as it is of use."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from typing import Generic, TypeVar

Source = TypeVar("Source")
Made = TypeVar("Made")


class IdentityCache(Generic[Source, Made]):
    """The last few results of `make`, found by the identity of its argument.

    The values that are planned on are frozen, so the same object always gives the same result;
    hashing a whole scene instead would cost more than most questions about it. The cache holds
    its keys, so that an identity is never reused while it is remembered.
    """

    def __init__(self, make: Callable[[Source], Made], *, size: int) -> None:
        self._make = make
        self._size = size
        self._made_by_id: OrderedDict[int, tuple[Source, Made]] = OrderedDict()

    def __call__(self, source: Source) -> Made:
        """Return `make(source)`, made now or before."""
        key = id(source)
        known = self._made_by_id.get(key)
        if known is not None:
            self._made_by_id.move_to_end(key)
            return known[1]
        made = self._make(source)
        self._made_by_id[key] = (source, made)
        if len(self._made_by_id) > self._size:
            self._made_by_id.popitem(last=False)
        return made
