"""From what a reader handed over to the building model; every importer but one ends here."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from sitewright.building_model.check_geometry import geometry_problems
from sitewright.building_model.check_references import reference_problems
from sitewright.building_model.component import (
    BoxGeometry,
    Component,
    Layer,
    PlaneCut,
    Source,
)
from sitewright.building_model.formats.component_shape import shaped
from sitewright.building_model.formats.detect import refused
from sitewright.building_model.formats.drawn_stacks import drawn_stacks
from sitewright.building_model.formats.import_map import ImportMap
from sitewright.building_model.formats.neutral import (
    BoxSolid,
    ExtrusionSolid,
    NeutralFile,
)
from sitewright.building_model.formats.neutral_relations import relation_of
from sitewright.building_model.formats.neutral_scale import Scale, bound_problems, scale_of
from sitewright.building_model.formats.part_drafts import Choices, Draft, drafts_of
from sitewright.building_model.formats.part_names import Directory, double_ids
from sitewright.building_model.formats.user_operations import operations_of
from sitewright.building_model.formats.user_text import (
    WrongValueError,
    positive_number,
    whole_number,
    word,
    yes_or_no,
)
from sitewright.building_model.model import BuildingModel
from sitewright.errors import ModelRejectedError, Problem
from sitewright.foundation.canonical import Json, sha256_hex
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, norm, scale, subtract, unit

_LAYER_FIRST = frozenset({"rhino"})
"""Kinds of files whose authors name the type by layer rather than by what holds it."""
_NO_TYPE = "component"
Value = TypeVar("Value", int, float, bool)


def model_of(
    neutral: NeutralFile,
    path: Path,
    *,
    unit: str | None = None,
    mapping: ImportMap | None = None,
    repair: str | None = None,
    split: bool = False,
) -> tuple[BuildingModel, list[Problem]]:
    """Return the building model of a foreign file, with warnings.

    Args:
        neutral: What its reader found, in the file's own unit.
        path: The file, for messages and `BuildingModel.sources`.
        unit: Length unit that the user states; needed if the file states none.
        mapping: What foreign keys and layers mean.
        repair: ``hull`` closes open meshes by their convex hull.
        split: Parts of several bodies become several components.

    Raises:
        ModelRejectedError: Something in it is wrong; all of it is listed.
    """
    if not neutral.parts:
        raise refused(path, "E3", "read 0 parts.", "Export a model that holds solids.")
    problems = list(bound_problems(neutral, path.name))
    _raise_errors(path, problems)
    scaling, said = scale_of(path.name, neutral, unit)
    problems += [*said, *_notes(neutral, path)]
    if any(p.code == "O1" and p.severity == "E" for p in problems):  # too large to calculate with
        raise ModelRejectedError(str(path), problems)
    choices = Choices(words=mapping or ImportMap(), repairs_hull=repair == "hull", is_split=split)
    drafts, said = drafts_of(neutral.parts, scaling, choices)
    if any(p.code == "U1" for p in problems):  # sizes in an unknown unit say nothing
        said = [p for p in said if not p.code.startswith("G")]
    problems += [*said, *double_ids([d.named for d in drafts])]
    components, said = _components(drafts, scaling, neutral.kind)
    problems += said
    if not drafts and not any(p.severity == "E" for p in problems):
        raise refused(path, "E3", "it holds no solids.", "Export a model that holds solids.")
    _raise_errors(path, problems)
    model = _model(neutral, path, components, drafts, scaling)
    problems += [*geometry_problems(model), *reference_problems(model)]
    _raise_errors(path, problems)
    return model, problems


def _raise_errors(path: Path, problems: Sequence[Problem]) -> None:
    if any(p.severity == "E" for p in problems):
        raise ModelRejectedError(str(path), problems)


def _notes(neutral: NeutralFile, path: Path) -> Iterator[Problem]:
    for note in neutral.notes:
        yield Problem(code="G7", severity="W", where=path.name, message=note, fix="")


def _model(
    neutral: NeutralFile,
    path: Path,
    components: Mapping[ComponentId, Component],
    drafts: Sequence[Draft],
    scaling: Scale,
) -> BuildingModel:
    directory = Directory([d.named for d in drafts])
    places = {d.named.id: d.attributes for d in drafts}
    stacks, moved = drawn_stacks(components, places)
    placed = {**components, **moved}
    return BuildingModel(
        name=word(path.stem),
        component_by_id={i: placed[i] for i in sorted(placed)},
        relations=tuple(
            sorted(
                (
                    relation
                    for stated in neutral.relations
                    if (relation := relation_of(stated, directory, scaling)) is not None
                ),
                key=lambda r: (r.kind, r.a, r.b),
            )
        ),
        stacks=stacks,
        sources=(_file_source(neutral, path),),
        origin_shift_m=scaling.shift_m,
        raw=neutral.raw,
    )


def _file_source(neutral: NeutralFile, path: Path) -> Source:
    digest = sha256_hex(path.read_bytes()) if path.is_file() else ""
    return Source(file=word(path.name), kind=neutral.kind, id="", sha256=digest)


def _components(
    drafts: Sequence[Draft], scaling: Scale, kind: str
) -> tuple[dict[ComponentId, Component], list[Problem]]:
    directory = Directory([d.named for d in drafts])
    components: dict[ComponentId, Component] = {}
    problems: list[Problem] = []
    for draft in drafts:
        made, said = _component(draft, scaling, kind, directory)
        problems += said
        if made is not None:
            components[made.id] = made
    return components, problems


def _component(
    draft: Draft, scaling: Scale, kind: str, directory: Directory
) -> tuple[Component | None, list[Problem]]:
    shape = shaped(draft.pieces)
    if shape is None:
        return None, [_problem(draft, "G6", "It has no volume.", "Give it one, or delete it.")]
    geometry, pose = shape
    if isinstance(geometry, BoxGeometry) and min(geometry.size_m) <= 0.0:
        sizes = " x ".join(f"{s:g}" for s in geometry.size_m)
        return None, [_problem(draft, "G6", f"Its box is {sizes} m.", "Give it a size.")]
    parents, problems = _parents(draft, directory)
    numbers, said = _numbers(draft)
    operations, wrong = operations_of(draft.named, draft.attributes, pose, scaling, directory)
    cuts, bad = _cuts(draft, pose, scaling)
    component = Component(
        id=draft.named.id,
        layer=draft.layer,
        type=_type(draft, kind),
        geometry=geometry,
        world_T_component=pose,
        name=draft.named.name,
        material=word(draft.attributes.get("material") or draft.part.material),
        group=word(draft.attributes.get("group") or draft.part.group or draft.reading.group),
        order=numbers.order,
        construction_parents=parents,
        ground=numbers.ground,
        cuts=cuts,
        mass_kg=numbers.mass_kg,
        operations=operations,
        source=Source(file="", kind=kind, id=word(draft.part.source_id)),
        raw=draft.attributes.rest,
        ext=_wishes(draft),
    )
    return component, [*problems, *said, *wrong, *bad]


def _type(draft: Draft, kind: str) -> str:
    part, layer = draft.part.type, draft.reading.type
    found = (layer or part) if kind in _LAYER_FIRST else (part or layer)
    return word(draft.attributes.get("type") or found) or _NO_TYPE


def _wishes(draft: Draft) -> dict[str, Json]:
    """Return process and method that were asked for without saying where."""
    keys = ("process", "method")
    return {k: word(v) for k in keys if (v := draft.attributes.get(k))}


@dataclass(frozen=True, slots=True, kw_only=True)
class _Numbers:
    """Order, mass and ground of a draft."""

    order: int | None
    mass_kg: float | None
    ground: bool


def _numbers(draft: Draft) -> tuple[_Numbers, list[Problem]]:
    order, wrong_order = _value(draft, "order", whole_number)
    mass_kg, wrong_mass = _value(draft, "mass_kg", positive_number)
    ground, wrong_ground = _value(draft, "ground", yes_or_no)
    numbers = _Numbers(
        order=draft.part.order if order is None else order,
        mass_kg=mass_kg,
        ground=draft.part.is_ground if ground is None else ground,
    )
    return numbers, [*wrong_order, *wrong_mass, *wrong_ground]


def _value(
    draft: Draft, key: str, read: Callable[[str], Value]
) -> tuple[Value | None, list[Problem]]:
    """Return the value of one of our keys; None without one."""
    text = draft.attributes.get(key)
    if not text:
        return None, []
    try:
        return read(text), []
    except WrongValueError as error:
        return None, [_problem(draft, "K1", f"Its {key}: {error}.", "Correct the value.")]


def _parents(draft: Draft, directory: Directory) -> tuple[tuple[ComponentId, ...], list[Problem]]:
    stated = draft.attributes.get("parent")
    references = [r.strip() for r in stated.split(";")] if stated else list(draft.part.parents)
    parents, problems = [], []
    for reference in (r for r in references if r):
        found = directory.find(reference, draft.named, "Construction parent")
        if isinstance(found, Problem):
            problems.append(found)
        else:
            parents.append(found)
    return tuple(dict.fromkeys(parents)), problems


def _cuts(draft: Draft, pose: Pose, scaling: Scale) -> tuple[tuple[PlaneCut, ...], list[Problem]]:
    """Return the saw cuts in the component's frame; the file has them in its solid's."""
    if not draft.part.cuts:
        return (), []
    solid = draft.part.solids[0]
    if not isinstance(solid, BoxSolid | ExtrusionSolid) or len(draft.pieces) > 1:
        message = "It has saw cuts, but they belong to no single box or profile."
        return (), [_problem(draft, "G7", message, "Model it as one solid.", "W")]
    frame = solid.file_T_box if isinstance(solid, BoxSolid) else solid.file_T_profile
    cuts = []
    for cut in draft.part.cuts:
        if not 0.0 < norm(cut.normal) < float("inf"):
            return (), [_problem(draft, "G6", "One of its cuts has no direction.", "Repair it.")]
        point = subtract(scale(frame.apply(cut.point_m), scaling.metres), scaling.shift_m)
        back = pose.inverse()
        cuts.append(PlaneCut(back.apply(point), unit(back.turn(frame.turn(cut.normal)))))
    return tuple(cuts), []


def _problem(draft: Draft, code: str, message: str, fix: str, severity: str = "E") -> Problem:
    return Problem(
        code=code,
        severity=severity,
        where=draft.named.id,
        message=message,
        fix=fix,
        source_id=draft.named.source_id,
    )


def targets_in(model: BuildingModel) -> int:
    """Return how many components are still to be built."""
    return sum(c.layer is Layer.TARGET for c in model.component_by_id.values())
