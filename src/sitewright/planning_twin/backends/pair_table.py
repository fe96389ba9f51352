"""Pairs of parts, row by row, whose distance matters to a robot's motion."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.scene import Pair

Indices = npt.NDArray[np.intp]


@dataclass(frozen=True, slots=True, eq=False)
class PairTable:
    """Pairs of parts that one robot's motion changes (or that no motion changes).

    Attributes:
        a, b: Numbers of the two parts.
        name: Number of the pair of bodies in `names`; rows of one pair follow each other.
        is_neighbour: Whether a row is of two parts of one arm with one joint between them (a tool
            and the link before the last one); their distance hardly depends on the motion.
        weights: pairs x joints; how far the parts come nearer at most per radian of each joint.
        queries: Compiled distance queries by row, made when first asked for.
    """

    a: Indices
    b: Indices
    name: Indices
    names: tuple[Pair, ...]
    is_neighbour: npt.NDArray[np.bool_]
    weights: Array
    queries: dict[int, Any] = field(default_factory=dict)
    _number_of: dict[Pair, int] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "_number_of", {n: k for k, n in enumerate(self.names)})

    def thresholds(self, clearance_m: float, declared_m: Mapping[Pair, float]) -> Array:
        """Return the distance that each row must keep."""
        by_name = np.full(len(self.names), clearance_m)
        for number, pair in self._numbered(declared_m):
            by_name[number] = declared_m[pair]
        return np.asarray(by_name[self.name])

    def is_declared(self, declared_m: Mapping[Pair, float]) -> npt.NDArray[np.bool_]:
        """Return which rows are declared."""
        by_name = np.zeros(len(self.names), dtype=np.bool_)
        by_name[[number for number, _ in self._numbered(declared_m)]] = True
        return np.asarray(by_name[self.name])

    def _numbered(self, pairs: Iterable[Pair]) -> Iterable[tuple[int, Pair]]:
        """Yield those of some pairs that are in the table."""
        return ((self._number_of[p], p) for p in pairs if p in self._number_of)
