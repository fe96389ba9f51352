"""Sentences by language: one template per skill, with named places for what it acts on.

A further language is one more `Phrasebook`. Templates hold whole sentences with named arguments,
so that another language can put them in its own order.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Phrasebook:
    """Everything that is said in one language.

    Attributes:
        skill: Template by skill, or by ``skill:kind`` of what its first argument is.
        fact: Template by predicate; used in reasons.
        because: Joins what is needed by whom; ``{need}`` and ``{robot}``.
        run: Template of a folded run, by process; ``{count}`` and ``{target}``.
        of: An operation with its component, ``{operation}`` and ``{component}``.
    """

    language: str
    skill: Mapping[str, str]
    fact: Mapping[str, str]
    because: str
    run: Mapping[str, tuple[str, str]]
    of: str


ENGLISH = Phrasebook(
    language="en",
    skill={
        "reach": "goes to {place}",
        "reach:stock-place": "goes to the stock place {place}",
        "reach:component": "goes to where {place} belongs",
        "reach:operation": "brings its tool to {place}",
        "reach:station": "goes to the station {place}",
        "reach:preparation": "goes to its waiting place",
        "retract": "backs away from {place}",
        "retract:stock-place": "backs away from the stock place {place}",
        "retract:component": "backs away from {place}",
        "retract:station": "leaves the station {place}",
        "retract:preparation": "leaves its waiting place",
        "grasp": "takes piece {piece} from {place} with {gripper}",
        "position": "puts piece {piece} in place as {target} and keeps holding it",
        "set-down": "sets piece {piece} down at {place}",
        "release": "lets go of {target}",
        "fasten": "drives {spot} with {tool}",
        "apply-finish": "paints {spot} with {tool}",
        "change-end-effector": "puts away {old} and takes up {new} at {station}",
        "change-end-effector:bare-flange": "takes up {new} at {station}",
    },
    fact={
        "positioned": "{0} in place",
        "in-place": "{0} in place as {1}",
        "standing": "{0} standing by itself",
        "fastened": "{0} driven",
        "finished": "{0} painted",
        "vacant": "the way clear",
        "mounted": "{1} on its flange",
        "docked": "{0} at {1}",
        "holding": "{1} in its gripper",
        "hand-empty": "an empty hand",
        "lies-at": "{0} at {1}",
        "accessible": "{0} uncovered",
        "steadying": "{1} held by {0}",
    },
    because="because {robot} needs {need}",
    run={
        "nail": ("drives 1 nail into {target}", "drives {count} nails into {target}"),
        "screw": ("drives 1 screw into {target}", "drives {count} screws into {target}"),
        "paint": ("paints 1 face of {target}", "paints {count} faces of {target}"),
    },
    of="{operation} of {component}",
)

PHRASEBOOKS: Mapping[str, Phrasebook] = {book.language: book for book in (ENGLISH,)}
