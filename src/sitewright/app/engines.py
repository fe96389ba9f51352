"""The composition root of planning: which engine stands behind which port."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path

from sitewright.app.clock import SystemClock
from sitewright.app.project import BUILDING, Project
from sitewright.central_controller.design import Design
from sitewright.central_controller.measuring import MeasuredCertifier
from sitewright.central_controller.proposing import Proposals
from sitewright.central_controller.site_graph import SiteGraphs
from sitewright.central_controller.situation import piece_shapes
from sitewright.central_controller.target_planning import PlanningPorts
from sitewright.foundation.canonical import sha256_hex
from sitewright.symbolic_planning.vocabulary import domain_at


def proposals_of(project: Project, *, seed: int = 0) -> Proposals:
    """Return the proposal source of a project, with all its engines.

    Raises:
        BackendMissingError: An engine is not installed.
        BuildingModelError: The project's own domain cannot be used.
    """
    from sitewright.planning_twin.backends.twin import make_backends
    from sitewright.symbolic_planning.planners.fast_downward import FastDownward

    clock = SystemClock()
    backends = make_backends()
    certifier = MeasuredCertifier(backends.certifier, clock)
    ports = PlanningPorts(
        domain=domain_at(project.domain_file),
        symbolic=FastDownward(),
        backends=replace(backends, certifier=certifier),
        clock=clock,
        certifying_s=lambda: certifier.spent_s,
    )
    return Proposals(
        design=Design(model=project.model, cell=project.cell),
        shapes=piece_shapes(project.model),
        ports=ports,
        graph_of=SiteGraphs(project.model, project.cell),
        identity=identity_of(project, ports.domain.text),
        seed=seed,
        unsupported=project.unsupported,
    )


def identity_of(project: Project, domain_text: str) -> Mapping[str, str]:
    """Return the hashes that tie a proposal to this team, cell, model and domain."""
    return {
        "model": _file_hash(project.folder / BUILDING),
        "cell": _file_hash(project.cell_file),
        "domain": sha256_hex(domain_text),
        "software": version("sitewright"),
    }


def _file_hash(path: Path) -> str:
    return sha256_hex(path.read_bytes())
