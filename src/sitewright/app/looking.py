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


def find_proposal(project: Project, code: str | None = None) -> FoundProposal:
    """Return the one proposal with a check code or fingerprint, or the newest of all.

    Raises:
        ApprovalError: None has it, or more than one.
    """
    files = [
        (file.stat().st_mtime_ns, folder, file.stem)
        for folder in run_folders(project.folder / "runs")
        for file in (folder.path / "proposals").glob("*.json")
    ]
    wanted = (code or "").strip()
    fitting = [f for f in files if wanted.upper() == check_code(f[2]) or f[2] == wanted.lower()]
    if not wanted:
        fitting = sorted(files, key=lambda f: (f[0], f[2]))[-1:]
    if len({f[2] for f in fitting}) != 1:
        raise ApprovalError(_none_or_many(project, wanted, len(fitting)))
    _, folder, digest = fitting[0]
    return _loaded(folder, digest)


def _loaded(folder: RunFolder, digest: str) -> FoundProposal:
    proposal = folder.load_proposal(digest)
    return FoundProposal(run=folder.run, fingerprint=digest, proposal=proposal)


def _none_or_many(project: Project, code: str, count: int) -> str:
    if count:
        return f"{count} proposals have the code {code}; give the whole fingerprint."
    which = f"with the code {code} " if code else ""
    return f"There is no proposal {which}in {project.folder / 'runs'}."
