"""Thousands of trajectories past thin planted things: is any certified that collides?

    python -m benchmarks.certificate_campaign [COUNT] [FIRST_SEED] [CLUTTER]

Sheets, wires and needles of 0.5 to 5 mm stand near the start, the middle or the end of a motion of
one arm or of both, near a held piece, a tool or a link; most of them about to touch. A certificate
is compared with samples a millimetre apart that MuJoCo looks at. With clutter, so many boxes stand
around, most of them so far away that a proof leaves them out by lengths alone.
"""

from __future__ import annotations

import json
import sys
import time
from collections import Counter

import numpy as np
from benchmarks.planted import look_densely, planted, with_clutter

from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.motion import Certificate

COUNT = 3000


def campaign(count: int, first_seed: int = 0, clutter: int = 0) -> tuple[Counter[str], list[float]]:
    """Return how many trajectories were what, and the CPU time of each certificate in ms."""
    counts: Counter[str] = Counter()
    proving: list[float] = []
    seed = first_seed
    while counts["trajectories"] < count:
        certifier = ConservativeAdvancement(ProofScenes())
        case = planted(certifier, seed)
        seed += 1
        if case is None:
            continue
        if clutter:
            case = with_clutter(case, seed, clutter)
        start = time.process_time()
        answer = certifier.certify(case.scene, case.path)
        spent_ms = (time.process_time() - start) * 1e3
        is_certified = isinstance(answer, Certificate)
        dense = look_densely(case)
        if is_certified:
            proving.append(spent_ms)
        if is_certified and dense.is_near:
            print(f"seed {seed - 1}: certified, but {dense} ({case.what})", file=sys.stderr)
        counts.update(
            {
                "trajectories": 1,
                "samples looked at": dense.samples,
                "certified": is_certified,
                "refused": not is_certified,
                "dense: collides": dense.collides,
                "dense: nearer than the clearance": dense.is_near,
                "certified, but collides": is_certified and dense.collides,
                "certified, but nearer than the clearance": is_certified and dense.is_near,
                "refused, but never nearer than the clearance": not is_certified
                and not dense.is_near,
            }
        )
    return counts, proving


def main(count: int = COUNT, first_seed: int = 0, clutter: int = 0) -> int:
    """Print the counts; the exit code says whether any certificate was wrong."""
    counts, proving = campaign(count, first_seed, clutter)
    p50, p95 = np.percentile(proving, (50, 95))
    print(json.dumps({**counts, "certificate p50 ms": p50, "p95 ms": p95}, indent=1))
    return 1 if counts["certified, but nearer than the clearance"] else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
