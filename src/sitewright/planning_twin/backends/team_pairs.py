"""Pairs of a scene whose robots move in step: who changes their distance, and by how much."""

from __future__ import annotations

from itertools import accumulate

import numpy as np

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.kinematic_chain import Array
from sitewright.planning_twin.backends.layout import Layout
from sitewright.planning_twin.backends.pair_table import PairTable

_Row = tuple[int, int]


def tables_of(layout: Layout, robots: tuple[RobotId, ...]) -> tuple[PairTable, PairTable]:
    """Return the pairs that some robots change, and those that all of them leave alone.

    The weights of the first table count the joints of `robots` one robot after the other. Where
    two robots move towards each other, each part comes nearer by its own travel, so that a row
    has the weights of both.
    """
    if len(robots) == 1:
        return layout.pairs_of[robots[0]], layout.standing_of[robots[0]]
    if robots not in layout.teams:
        layout.teams[robots] = (_moving(layout, robots), _standing(layout, robots))
    return layout.teams[robots]


def _moving(layout: Layout, robots: tuple[RobotId, ...]) -> PairTable:
    counts = [layout.arms[r].chain.joints for r in robots]
    firsts = [0, *accumulate(counts)]
    weight_of: dict[_Row, Array] = {}
    name_of: dict[_Row, tuple[str, str]] = {}
    neighbours: set[_Row] = set()
    for robot, first, count in zip(robots, firsts, counts, strict=False):
        table = layout.pairs_of[robot]
        for k, (a, b) in enumerate(zip(table.a.tolist(), table.b.tolist(), strict=True)):
            row = (min(a, b), max(a, b))
            weight = weight_of.setdefault(row, np.zeros(firsts[-1]))
            weight[first : first + count] += table.weights[k]
            name_of[row] = table.names[table.name[k]]
            if table.is_neighbour[k]:
                neighbours.add(row)
    names = tuple(dict.fromkeys(name_of.values()))
    number = {name: k for k, name in enumerate(names)}
    rows = np.array(list(weight_of), dtype=np.intp).reshape(-1, 2)
    return PairTable(
        a=rows[:, 0],
        b=rows[:, 1],
        name=np.array([number[name_of[row]] for row in weight_of], dtype=np.intp),
        names=names,
        is_neighbour=np.array([row in neighbours for row in weight_of], dtype=np.bool_),
        weights=np.array(list(weight_of.values())).reshape(-1, firsts[-1]),
    )


def _standing(layout: Layout, robots: tuple[RobotId, ...]) -> PairTable:
    """Return the pairs that stand whoever of the robots moves."""
    table = layout.standing_of[robots[0]]
    others = [set(layout.standing_of[r].names) for r in robots[1:]]
    is_left = np.array(
        [all(table.names[n] in names for names in others) for n in table.name], dtype=np.bool_
    )
    kept = np.flatnonzero(is_left)
    used = sorted({int(n) for n in table.name[kept]})
    number = {n: k for k, n in enumerate(used)}
    return PairTable(
        a=table.a[kept],
        b=table.b[kept],
        name=np.array([number[int(n)] for n in table.name[kept]], dtype=np.intp),
        names=tuple(table.names[n] for n in used),
        is_neighbour=table.is_neighbour[kept],
        weights=table.weights[kept],
    )
