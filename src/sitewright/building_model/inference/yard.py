"""Stock for targets that have none: cut lists, and piles in reverse order of use."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase

from sitewright.building_model.component import Component, Layer, Origin
from sitewright.building_model.findings import warned
from sitewright.building_model.inference.nesting import nested
from sitewright.building_model.inference.rules import Rules, StockRule
from sitewright.building_model.inference.stock import piece_id, piece_name
from sitewright.building_model.matching import fits, material_type_of
from sitewright.building_model.model import BuildingModel, Stack
from sitewright.building_model.piling import lying_section_m, piled, turn_as_placed
from sitewright.building_model.shapes import UnsupportedGeometryError, size_of
from sitewright.errors import Problem
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, StackId, StockPlaceId
from sitewright.foundation.pose import Vector, translation

CUT_FROM = "cut_from"
"""Key of a piece's `ext`: the board that it is cut from."""
HEIGHT_MAX_M = 1.0
SPACE_M = 0.15
"""Between two piles at one place: room for the open gripper."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Yard:
    """New pieces, the piles that they lie in, and what is open."""

    pieces: tuple[Component, ...]
    stacks: tuple[Stack, ...]
    problems: tuple[Problem, ...]


def yard_for(
    model: BuildingModel,
    targets: Sequence[Component],
    places: Sequence[StockPlaceId],
    rules: Rules,
    up: Vector = (0.0, 0.0, 1.0),
) -> Yard:
    """Return one piece for every target without stock, piled so that the next lies on top.

    Args:
        model: Its own stock serves first.
        targets: In order of use.
        places: Stock places of the cell; those that hold a stack already are left alone.
        rules: Stock lengths; a kind without a rule is taken to come in its final lengths.
        up: Unit vector against gravity: pieces lie with the face up that is up at the target.
    """
    lacking = _without_stock(model, targets)
    free = [p for p in places if p not in {s.place for s in model.stacks}]
    if not lacking or not places:
        return Yard(pieces=(), stacks=(), problems=())
    if not free:
        message = f"No stock place is free for the {len(lacking)} targets without stock."
        fix = "Add a [[stock_place]] to cell.toml, or add stock."
        return Yard(pieces=(), stacks=(), problems=(warned("M1", lacking[0], message, fix),))
    boards, problems = _boards(lacking, rules)
    pieces = [_piece(t, boards.get(t.id)) for t in lacking]
    found = list(_piles(pieces, free, up))
    return Yard(
        pieces=tuple(p for _, laid in found for p in laid),
        stacks=tuple(stack for stack, _ in found),
        problems=tuple(problems),
    )


def _without_stock(model: BuildingModel, targets: Sequence[Component]) -> list[Component]:
    """Return the targets that no piece of the model is left for."""
    stock = [
        material_type_of(c) for c in model.component_by_id.values() if c.layer is Layer.MATERIAL
    ]
    lacking = []
    for target in targets:
        try:
            wanted = material_type_of(target)
        except UnsupportedGeometryError:
            continue
        k = next((k for k, piece in enumerate(stock) if fits(piece, wanted)), None)
        if k is None:
            lacking.append(target)
        else:
            del stock[k]
    return lacking


def _boards(
    targets: Iterable[Component], rules: Rules
) -> tuple[dict[ComponentId, dict[str, Json]], list[Problem]]:
    """Return the board that each target's piece is cut from, group by group."""
    groups: dict[tuple[object, ...], list[Component]] = defaultdict(list)
    for target in targets:
        kind, section, _, material = material_type_of(target)
        groups[kind, section, material].append(target)
    found: dict[ComponentId, dict[str, Json]] = {}
    problems: list[Problem] = []
    for number, (key, group) in enumerate(sorted(groups.items(), key=lambda g: str(g[0])), 1):
        rule = _rule_for(str(key[0]), rules)
        if rule is None:
            continue
        lengths = {t.id: size_of(t)[0] for t in group}
        boards, too_long = nested(lengths, rule.lengths_m, rule.kerf_m)
        for k, board in enumerate(boards, 1):
            for piece, start_m in board.cuts:
                found[piece] = {
                    "board": f"{number}.{k}",
                    "length_m": board.length_m,
                    "start_m": round(start_m, 4),
                    "rule": rule.id,
                }
        problems += [_longer(t, rule) for t in group if t.id in too_long]
    return found, problems


def _rule_for(kind: str, rules: Rules) -> StockRule | None:
    return next((r for r in rules.stock if fnmatchcase(kind, r.type)), None)


def _longer(target: Component, rule: StockRule) -> Problem:
    message = (
        f"It is {size_of(target)[0]:.3f} m long; the longest stock of rule {rule.id!r} "
        f"is {max(rule.lengths_m):g} m."
    )
    return warned("M2", target, message, "Add a longer length to the rule, or split it.")


def _piece(target: Component, board: Mapping[str, Json] | None) -> Component:
    why = f"one piece for target {target.id}"
    if board is not None:
        why += f", cut from board {board['board']} ({board['length_m']} m)"
    return replace(
        target,
        id=piece_id(target.id),
        name=piece_name(target),
        layer=Layer.MATERIAL,
        order=None,
        construction_parents=(),
        ground=False,
        temporary_support=False,
        operations=(),
        grasps=(),
        hold_until_fasteners=0,
        source=None,
        raw={},
        ext={CUT_FROM: dict(board)} if board is not None else {},
        origins={"layer": (Origin.INFERRED, why)},
    )


def _piles(
    pieces: Sequence[Component], places: Sequence[StockPlaceId], up: Vector
) -> Iterable[tuple[Stack, list[Component]]]:
    """Yield piles: pieces of one section together, the last used at the bottom.

    Piles go to the places in turn; further ones at a place stand beside the first along y.
    """
    rows: dict[tuple[float, float], list[Component]] = defaultdict(list)
    turns = {piece.id: turn_as_placed(piece, up) for piece in pieces}
    for piece in reversed(pieces):
        rows[lying_section_m(piece, turns[piece.id])].append(piece)
    beside_m: dict[StockPlaceId, float] = dict.fromkeys(places, 0.0)
    counts: dict[StockPlaceId, int] = dict.fromkeys(places, 0)
    for (width_m, height_m), row in sorted(rows.items()):
        most = max(1, int(HEIGHT_MAX_M / height_m))
        # the pieces used last are the lowest of the last pile; each pile is whole by itself
        for start in range(0, len(row), most):
            place = min(places, key=lambda p: (counts[p], places.index(p)))
            counts[place] += 1
            shift_m = 0.0
            if counts[place] > 1:
                shift_m = beside_m[place] + SPACE_M + width_m / 2.0
            beside_m[place] = shift_m + width_m / 2.0
            items = row[start : start + most]
            stack = Stack(
                id=StackId(f"{place}.{counts[place]}"),
                place=place,
                items=tuple(p.id for p in items),
                stock_T_stack=translation(0.0, shift_m, 0.0),
            )
            yield stack, piled(stack, items, [turns[p.id] for p in items])
