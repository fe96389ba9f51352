"""A design that changed under a chain of runs: what the journal says, and designs kept by hash."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from sitewright.app.project import BUILDING, Project
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import AnyEvent, DesignChanged, ProposalSuperseded
from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.sentence import Sentence
from sitewright.journal.blobs import write_whole

_REASON = Sentence("The design changed after this plan was made.")


def design_change(
    state: CycleState, model_sha256: str, pieces: Collection[ComponentId] | None = None
) -> DesignChanged | None:
    """Return the event that the design is another one than the chain's; None if it is the same.

    Args:
        state: The folded chain, over the targets and operations of the design as it is now.
        model_sha256: Hash of the design's file now.
        pieces: Stock of the design; None if it is not known.
    """
    if model_sha256 in {"", state.model_sha256} or not state.model_sha256:
        return None
    site = state.site
    seen = site.sensed.world_T_piece if site.sensed is not None else {}
    return DesignChanged(
        old_sha256=state.model_sha256,
        model_sha256=model_sha256,
        reopened=tuple(t for t in site.installed if not site.is_secured(t)),
        gone=() if pieces is None else tuple(sorted(p for p in seen if p not in pieces)),
    )


def told(state: CycleState, change: DesignChanged | None, at_utc_ns: int) -> list[AnyEvent]:
    """Return what the journal is told of a change: the open proposal dies with the old design."""
    if change is None:
        return []
    if state.proposal is None:
        return [change]
    dead = ProposalSuperseded(
        fingerprint=state.proposal.fingerprint,
        reason=_REASON,
        is_replan=False,
        at_utc_ns=at_utc_ns,
    )
    return [dead, change]


def keep_design(folder: Path) -> None:
    """Keep the design as it is now under its hash, so that its runs can be read for ever."""
    data = (folder / BUILDING).read_bytes()
    file = _design_file(folder, sha256_hex(data))
    if not file.exists():
        file.parent.mkdir(parents=True, exist_ok=True)
        write_whole(file, data)


def kept_design(folder: Path, model_sha256: str) -> BuildingModel | None:
    """Return the design with a hash: the one in use or a kept one; None if it was not kept."""
    for file in (folder / BUILDING, _design_file(folder, model_sha256)):
        if file.exists() and sha256_hex(file.read_bytes()) == model_sha256:
            return read_building(file)
    return None


def project_at(project: Project, model_sha256: str) -> Project:
    """Return the project with the design that a run was about, as far as it was kept."""
    model = kept_design(project.folder, model_sha256) if model_sha256 else None
    return project if model is None else project.with_model(model)


def _design_file(folder: Path, model_sha256: str) -> Path:
    return folder / "runs" / "designs" / f"{model_sha256}.json"
