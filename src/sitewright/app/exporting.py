"""Writes the as-built state of a project for other programs: JSON, CSV, or onto a copy."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

from sitewright.app.clock import SystemClock
from sitewright.app.installing import as_built_model, installed_times, iso_time
from sitewright.app.project import Project, ProjectError
from sitewright.app.run import fold_of, newest_run
from sitewright.app.run_folder import chain_of
from sitewright.building_model.as_built_table import as_built_csv, status_by_source
from sitewright.building_model.formats.native import write_building
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.site_state import site_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Export:
    """What was written.

    Attributes:
        files: Every file, the main one first.
        notes: What could not be carried over, one sentence each.
    """

    files: tuple[Path, ...]
    installed: int
    notes: tuple[str, ...] = ()


def as_built_now(project: Project) -> BuildingModel:
    """Return the design with everything folded in that the project's runs have built."""
    newest = newest_run(project.folder / "runs")
    if newest is None:
        return project.model
    chain = chain_of(newest)
    site = fold_of(chain, site_of(project.model))[0].site
    return as_built_model(project.model, site, installed_times(chain))


def export_json(project: Project, out: Path) -> Export:
    """Write the as-built model in the native schema."""
    model = as_built_now(project)
    write_building(model, out)
    return Export(files=(out,), installed=_installed(model))


def export_csv(project: Project, out: Path) -> Export:
    """Write a table of components, and `status.json` beside it if they have source ids."""
    model = as_built_now(project)
    out.write_text(as_built_csv(model, project.cell.world_T_model), encoding="utf-8")
    return Export(files=(out, *_status_file(project, model, out)), installed=_installed(model))


def export_ifc(project: Project, original: Path, out: Path) -> Export:
    """Write the as-built state as added lines on a copy of the original IFC file.

    Raises:
        BackendMissingError: The extra ``[ifc]`` is not installed.
        ModelRejectedError: The original cannot be read.
    """
    from sitewright.building_model.formats import ifc_export

    model = as_built_now(project)
    now = iso_time(SystemClock().utc_ns())
    patch = ifc_export.export_ifc(
        original, model, out, written_at=now, world_T_model=project.cell.world_T_model
    )
    missing = tuple(
        f"{i} is not in {original.name}; nothing was written of it." for i in patch.not_found
    )
    return Export(
        files=(patch.path, *_status_file(project, model, out)),
        installed=len(patch.written),
        notes=(f"{patch.lines_added} lines added, none removed.", *missing),
    )


def export_rhino(project: Project, original: Path, out: Path) -> Export:
    """Write the as-built state onto a copy of the original Rhino file, and tell what it loses.

    Raises:
        BackendMissingError: The extra ``[rhino]`` is not installed.
        ModelRejectedError: The original cannot be read.
    """
    from sitewright.building_model.formats import rhino_export

    model = as_built_now(project)
    status = status_by_source(model, project.cell.world_T_model)
    copy = rhino_export.export_rhino(original, status, out)
    missing = (f"{i} is not in {original.name}; nothing was written of it." for i in copy.not_found)
    return Export(
        files=(copy.path, *_status_file(project, model, out)),
        installed=len(copy.written),
        notes=(*copy.losses, *missing),
    )


def original_of(project: Project, kind: str) -> Path:
    """Return the file that a project was imported from.

    Raises:
        ProjectError: Nothing of the model comes from a file of that kind, or it is gone.
    """
    sources = [s for s in project.model.sources if s.kind.startswith(kind)]
    sources += [
        c.source
        for c in project.model.component_by_id.values()
        if c.source is not None and c.source.kind.startswith(kind)
    ]
    names = {s.file for s in sources if s.file}
    found = [p for n in sorted(names) for p in (Path(n), project.folder / n) if p.exists()]
    if not found:
        listed = f" ({', '.join(sorted(names))})" if names else ""
        raise ProjectError(
            f"The {kind} file that {project.folder} was imported from is not there{listed}. "
            "Name it with --original."
        )
    return found[0]


def _status_file(project: Project, model: BuildingModel, beside: Path) -> tuple[Path, ...]:
    status = status_by_source(model, project.cell.world_T_model)
    if not status:
        return ()
    path = beside.with_name("status.json")
    path.write_text(json.dumps(status, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
    return (path,)


def _installed(model: BuildingModel) -> int:
    return sum(c.as_built is not None for c in model.component_by_id.values())
