"""What certificates cost while a building is planned, and what their audit costs.

    python benchmarks/bench_certificates.py [EXAMPLE]

Every certificate that planning asks for is timed where it is asked for. CPU milliseconds.
"""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass, field, replace

import numpy as np
from typing_extensions import override

from sitewright.app.engines import proposals_of
from sitewright.app.planning import start_of
from sitewright.app.project import example_folder, open_project
from sitewright.central_controller.ports import Planned
from sitewright.central_controller.rehearsal import rehearsed
from sitewright.planning_twin.backends.audit.reproof import SeparatingPlanes
from sitewright.planning_twin.motion import Certificate, Certifier, JointPath, TeamPath
from sitewright.planning_twin.refusal import NotClear
from sitewright.planning_twin.scene import SceneSnapshot

AIM_P50_MS = 20.0


@dataclass
class TimedCertifier(Certifier):
    """Another certifier, with the time of each certificate and what it was about."""

    certifier: Certifier
    made: list[tuple[float, SceneSnapshot, JointPath | TeamPath, Certificate]] = field(
        default_factory=list
    )

    @override
    def certify(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> Certificate | NotClear:
        start = time.process_time()
        answer = self.certifier.certify(scene, path)
        if isinstance(answer, Certificate):
            self.made.append((time.process_time() - start, scene, path, answer))
        return answer

    @override
    def objection(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> NotClear | None:
        return self.certifier.objection(scene, path)


def main(example: str = "wooden_frame") -> int:
    """Plan a building, then audit each certificate that was made; print the figures."""
    project = open_project(example_folder(example))
    proposals = proposals_of(project)
    backends = proposals.ports.backends
    timed = TimedCertifier(backends.certifier)
    ports = replace(proposals.ports, backends=replace(backends, certifier=timed))
    proposals, context = replace(proposals, ports=ports), start_of(project)
    while isinstance(outcome := proposals.propose(context), Planned):
        context = rehearsed(context, outcome.proposal)
    auditing = []
    for _, scene, path, certificate in timed.made:
        start = time.process_time()
        if SeparatingPlanes().reprove(scene, path, certificate).objections:
            print(f"not proven again: {certificate}")
            return 1
        auditing.append(time.process_time() - start)
    proving = [spent for spent, *_ in timed.made]
    for name, spent in (("certificate", proving), ("audit", auditing)):
        ms = np.array(spent) * 1e3
        p50, p95 = np.percentile(ms, (50, 95))
        print(
            f"{name:12} {len(ms)} motions  p50 {p50:6.1f}  p95 {p95:6.1f}  max {ms.max():6.1f} ms"
        )
    return 0 if np.median(proving) * 1e3 <= AIM_P50_MS else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
