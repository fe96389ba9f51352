"""A planning domain as a value: types, predicates and actions of the PDDL subset we accept."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

Fact = tuple[str, ...]
"""A ground atom: predicate or function, then object names."""

OBJECT = "object"
ROBOT = "robot"


@dataclass(frozen=True, slots=True)
class Parameter:
    """A variable (``?r``) or a constant, with its type and the line that it stands on."""

    name: str
    type: str
    line: int


@dataclass(frozen=True, slots=True)
class Schema:
    """A declared predicate or function."""

    name: str
    parameters: tuple[Parameter, ...]
    line: int

    @property
    def types(self) -> tuple[str, ...]:
        """Types of the arguments in order."""
        return tuple(p.type for p in self.parameters)


@dataclass(frozen=True, slots=True)
class Atom:
    """A predicate or function applied to variables and constants."""

    name: str
    terms: tuple[str, ...]
    line: int

    def ground(self, binding: Mapping[str, str]) -> Fact:
        """Return the fact under a binding; constants stand for themselves."""
        return (self.name, *[binding.get(t, t) for t in self.terms])


@dataclass(frozen=True, slots=True)
class Literal:
    """An atom or its negation."""

    atom: Atom
    is_positive: bool


@dataclass(frozen=True, slots=True)
class Guarded:
    """For all `parameters`: where every static guard holds, so do the consequents."""

    parameters: tuple[Parameter, ...]
    guards: tuple[Atom, ...]
    consequents: tuple[Literal, ...]
    line: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Action:
    """An action of the domain; its name is that of a skill.

    Attributes:
        parameters: The robot first.
        cost: Increase of the total cost: a function of the arguments, or a number.
    """

    name: str
    parameters: tuple[Parameter, ...]
    preconditions: tuple[Literal, ...]
    guarded: tuple[Guarded, ...]
    adds: tuple[Atom, ...]
    deletes: tuple[Atom, ...]
    cost: Atom | int
    line: int

    def atoms(self) -> Iterator[Atom]:
        """Every atom that the action mentions, its cost left out."""
        yield from (x.atom for x in self.preconditions)
        for part in self.guarded:
            yield from part.guards
            yield from (x.atom for x in part.consequents)
        yield from self.adds
        yield from self.deletes


@dataclass(frozen=True, slots=True, kw_only=True)
class Domain:
    """A domain file that has been read and found sound.

    Attributes:
        parent_by_type: The type above each declared type.
        text: The file as it was read; this is what a planner gets.
    """

    name: str
    file: str
    text: str
    parent_by_type: Mapping[str, str]
    constants: tuple[Parameter, ...] = ()
    predicate_by_name: Mapping[str, Schema] = field(default_factory=dict)
    function_by_name: Mapping[str, Schema] = field(default_factory=dict)
    actions: tuple[Action, ...] = ()

    def supertypes(self, type_name: str) -> tuple[str, ...]:
        """Return a type and all above it, nearest first."""
        chain = [type_name]
        while chain[-1] in self.parent_by_type:
            chain.append(self.parent_by_type[chain[-1]])
        return tuple(chain)

    def is_a(self, type_name: str, wanted: str) -> bool:
        """Whether a type is `wanted` or below it."""
        return wanted in self.supertypes(type_name)

    def fluents(self) -> frozenset[str]:
        """Names of the predicates that some action changes; the others are static."""
        return frozenset(a.name for x in self.actions for a in (*x.adds, *x.deletes))
