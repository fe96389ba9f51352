"""A cut list: which pieces are sawn from which board, longest first into the first that fits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sitewright.foundation.ids import ComponentId


@dataclass(frozen=True, slots=True, kw_only=True)
class Board:
    """A length of stock and what is cut from it.

    Attributes:
        cuts: Pieces with the distance of their start from the board's end.
    """

    length_m: float
    cuts: tuple[tuple[ComponentId, float], ...]
    used_m: float


def nested(
    length_by_piece: Mapping[ComponentId, float], stock_m: Sequence[float], kerf_m: float
) -> tuple[list[Board], list[ComponentId]]:
    """Return the boards, and the pieces that are longer than any (first-fit-decreasing).

    A new board is the longest one; when all is cut, each is replaced by the shortest that
    holds its cuts.
    """
    longest_m = max(stock_m)
    boards: list[Board] = []
    too_long: list[ComponentId] = []
    for piece in sorted(length_by_piece, key=lambda i: (-round(length_by_piece[i], 6), i)):
        length_m = length_by_piece[piece]
        if length_m > longest_m + 1e-9:
            too_long.append(piece)
            continue
        for k, board in enumerate(boards):
            start_m = board.used_m + kerf_m
            if start_m + length_m <= longest_m + 1e-9:
                boards[k] = _cut(board, piece, start_m, length_m)
                break
        else:
            boards.append(
                _cut(Board(length_m=longest_m, cuts=(), used_m=0.0), piece, 0.0, length_m)
            )
    return [_shortest(b, stock_m) for b in boards], too_long


def _cut(board: Board, piece: ComponentId, start_m: float, length_m: float) -> Board:
    return Board(
        length_m=board.length_m,
        cuts=(*board.cuts, (piece, start_m)),
        used_m=start_m + length_m,
    )


def _shortest(board: Board, stock_m: Sequence[float]) -> Board:
    length_m = min(s for s in stock_m if s + 1e-9 >= board.used_m)
    return Board(length_m=length_m, cuts=board.cuts, used_m=board.used_m)
