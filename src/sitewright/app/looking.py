"""Looks at a project without changing it: its graph now, and the proposals of its runs."""

from __future__ import annotations

from dataclasses import dataclass

from sitewright.app.planning import start_of
from sitewright.app.project import Project
from sitewright.app.run import fold_of, newest_run
from sitewright.app.run_folder import RunFolder, chain_of, run_folders
from sitewright.central_controller.fingerprint import check_code
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.proposal import Proposal
from sitewright.central_controller.site_graph import graph_now
from sitewright.central_controller.site_state import SiteState, site_of
from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.errors import ApprovalError


@dataclass(frozen=True, slots=True, kw_only=True)
class FoundProposal:
    """A proposal with the run that holds it."""

    run: str
    fingerprint: str
    proposal: Proposal


def graph_of_site(project: Project) -> ConstructionGraph:
    """Return the graph of the site as the newest run left it, or as designed."""
    newest = newest_run(project.folder / "runs")
    site = site_of(project.model)
    if newest is not None:
        site = fold_of(chain_of(newest), site)[0].site
    return graph_at(project, site)


def graph_at(project: Project, site: SiteState) -> ConstructionGraph:
    """Return the graph of a folded site, with the poses that were sensed last."""
    start = start_of(project)
    seen = site.sensed if site.sensed is not None else start.observation
    context = SiteContext(run=start.run, site=site, observation=seen)
    return graph_now(project.model, project.cell, context)


def find_proposal(
    project: Project, code: str | None = None, target: str | None = None
) -> FoundProposal:
    """Return a proposal of the project's runs.

    Args:
        project: The project.
        code: Its check code or fingerprint; only one proposal may have it.
        target: Only proposals for this target count.

    Returns:
        The one with the code, else the newest.

    Raises:
        ApprovalError: There is none, or more than one.
    """
    wanted = (code or "").strip()
    fitting = [f for f in _newest_first(project) if _has_code(f[1], wanted)]
    if wanted and len({digest for _, digest in fitting}) > 1:
        raise ApprovalError(
            f"{len(fitting)} proposals have the code {wanted}; give the whole fingerprint."
        )
    for folder, digest in fitting:
        found = _loaded(folder, digest)
        if target in {None, found.proposal.target}:
            return found
    which = f"with the code {wanted} " if wanted else ""
    about = f"for {target!r} " if target is not None else ""
    raise ApprovalError(f"There is no proposal {which}{about}in {project.folder / 'runs'}.")


def _newest_first(project: Project) -> list[tuple[RunFolder, str]]:
    files = [
        (file.stat().st_mtime_ns, file.stem, folder)
        for folder in run_folders(project.folder / "runs")
        for file in (folder.path / "proposals").glob("*.json")
    ]
    files.sort(key=lambda f: f[:2], reverse=True)
    return [(folder, digest) for _, digest, folder in files]


def _has_code(digest: str, wanted: str) -> bool:
    return not wanted or wanted.upper() == check_code(digest) or wanted.lower() == digest


def _loaded(folder: RunFolder, digest: str) -> FoundProposal:
    proposal = folder.load_proposal(digest)
    return FoundProposal(run=folder.run, fingerprint=digest, proposal=proposal)
