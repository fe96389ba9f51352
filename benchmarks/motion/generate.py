"""Makes the queries of the hard set, each with a certified witness path.

    python -m benchmarks.motion.generate [PER_FAMILY]

A trial that comes to nothing (a way that the arm cannot go, a slot that is none) is made again with
the next seed, so that the set is the same each time. Planners get the queries, never the witnesses.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator, Mapping

import numpy as np
from benchmarks.motion.families.crossing import both_arms_moving, over_the_fence_zone
from benchmarks.motion.families.neighbours import (
    long_piece_around_the_other_arm,
    nail_gun_beside_a_held_piece,
)
from benchmarks.motion.families.slots import last_stud, stud_between_studs
from benchmarks.motion.hard_set import QUERIES, WITNESSES, write
from benchmarks.motion.query import MotionQuery, to_plain
from benchmarks.motion.trial import NotNarrowError, Trial

from sitewright.robot_team.description import Joints

PER_FAMILY = 11
_MOST_TRIALS = 400
FAMILIES: Mapping[str, Callable[[np.random.Generator], Trial]] = {
    "stud-between-studs": stud_between_studs,
    "last-stud": last_stud,
    "nail-gun": nail_gun_beside_a_held_piece,
    "long-piece": long_piece_around_the_other_arm,
    "fence-zone": over_the_fence_zone,
    "both-arms": both_arms_moving,
}


def made(family: str, count: int) -> Iterator[tuple[MotionQuery, tuple[Joints, ...]]]:
    """Yield the queries of a family with their witnesses."""
    number = list(FAMILIES).index(family)
    found = 0
    for seed in range(_MOST_TRIALS):
        if found == count:
            return
        try:
            trial = FAMILIES[family](np.random.default_rng([number, seed]))
            query, witness = trial.query(family, found + 1)
        except NotNarrowError:
            continue
        found += 1
        yield query, witness


def main(per_family: int = PER_FAMILY) -> int:
    """Write all queries and witnesses."""
    for family in FAMILIES:
        start = time.process_time()
        pairs = list(made(family, per_family))
        write(QUERIES / f"{family}.json", [to_plain(query) for query, _ in pairs])
        write(WITNESSES / f"{family}.json", {query.name: way for query, way in pairs})
        print(f"{family}: {len(pairs)} queries in {time.process_time() - start:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
