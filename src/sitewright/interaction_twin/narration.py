"""Skill calls in plain words: what a robot does, to what, and why."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sitewright.central_controller.proposal import ProposedStep
from sitewright.interaction_twin.labels import Kind, Labels
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.robot_team.skill import Skill, SkillCall

ARGUMENT_NAMES: Mapping[str, tuple[str, ...]] = {
    Skill.REACH: ("place",),
    Skill.RETRACT: ("place",),
    Skill.GRASP: ("piece", "place", "gripper"),
    Skill.POSITION: ("piece", "target"),
    Skill.SET_DOWN: ("piece", "place"),
    Skill.RELEASE: ("target",),
    Skill.FASTEN: ("spot", "target", "tool"),
    Skill.APPLY_FINISH: ("spot", "target", "tool"),
    Skill.CHANGE_END_EFFECTOR: ("old", "new", "station"),
}
"""Names of the arguments of the built-in skills, in the order of their PDDL actions."""

_ACTS = {Skill.FASTEN, Skill.APPLY_FINISH}
_MOVES = {Skill.REACH, Skill.RETRACT}
_NOT = "(not "


def narrate(call: SkillCall, labels: Labels, book: Phrasebook = ENGLISH) -> str:
    """Return a call as a sentence without its full stop; a skill without template is spelled."""
    return f"{labels.name(call.robot)} {act_of(call, labels, book)}"


def act_of(call: SkillCall, labels: Labels, book: Phrasebook = ENGLISH) -> str:
    """Return what the robot does, without its name."""
    names = ARGUMENT_NAMES.get(call.skill, ())
    template = _template(call, labels, book)
    if template is not None and call.skill not in ARGUMENT_NAMES:
        return _own_skill(template, call, labels, book)
    if template is None or len(names) != len(call.arguments):
        return spelled(call)
    words = {n: words_of(a, labels, book) for n, a in zip(names, call.arguments, strict=True)}
    return template.format(**words)


def _own_skill(template: str, call: SkillCall, labels: Labels, book: Phrasebook) -> str:
    """Return the sentence of a skill that is not built in; its places are numbers."""
    try:
        return template.format(*(words_of(a, labels, book) for a in call.arguments))
    except (IndexError, KeyError, ValueError):
        return spelled(call)


def spelled(call: SkillCall) -> str:
    """Return a call as it is written in a plan: ``grasp(r1, mat-066)``."""
    return f"{call.skill}({', '.join((call.robot, *call.arguments))})"


def _template(call: SkillCall, labels: Labels, book: Phrasebook) -> str | None:
    if call.arguments:
        kind = labels.label(call.arguments[0]).kind
        special = book.skill.get(f"{call.skill}:{kind}")
        if special is not None:
            return special
    return book.skill.get(call.skill)


def words_of(site_id: str, labels: Labels, book: Phrasebook) -> str:
    """Return what an id stands for; an operation with its component."""
    label = labels.label(site_id)
    match label.kind:
        case Kind.OPERATION:
            number = label.name.rpartition(" ")[2]
            noun = book.noun.get(label.process)
            name = label.name if noun is None else f"{noun} {number}"
            return book.of.format(operation=name, component=labels.name(label.of))
        case Kind.PIECE:
            return label.name.removeprefix(book.piece)
        case _:
            return label.name


def reason(
    steps: Sequence[ProposedStep], index: int, labels: Labels, book: Phrasebook = ENGLISH
) -> str:
    """Return why a step is there: what a later step of another robot needs of it.

    Args:
        steps: All steps of the proposal.
        index: Position of the step in `steps`.
        labels: Names that people see.
        book: The language.

    Returns:
        A clause such as ``because kr120-b needs stud 1 in place``, or nothing if no other robot
        waits for it.
    """
    step = steps[index]
    made = {e for e in step.effects if not e.startswith("(not ")}
    for later in steps[index + 1 :]:
        made_here = sorted(made & set(later.relies_on))
        if later.call.robot != step.call.robot:
            need = next((n for f in made_here if (n := _need(f, labels, book))), "")
            if need:
                return book.because.format(robot=labels.name(later.call.robot), need=need)
        made -= {e.removeprefix("(not ").removesuffix(")") for e in later.effects}
    return ""


def fact_in_words(fact: str, labels: Labels, book: Phrasebook = ENGLISH) -> str:
    """Return a fact in plain words; one without template is spelled."""
    if fact.startswith(_NOT):
        return book.step["not"].format(fact=fact_in_words(fact[len(_NOT) : -1], labels, book))
    return _need(fact, labels, book) or fact.strip("()")


def _need(fact: str, labels: Labels, book: Phrasebook) -> str:
    predicate, *arguments = fact.strip("()").split()
    template = book.fact.get(predicate)
    return template.format(*map(labels.name, arguments)) if template else ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Run:
    """Steps that belong together, as one sentence.

    Attributes:
        first: Number of the first step; the numbers of the steps stay as they are.
        last: Number of the last step.
    """

    first: int
    last: int
    robot: str
    words: str


def folded(
    calls: Sequence[tuple[int, SkillCall]], labels: Labels, book: Phrasebook = ENGLISH
) -> tuple[Run, ...]:
    """Return numbered calls with runs of the same act folded: ``drives 4 nails``.

    A run is what one robot does in a row, moves between its acts included, with one process on
    one target. Moves that belong to no run are left out; they are in the full list.
    """
    runs: list[Run] = []
    for group in _groups(calls, labels):
        acts = [(n, c) for n, c in group if c.skill not in _MOVES]
        if not acts:
            continue
        number, call = acts[0]
        words = act_of(call, labels, book)
        if call.skill in _ACTS:
            label = labels.label(call.arguments[0])
            one, many = book.run.get(label.process, (words, words))
            template = one if len(acts) == 1 else many
            words = template.format(count=len(acts), target=labels.name(call.arguments[1]))
        first = group[0][0] if call.skill in _ACTS else number
        last = group[-1][0] if call.skill in _ACTS else number
        runs.append(Run(first=first, last=last, robot=labels.name(call.robot), words=words))
    return tuple(runs)


def _groups(
    calls: Sequence[tuple[int, SkillCall]], labels: Labels
) -> list[list[tuple[int, SkillCall]]]:
    """Split at each act that is not the same as the one before; moves go with what follows."""
    groups: list[list[tuple[int, SkillCall]]] = []
    moves: list[tuple[int, SkillCall]] = []
    same: tuple[str, ...] = ()
    for number, call in calls:
        if call.skill in _MOVES:
            moves.append((number, call))
            continue
        key = _sameness(number, call, labels)
        if groups and key == same and all(m.robot == call.robot for _, m in moves):
            groups[-1] += [*moves, (number, call)]
        else:
            groups.append([*moves, (number, call)])
        moves, same = [], key
    return groups


def _sameness(number: int, call: SkillCall, labels: Labels) -> tuple[str, ...]:
    if call.skill in _ACTS:
        return call.robot, call.skill, labels.label(call.arguments[0]).process, call.arguments[1]
    return (str(number),)
