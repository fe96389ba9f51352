"""Parts of a foreign file, one by one: role, words and bodies; several bodies are told apart."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from sitewright.building_model.component import Layer
from sitewright.building_model.formats.component_shape import Piece, clusters_of, pieces_of
from sitewright.building_model.formats.import_map import ImportMap
from sitewright.building_model.formats.layer_rules import LayerReading, folded, reading_of
from sitewright.building_model.formats.neutral import NeutralPart
from sitewright.building_model.formats.neutral_scale import Scale
from sitewright.building_model.formats.part_names import Named, usable_id
from sitewright.building_model.formats.user_text import Attributes, attributes_of, word
from sitewright.errors import Problem, did_you_mean

WARNINGS = frozenset({"G1", "G5", "G7", "T1", "U2", "O1", "F1", "S1"})
"""Codes that a reader's own remarks carry without refusing the file."""
_ONE_PIECE = ("block", "instance")
_SHOWN = 3
_KEPT = 240


@dataclass(frozen=True, slots=True, kw_only=True)
class Draft:
    """A component to be.

    Attributes:
        pieces: Its bodies; at least one.
    """

    named: Named
    part: NeutralPart
    attributes: Attributes
    layer: Layer
    reading: LayerReading
    pieces: tuple[Piece, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Choices:
    """How the user wants doubtful parts to be taken.

    Attributes:
        repairs_hull: Open meshes become their convex hull.
        is_split: A part of several bodies becomes several components.
    """

    words: ImportMap
    repairs_hull: bool = False
    is_split: bool = False


def drafts_of(
    parts: Sequence[NeutralPart], scale: Scale, choices: Choices
) -> tuple[list[Draft], list[Problem]]:
    """Return a draft per component, and everything that is to be said about the parts."""
    drafts: list[Draft] = []
    problems: list[Problem] = []
    empty: dict[str, list[str]] = defaultdict(list)
    for part in parts:
        found, said = _drafts(part, scale, choices)
        drafts += found
        problems += said
        if not found and not said:
            empty[part.kind].append(part.source_id)
    return drafts, [*problems, *_left_out(empty)]


def _drafts(part: NeutralPart, scale: Scale, choices: Choices) -> tuple[list[Draft], list[Problem]]:
    attributes = attributes_of(part, choices.words)
    reading = reading_of(part.layer_path, choices.words.layers)
    named = Named(
        id=usable_id(attributes.get("id") or part.source_id),
        source_id=part.source_id,
        name=word(attributes.get("name") or part.name),
    )
    layer, problems = _layer(named, attributes, reading, choices)
    problems += [*attributes.problems, *_reader_problems(named, part, layer)]
    pieces = [
        piece
        for solid in part.solids
        for piece in pieces_of(
            solid, scale.metres, scale.shift_m, repairs_hull=choices.repairs_hull
        )
    ]
    problems += _shape_problems(named, pieces)
    if not pieces:
        return [], problems
    draft = Draft(
        named=named,
        part=part,
        attributes=attributes,
        layer=layer,
        reading=reading,
        pieces=tuple(pieces),
    )
    if choices.is_split and len(pieces) > 1 and not _is_one_piece(part):
        return _split(draft), problems
    return [draft], [*problems, *_several(draft)]


def _layer(
    named: Named, attributes: Attributes, reading: LayerReading, choices: Choices
) -> tuple[Layer, list[Problem]]:
    stated = attributes.get("layer")
    if not stated:
        return reading.role or Layer.TARGET, []
    role = choices.words.layers.role_of(stated)
    if role is not None:
        return role, []
    known = [layer.value for layer in Layer]
    hint = did_you_mean(folded(stated), known) or f" There are {', '.join(known)}."
    message = f"{stated[:60]!r} is no layer.{hint}"
    return Layer.TARGET, [_problem(named, "K1", message, "Correct the layer, or map it.")]


def _reader_problems(named: Named, part: NeutralPart, layer: Layer) -> Iterator[Problem]:
    for code, message, fix in part.problems:
        is_mild = code in WARNINGS or layer is Layer.AS_DESIGNED
        yield _problem(named, code, message, fix, "W" if is_mild else "E")


def _shape_problems(named: Named, pieces: Sequence[Piece]) -> Iterator[Problem]:
    told = {(n.code, n.message): n for piece in pieces for n in piece.notes}
    for note in told.values():
        yield _problem(named, note.code, note.message, note.fix, "E" if note.is_error else "W")


def _is_one_piece(part: NeutralPart) -> bool:
    return any(w in part.kind.casefold() for w in _ONE_PIECE)


def _several(draft: Draft) -> Iterator[Problem]:
    """Yield G4 for parts of several bodies, unless the file itself says that they are one."""
    count = len(draft.pieces)
    if count == 1 or _is_one_piece(draft.part):
        return
    if clusters_of(draft.pieces) > 1:
        message = f"It holds {count} separate solids."
        fix = f"--split makes {count} components; or make them a block."
        yield _problem(draft.named, "G4", message, fix)
        return
    message = f"It holds {count} solids that touch; they are taken as one."
    yield _problem(draft.named, "G4", message, f"--split makes {count} components.", "W")


def _split(draft: Draft) -> list[Draft]:
    return [
        replace(
            draft,
            named=Named(
                id=usable_id(f"{draft.named.id}.{number}"),
                source_id=f"{draft.named.source_id}.{number}",
                name=f"{draft.named.name[:_KEPT]} {number}".strip(),
            ),
            pieces=(piece,),
        )
        for number, piece in enumerate(draft.pieces, 1)
    ]


def _left_out(empty: dict[str, list[str]]) -> Iterator[Problem]:
    for kind, sources in sorted(empty.items()):
        shown = ", ".join(sources[:_SHOWN]) + (" ..." if len(sources) > _SHOWN else "")
        yield Problem(
            code="G7",
            severity="W",
            where=kind or "file",
            message=f"{len(sources)} of this kind hold no solid and are left out: {shown}.",
            fix="Nothing is to be done if they are only drawn.",
        )


def _problem(named: Named, code: str, message: str, fix: str, severity: str = "E") -> Problem:
    return Problem(
        code=code,
        severity=severity,
        where=named.id,
        message=message,
        fix=fix,
        source_id=named.source_id,
    )
