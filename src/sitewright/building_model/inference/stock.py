"""Stock for a model that states none: one piece per target, piled in reverse order of use."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from sitewright.building_model.component import BoxGeometry, Component, Layer, Origin
from sitewright.building_model.inference.facing import Site, Surroundings, side_of, turn_of
from sitewright.building_model.inference.order import Arrival
from sitewright.building_model.inference.statics import Statics
from sitewright.building_model.matching import MaterialType, material_type_of
from sitewright.building_model.model import Stack
from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.ids import ComponentId, StackId, StockPlaceId
from sitewright.foundation.pose import Pose, Vector, dot, subtract, translation

_BEARS = 0.6
_MAX_ID, _MAX_NAME, _DIGEST = 64, 256, 8
"""A piece may lie on one of at least this share of its own length."""
_IN_THE_MIDDLE_M = 1e-6
"""What is this near to the middle is in it, however its numbers were rounded."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StockLayout:
    """How the stock places of a cell for imported frames are laid out.

    Pieces lie along the stock place's x axis; piles stand side by side along its y axis.

    Attributes:
        places: Stock places of each long side: the one to -x of the middle first, then +x.
        pitch_m: Distance between the middles of two piles: room for the open gripper.
    """

    places: Mapping[str, tuple[StockPlaceId, ...]] = field(
        default_factory=lambda: {
            side: (StockPlaceId(f"stock-{side}-1"), StockPlaceId(f"stock-{side}-2"))
            for side in "ab"
        }
    )
    piles_per_place: int = 5
    pitch_m: float = 0.26


@dataclass(slots=True)
class _Pile:
    """A pile while it grows."""

    place: StockPlaceId
    number: int
    stock_T_stack: Pose
    is_first_place: bool
    height_m: float = 0.0
    top_length_m: float = float("inf")
    first_use: int = 1_000_000
    top_type: MaterialType | None = None
    pieces: list[Component] = field(default_factory=list)


def stock_for(
    components: Mapping[ComponentId, Component],
    statics: Statics,
    coming: Sequence[Arrival],
    around: Surroundings,
    layout: StockLayout,
) -> tuple[list[Component], list[Stack]]:
    """Return one piece for every arriving target, and the stacks that they lie in.

    A piece has the target's geometry with its cuts: nothing is cut in the cell. It lies on the
    side that the target comes from, with the face up that the gripper is to meet; what is used
    first lies on top.
    """
    piles = {side: _piles(layout, side) for side in "ab"}
    uses = _uses(components, coming)
    site = Site(statics, coming)
    for number in range(len(coming) - 1, -1, -1):
        arrival = coming[number]
        target = components[arrival.id]
        side = side_of(target, arrival, site, around)
        turn = turn_of(target, site, around.shoulder_m[side])
        off_middle_m = dot(
            subtract(target.world_T_component.position_m, around.middle_m), around.along
        )
        wants_first = off_middle_m <= _IN_THE_MIDDLE_M
        _lay(piles[side], target, turn, uses, wants_first=wants_first)
    used = [pile for side in "ab" for pile in piles[side] if pile.pieces]
    return [piece for pile in used for piece in pile.pieces], [_stack(pile) for pile in used]


def piece_id(target: ComponentId) -> ComponentId:
    """Return the id of the piece that is meant for a target."""
    name = f"piece.{target}"
    if len(name) <= _MAX_ID:
        return ComponentId(name)
    digest = sha256_hex(target)[:_DIGEST]  # cut ids alone might be alike
    return ComponentId(f"{name[: _MAX_ID - _DIGEST - 1]}-{digest}")


def piece_name(target: Component) -> str:
    """Return the name of the piece that is made for a target, as long as a file may hold."""
    return f"piece for {target.name or target.id}"[:_MAX_NAME]


def _piles(layout: StockLayout, side: str) -> list[_Pile]:
    middle = (layout.piles_per_place - 1) / 2.0
    return [
        _Pile(
            place=place,
            number=k + 1,
            stock_T_stack=translation(0.0, (k - middle) * layout.pitch_m, 0.0),
            is_first_place=place == layout.places[side][0],
        )
        for place in layout.places[side]
        for k in range(layout.piles_per_place)
    ]


def _uses(
    components: Mapping[ComponentId, Component], coming: Sequence[Arrival]
) -> dict[MaterialType, tuple[int, int]]:
    """Return when pieces of each kind are used: first and last."""
    uses: dict[MaterialType, tuple[int, int]] = {}
    for arrival in coming:
        kind = material_type_of(components[arrival.id])
        first, last = uses.get(kind, (arrival.number, arrival.number))
        uses[kind] = (min(first, arrival.number), max(last, arrival.number))
    return uses


def _lay(
    piles: Iterable[_Pile],
    target: Component,
    turn: Pose,
    uses: Mapping[MaterialType, tuple[int, int]],
    *,
    wants_first: bool,
) -> None:
    """Put a piece on the pile where it is long enough borne and blocks nothing.

    Equal pieces serve each other's targets, so that a piece may stay until the last target of its
    kind: what lies under it must not be wanted before.
    """
    kind = material_type_of(target)
    assert isinstance(target.geometry, BoxGeometry)  # noqa: S101 - solids are boxes
    size_m: Vector = target.geometry.size_m
    thickness_m = size_m[2] if abs(turn.z_axis[2]) > abs(turn.y_axis[2]) else size_m[1]
    pile = min(
        piles,
        key=lambda p: (
            p.top_length_m < _BEARS * size_m[0],
            p.top_type != kind and uses[kind][1] > p.first_use,
            round(p.height_m, 4),
            p.is_first_place != wants_first,
        ),
    )
    centre = translation(0.0, 0.0, pile.height_m + thickness_m / 2.0)
    pile.pieces.append(
        replace(
            target,
            id=piece_id(target.id),
            name=piece_name(target),
            layer=Layer.MATERIAL,
            world_T_component=pile.stock_T_stack @ centre @ turn,
            order=None,
            construction_parents=(),
            ground=False,
            operations=(),
            hold_until_fasteners=0,
            source=None,
            raw={},
            ext={},
            origins={"layer": (Origin.INFERRED, f"one piece for target {target.id}")},
        )
    )
    pile.height_m += thickness_m
    pile.top_length_m = size_m[0]
    pile.first_use = min(pile.first_use, uses[kind][0])
    pile.top_type = kind


def _stack(pile: _Pile) -> Stack:
    return Stack(
        id=StackId(f"{pile.place}.{pile.number}"),
        place=pile.place,
        items=tuple(p.id for p in pile.pieces),
        stock_T_stack=pile.stock_T_stack,
    )
