"""Takes a changed file into its project: a merge, a diff, and what stands is protected."""

from __future__ import annotations

import json
from contextlib import nullcontext
from dataclasses import dataclass, fields, replace
from pathlib import Path

from sitewright.app.clock import SystemClock
from sitewright.app.design_changes import design_change, keep_design, told
from sitewright.app.event_log import EventLog
from sitewright.app.ids import UuidSource
from sitewright.app.import_notes import NOTES, notes_file
from sitewright.app.import_records import (
    imported_source,
    read_back,
    read_record,
    sources_with,
)
from sitewright.app.importing import ImportOptions, keeping_record, read_design
from sitewright.app.inferring import surroundings_of
from sitewright.app.locks import locked
from sitewright.app.marked_files import as_designed
from sitewright.app.model_changes import Change, changes_between, patched
from sitewright.app.model_writing import BACKUP, OpenRunError, require_readable
from sitewright.app.project import BUILDING, CELL, ProjectError
from sitewright.app.reinferring import inferred_anew, is_inferred, stated_facts, with_stock_of
from sitewright.app.run import fold_of, newest_run
from sitewright.app.run_folder import RunFolder, chain_of
from sitewright.building_model.component import Layer, Source
from sitewright.building_model.formats.native import read_building
from sitewright.building_model.inference.bare import without_inferred
from sitewright.building_model.laying import lying_as
from sitewright.building_model.merging import (
    Conflict,
    Preference,
    in_coordinates_of,
    merged_design,
)
from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.protection import protection_problems, targets_in_work
from sitewright.central_controller.site_state import site_of
from sitewright.errors import Problem
from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.json_layout import laid_out
from sitewright.journal.blobs import write_whole
from sitewright.journal.sqlite import SqliteJournal

