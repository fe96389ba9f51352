"""Sentences by language: one template per skill, with named places for what it acts on.

A further language is one more `Phrasebook`. Templates hold whole sentences with named arguments,
so that another language can put them in its own order.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sitewright.interaction_twin.told_english import TOLD_ENGLISH


@dataclass(frozen=True, slots=True, kw_only=True)
class Phrasebook:
    """Everything that is said in one language.

    Attributes:
        skill: Template by skill, or by ``skill:kind`` of what its first argument is.
        fact: Template by predicate; used in reasons.
        because: Joins what is needed by whom; ``{need}`` and ``{robot}``.
        run: Template of a folded run, by process; ``{count}`` and ``{target}``.
        of: An operation with its component, ``{operation}`` and ``{component}``.
        piece: Word that a piece's own name may begin with, and templates say before it.
        step: Sentences that say why a step is as it is.
        noun: What an operation is called, by process; a number follows.
        page: Sentences around a plan: its title, why a step is there, what to look at.
        told: What planners, controller and drivers say, by their English templates.
    """

    language: str
    skill: Mapping[str, str]
    fact: Mapping[str, str]
    because: str
    run: Mapping[str, tuple[str, str]]
    of: str
    piece: str
    step: Mapping[str, str]
    noun: Mapping[str, str]
    page: Mapping[str, str]
    told: Mapping[str, str]


STEP_ENGLISH: Mapping[str, str] = {
    "title": "Step {number} of {count} of the plan for {target}: {status}",
    "plan": "Check code {code}, run {run}",
    "why": "Why it is there",
    "serves": "{fact}: needed by step {number}, {words}",
    "serves-many": "{fact}: needed by steps {numbers}, first {words}",
    "asked": "{fact}: what the design asks for",
    "lasts": "{fact}: so it stays to the end of the plan",
    "leads": "it leads to step {number}, {words} (by way of {way})",
    "no-use": "no later step needs it",
    "possible": "What makes it possible",
    "made": "{fact}: brought about by step {number}, {words}",
    "given": "{fact}: so it was before the plan",
    "not": "not {fact}",
    "robot": "Why {robot}",
    "able": "it does {by}",
    "only-moves": "it is the one that has to move",
    "for-act": "the move is for what {words}",
    "other": "not {robot}: {obstacle}",
    "either": "{robot} might do it too; of the plans looked at this one takes the least time",
    "piece": "Why {piece}",
    "nearest": "nearest to a robot that may grasp of the {count} that could be taken: {distance}",
    "only": "the only one that could be taken: {distance} from a robot that may grasp",
    "not-nearest": "{distance} from a robot that may grasp; nearer ones were refused or not wanted",
    "held": "it is in hand, or in place, already",
    "aside": "it is no piece for {target}: it is moved out of the way",
    "farther": "further away: {pieces}",
    "buried": "under others: {pieces}",
    "how": "How",
    "closest": "{distance} is the closest that {pair} come; at least {clearance} are kept",
    "proof": "proven for {pairs} pairs by {engine}; {second} saw no contact at {samples} points",
    "still": "no joint moves: the end effector acts",
    "joined": "no motion of its own: it is one with the robot's next one",
    "lean": "the tool leans {angle}",
    "upright": "the tool stands upright on it",
    "grip": "the gripper holds the piece {distance} from its middle, {angle} from straight down",
    "pose": "the piece stands at {position}",
    "takes": "{duration}",
    "touch": "may touch: {pairs}",
    "refused": "What was refused here",
    "refused-other": "What was refused for other steps of this plan",
    "nothing": "nothing was refused on the way to this plan",
    "status-open": "open",
    "status-done": "done",
    "status-not done": "not done",
    "status-superseded": "superseded",
}

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
        "at": "{0} at {1}",
        "in-transit": "{0} free to go",
        "mobile": "{0} free to leave",
        "pending": "{0} still open",
    },
    because="because {robot} needs {need}",
    run={
        "nail": ("drives 1 nail into {target}", "drives {count} nails into {target}"),
        "screw": ("drives 1 screw into {target}", "drives {count} screws into {target}"),
        "paint": ("paints 1 face of {target}", "paints {count} faces of {target}"),
    },
    of="{operation} of {component}",
    piece="piece ",
    step=STEP_ENGLISH,
    noun={"nail": "nail", "screw": "screw", "paint": "face", "drill": "hole"},
    told=TOLD_ENGLISH,
    page={
        "plan": "Plan for {target}",
        "single": "One chosen step for {target}",
        "asked-for": "because the design asks for {need}",
        "then": "because of step {number}: {words}",
        "ends": "because the plan ends with {need}",
        "near": "It comes within {near}, nearer than {limit}: look at it.",
        "about": "It is about {target}, not about {other}.",
        "instead": "One step instead of the rest of {code}; then a new plan is made.",
        "same": "The steps are the same; their motions differ.",
        "schedule": "Schedule by robot: planned (outline) and actual (solid)",
        "planned": "planned",
        "actual": "actual",
        "moves": "of these, moves",
        "failed": "failed",
        "graph": "Construction relationship graph",
        "jobsite": "Jobsite",
        "layer-target": "to be built",
        "layer-material": "stock",
        "layer-as_built": "built",
        "layer-as_designed": "drawn only",
        "layer-virtual_collision": "keep clear",
    },
)
