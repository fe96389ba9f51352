"""How fast the simulated cell runs: times real time, rebuild, checkpoint.

    python benchmarks/bench_simulation.py

Two arms, two supports, a stack of four; medians.
"""

from __future__ import annotations

import json
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

import builders_cell as site
from sitewright.robot_team.description import Joints
from sitewright.robot_team.drivers.mujoco.codec import Setup, checkpoint_to_json
from sitewright.robot_team.drivers.mujoco.motions import follow
from sitewright.robot_team.drivers.mujoco.opening import open_simulation
from sitewright.robot_team.drivers.mujoco.skills.registry import execute

FAR = (1.2, -1.2, 1.5, 0.8, 1.0, 0.5)


def median_s(act: Callable[[], object], count: int = 9) -> float:
    """Return the median duration of an act."""
    times = []
    for _ in range(count):
        start_s = time.perf_counter()
        act()
        times.append(time.perf_counter() - start_s)
    return statistics.median(times)


def main() -> None:
    """Print the figures as JSON."""
    sim = open_simulation(Setup(cell=site.cell(), pieces=site.pieces()), None, lambda _: None)
    mover = site.Mover(sim.cell)

    def there_and_back(*ways: Joints) -> float:
        begun_s, started_s = sim.time_s, time.perf_counter()
        followed = follow(sim, mover.through(site.A, *ways))
        if followed.failure:
            raise SystemExit(followed.detail)
        return (sim.time_s - begun_s) / (time.perf_counter() - started_s)

    empty = statistics.median(there_and_back(FAR, site.HOME) for _ in range(5))
    grasp = site.grasp_pose(sim.physics.pose("thin-4"))
    lift = site.over(grasp, 0.4)
    execute(sim, site.command("reach", site.A, mover.to_tcp(site.A, site.GRIPPER, lift, grasp)))
    order = site.command("grasp", site.A, piece="thin-4", width_m=0.09, tolerance_m=0.002)
    if not execute(sim, order)[0].is_done:
        raise SystemExit("the grasp failed")
    execute(sim, site.command("reach", site.A, mover.to_tcp(site.A, site.GRIPPER, lift)))
    high = mover.q[site.A]
    aside = (high[0] + 0.6, *high[1:])
    holding = statistics.median(there_and_back(aside, high) for _ in range(5))
    figures = {
        "times_real_time": round(empty, 1),
        "times_real_time_holding": round(holding, 1),
        "rebuild_ms": round(1e3 * median_s(lambda: sim.fix(sim.fixings)), 2),
        "checkpoint_ms": round(1e3 * median_s(lambda: checkpoint_to_json(sim.checkpoint())), 2),
    }
    print(json.dumps(figures))


if __name__ == "__main__":
    main()