_FIX = (
    "Undo that in the file, or take the rest with --keep-installed; to build it otherwise, "
    "begin on an empty site (run --from-design)."
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Wishes:
    """What is to become of a changed file.

    Attributes:
        write: Change the project; nothing is written if nothing differs or something is wrong.
        keeps_installed: What stands stays as it is, the rest of the file is taken.
        prefer: Who wins where file and user both changed a fact.
        base: The file that the project was made of, if the project kept no record of it.
    """

    write: bool = False
    keeps_installed: bool = False
    prefer: Preference = Preference.MINE
    base: Path | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Reimport:
    """What a changed file does to its project.

    Attributes:
        changes: What differs in the building, fact by fact.
        conflicts: Facts that file and user changed differently.
        problems: Of the file, of what stands (I1), and what inference leaves open.
        superseded: Fingerprint of the open proposal that died; empty if there was none.
        is_written: ``building.json`` was changed; the old one is ``building.json.bak``.
    """

    folder: Path
    kind: str
    before: BuildingModel
    after: BuildingModel
    changes: tuple[Change, ...]
    conflicts: tuple[Conflict, ...] = ()
    problems: tuple[Problem, ...] = ()
    superseded: str = ""
    is_written: bool = False

    @property
    def is_refused(self) -> bool:
        """Whether something stands in the way of taking the file."""
        return any(p.severity == "E" and p.code == "I1" for p in self.problems)


@dataclass(frozen=True, slots=True, kw_only=True)
class _History:
    """The newest run of the project, if there is one, with its folded state."""

    run: RunFolder | None
    state: CycleState


def reimport_file(
    file: Path, folder: Path, options: ImportOptions, wishes: Wishes | None = None
) -> Reimport:
    """Merge a changed design file into the project that was made of it.

    Facts that only the file changed are taken, facts that only the user changed stay, inferred
    facts are inferred anew; what is installed or in work must not differ.

    Args:
        file: The changed file.
        folder: The project.
        options: How to take it; what is left out is as at the import before.
        wishes: What is to become of it.

    Raises:
        ModelRejectedError: The file cannot be read, or the merged design refers to what is gone.
        ProjectError: It is another kind of file, or nobody knows what was imported before.
        LockedError: A run is going on; only when writing.
        OpenRunError: A step of the open run is under way or in question; only when writing.
    """
    wishes = wishes or Wishes()
    lock = locked(folder / "runs" / "lock", "The project") if wishes.write else nullcontext()
    with lock:
        data = (folder / BUILDING).read_bytes()
        history = _history(folder)
        if wishes.write:
            _refuse_motion(folder, history)
        found, kept = _merged(file, folder, options, wishes, history)
        if not wishes.write or found.is_refused or not found.changes:
            return found
        return _written(folder, data, found, kept, history)


def _merged(
    file: Path, folder: Path, options: ImportOptions, wishes: Wishes, history: _History
) -> tuple[Reimport, dict[str, bytes]]:
    old = read_building(folder / BUILDING)
    source = _source(folder, old, wishes)
    options = _as_before(options, source, folder)
    kind, read, said = read_design(file, options)
    if source.kind not in {"", read.sources[-1].kind}:
        raise ProjectError(
            f"{folder} was imported from {source.file} ({source.kind}), and {file} is another "
            f"kind of file ({read.sources[-1].kind}). Import it into a new folder."
        )
    read, kept = keeping_record(as_designed(read, old, history.state.site), options)
    base = _base(folder, source, options, wishes)
    base, theirs = (without_inferred(in_coordinates_of(d, old)) for d in (base, read_back(read)))
    mine = stated_facts(old, base)
    merged, conflicts = merged_design(base, mine, theirs, wishes.prefer)
    merged = replace(merged, sources=sources_with(old, source, read.sources[-1]))
    if targets_in_work(history.state):
        merged = lying_as(merged, old)
    merged, protected = _protected(mine, merged, old, history, wishes)
    after, open_points = merged, list[Problem]()
    if is_inferred(old):
        after, open_points = inferred_anew(
            merged,
            old,
            [t for t in targets_in_work(history.state) if t in merged.component_by_id],
            surroundings_of(folder / CELL),
            has_history=history.run is not None,
        )
    return Reimport(
        folder=folder,
        kind=str(kind),
        before=old,
        after=after,
        changes=tuple(c for c in changes_between(old, after) if c.key != "sources"),
        conflicts=tuple(conflicts),
        problems=(*said, *protected, *open_points),
    ), {**kept, **notes_file((*said, *open_points))}


def _protected(
    mine: BuildingModel,
    merged: BuildingModel,
    old: BuildingModel,
    history: _History,
    wishes: Wishes,
) -> tuple[BuildingModel, list[Problem]]:
    """Return the merged design with what stands, and what the file wanted otherwise there."""
    before, wanted = with_stock_of(mine, old), with_stock_of(merged, old)
    problems = protection_problems(before, wanted, history.state, _FIX)
    if not problems or not wishes.keeps_installed:
        return merged, problems
    names = [ComponentId(p.where) for p in problems]
    kept = {i: mine.component_by_id[i] for i in names if i in mine.component_by_id}
    components = {**merged.component_by_id, **kept}
    stacks = {s.id: s for s in merged.stacks}
    for stack in mine.stacks:
        if any(i in kept for i in stack.items):
            items = tuple(i for i in stack.items if i in components)
            stacks[stack.id] = replace(stack, items=items)
    merged = replace(
        merged,
        component_by_id={i: components[i] for i in sorted(components)},
        stacks=tuple(stacks[i] for i in sorted(stacks)),
    )
    fix = "It stays as it is."
    return merged, [replace(p, severity="W", fix=fix) for p in problems]


def _source(folder: Path, design: BuildingModel, wishes: Wishes) -> Source:
    source = imported_source(design)
    if source is not None:
        return source
    if wishes.base is None:
        raise ProjectError(
            f"{folder / BUILDING} does not say what was imported before, so what you changed "
            "cannot be told from what the file says. Name the old file: --base FILE."
        )
    return design.sources[-1] if design.sources else Source(file="", kind="", id="")


def _as_before(options: ImportOptions, source: Source, folder: Path) -> ImportOptions:
    """Return the options with those of the import before where none is given."""
    default = ImportOptions()
    known = {
        f.name: source.options[f.name]
        for f in fields(ImportOptions)
        if f.name in source.options and getattr(options, f.name) == getattr(default, f.name)
    }
    if isinstance(words := known.get("map_file"), str):
        return replace(options, **{**known, "map_file": folder / words})  # type: ignore[arg-type]
    return replace(options, **known)  # type: ignore[arg-type]


def _base(folder: Path, source: Source, options: ImportOptions, wishes: Wishes) -> BuildingModel:
    if wishes.base is None:
        return read_record(folder, source)
    return read_back(read_design(wishes.base, options)[1])


def _history(folder: Path) -> _History:
    design = site_of(read_building(folder / BUILDING))
    newest = newest_run(folder / "runs")
    if newest is None:
        return _History(run=None, state=CycleState(site=design))
    return _History(run=newest, state=fold_of(chain_of(newest), design)[0])


def _refuse_motion(folder: Path, history: _History) -> None:
    """Refuse while a step has no known end: what it did is not known to be of which design."""
    state = history.state
    if history.run is None or (state.flight is None and state.question is None):
        return
    run = history.run.run
    raise OpenRunError(
        f"A step of run {run} was started and its end is not settled, so the design must not "
        f"change. Settle it first: sitewright run {folder}"
    )


def _written(
    folder: Path, data: bytes, found: Reimport, kept: dict[str, bytes], history: _History
) -> Reimport:
    """Write record and building, the building last, and tell the open run."""
    document = patched(json.loads(data.decode("utf-8-sig")), found.before, found.after)
    text = laid_out(document)
    require_readable(text, found.after)
    if history.run is not None:
        keep_design(folder)
    for path, content in kept.items():
        (folder / path).parent.mkdir(exist_ok=True)
        write_whole(folder / path, content)
    if NOTES not in kept:
        (folder / NOTES).unlink(missing_ok=True)
    write_whole(folder / BACKUP, data)
    write_whole(folder / BUILDING, text.encode())
    return replace(found, is_written=True, superseded=_tell(text, found, history))


def _tell(text: str, found: Reimport, history: _History) -> str:
    """Write the change into the journal of the open run; return the proposal that died of it.

    If this is not reached, the next run finds the other design by its hash and does it.
    """
    if history.run is None or history.state.finished is not None:
        return ""
    state, _ = fold_of(chain_of(history.run), site_of(found.after))
    pieces = [i for i, c in found.after.component_by_id.items() if c.layer is not Layer.TARGET]
    clock = SystemClock()
    change = design_change(state, sha256_hex(text), pieces)
    events = told(state, change, clock.utc_ns())
    with SqliteJournal(history.run.journal) as journal:
        log = EventLog(history.run, journal, clock=clock, ids=UuidSource(clock))
        for event in events:
            log.append(event)
    return state.proposal.fingerprint if state.proposal is not None and events else ""
