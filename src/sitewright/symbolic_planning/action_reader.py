"""Reader of one PDDL action, checked against the domain's vocabulary."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import pairwise

from sitewright.symbolic_planning.domain import (
    OBJECT,
    Action,
    Atom,
    Domain,
    Guarded,
    Literal,
    Parameter,
    Schema,
)
from sitewright.symbolic_planning.pddl_syntax import Group, PddlError, Symbol
from sitewright.symbolic_planning.typed_list import check_types, typed_list

_CONNECTIVES = frozenset(
    {"and", "not", "or", "imply", "forall", "exists", "when", "=", "increase", "decrease", "assign"}
)
_FIELDS = frozenset({":parameters", ":precondition", ":effect"})
_Scope = Mapping[str, str]
"""Type by variable name."""


class ActionReader:
    """Reads actions that use the predicates and functions of one domain."""

    def __init__(self, vocabulary: Domain) -> None:
        self._domain = vocabulary
        self._type_by_constant = {c.name: c.type for c in vocabulary.constants}

    def read(self, section: Group) -> Action:
        """Return the action; anything unsupported is a `PddlError` with its line."""
        name, fields = self._fields(section)
        parameters = self._variables(fields.get(":parameters", Group((), section.line)))
        scope = {p.name: p.type for p in parameters}
        literals: list[Literal] = []
        guarded: list[Guarded] = []
        for part in self._parts(fields.get(":precondition", Group((), section.line))):
            if part.head in ("forall", "imply"):
                guarded.append(self._guarded(part, scope))
            else:
                literals.append(self._literal(part, scope))
        adds, deletes, cost = self._effect(fields.get(":effect", Group((), section.line)), scope)
        return Action(
            name=name,
            parameters=parameters,
            preconditions=tuple(literals),
            guarded=tuple(guarded),
            adds=adds,
            deletes=deletes,
            cost=cost,
            line=section.line,
        )

    def _fields(self, section: Group) -> tuple[str, dict[str, Group]]:
        name = section.items[1] if len(section.items) > 1 else None
        if not isinstance(name, Symbol) or name.text.startswith(":"):
            raise self._error(section.line, "an action needs a name")
        fields: dict[str, Group] = {}
        rest = section.items[2:]
        if len(rest) % 2:
            raise self._error(section.line, f"action '{name.text}' has a field without a value")
        for key, value in list(pairwise(rest))[::2]:
            if not isinstance(key, Symbol) or key.text not in _FIELDS or key.text in fields:
                word = key.text if isinstance(key, Symbol) else key.head
                raise self._error(key.line, f"'{word}' is not supported in an action")
            if not isinstance(value, Group):
                raise self._error(value.line, f"'{key.text}' needs brackets")
            fields[key.text] = value
        return name.text, fields

    def _variables(self, group: Group) -> tuple[Parameter, ...]:
        parameters = tuple(typed_list(group.items, self._domain.file))
        check_types(parameters, self._domain.parent_by_type, self._domain.file, group.line)
        names = [p.name for p in parameters]
        for name in names:
            if not name.startswith("?"):
                raise self._error(group.line, f"'{name}' is no variable; write '?{name}'")
            if names.count(name) > 1:
                raise self._error(group.line, f"variable '{name}' stands twice")
        return parameters

    def _parts(self, group: Group) -> list[Group]:
        """Return the conjuncts of a formula; nested ``and`` is flattened."""
        if not group.items:
            return []
        if group.head != "and":
            return [group]
        parts: list[Group] = []
        for item in group.items[1:]:
            if not isinstance(item, Group):
                raise self._error(item.line, f"'{item.text}' needs brackets")
            parts.extend(self._parts(item))
        return parts

    def _literal(self, group: Group, scope: _Scope) -> Literal:
        if group.head != "not":
            return Literal(self._atom(group, scope), is_positive=True)
        inner = group.items[1] if len(group.items) == 2 else None  # noqa: PLR2004 (not ATOM)
        if not isinstance(inner, Group):
            raise self._error(group.line, "'not' takes one atom in brackets")
        return Literal(self._atom(inner, scope), is_positive=False)

    def _atom(self, group: Group, scope: _Scope) -> Atom:
        return self._applied(group, scope, self._domain.predicate_by_name, "predicate")

    def _applied(self, group: Group, scope: _Scope, known: Mapping[str, Schema], role: str) -> Atom:
        name = group.head
        if name in _CONNECTIVES or not name:
            raise self._error(group.line, f"'{name or '('}' is not supported")
        if name not in known:
            listed = ", ".join(known) or "none"
            raise self._error(group.line, f"{role} '{name}' is not declared; known: {listed}")
        terms = tuple(self._term(item, scope) for item in group.items[1:])
        wanted = known[name].types
        if len(terms) != len(wanted):
            raise self._error(
                group.line, f"'{name}' takes {len(wanted)} arguments, here it has {len(terms)}"
            )
        for (term, given), type_name in zip(terms, wanted, strict=True):
            if type_name != OBJECT and not self._domain.is_a(given, type_name):
                raise self._error(
                    group.line, f"'{name}' wants a {type_name}, but '{term}' is a {given}"
                )
        return Atom(name, tuple(t for t, _ in terms), group.line)

    def _term(self, item: Symbol | Group, scope: _Scope) -> tuple[str, str]:
        if isinstance(item, Group):
            raise self._error(item.line, f"'{item.head or '('}' is not supported as an argument")
        found = scope.get(item.text) or self._type_by_constant.get(item.text)
        if found is None:
            role = "variable" if item.text.startswith("?") else "constant"
            raise self._error(item.line, f"{role} '{item.text}' is not declared")
        return item.text, found

    def _guarded(self, group: Group, scope: _Scope) -> Guarded:
        parameters: tuple[Parameter, ...] = ()
        body = group
        if group.head == "forall":
            match group.items:
                case (_, Group() as variables, Group() as body):
                    parameters = self._variables(variables)
                case _:
                    raise self._error(group.line, "write 'forall' as (forall (?x - t) (...))")
        inner = {**scope, **{p.name: p.type for p in parameters}}
        guards: Iterable[Group] = ()
        if body.head == "imply":
            match body.items:
                case (_, Group() as left, Group() as right):
                    guards, body = self._parts(left), right
                case _:
                    raise self._error(body.line, "write 'imply' as (imply (...) (...))")
        return Guarded(
            parameters,
            tuple(self._atom(g, inner) for g in guards),
            tuple(self._literal(p, inner) for p in self._parts(body)),
            group.line,
        )

    def _effect(
        self, group: Group, scope: _Scope
    ) -> tuple[tuple[Atom, ...], tuple[Atom, ...], Atom | int]:
        adds: list[Atom] = []
        deletes: list[Atom] = []
        cost: Atom | int = 0
        for part in self._parts(group):
            if part.head == "increase":
                cost = self._cost(part, scope)
                continue
            literal = self._literal(part, scope)
            (adds if literal.is_positive else deletes).append(literal.atom)
        return tuple(adds), tuple(deletes), cost

    def _cost(self, group: Group, scope: _Scope) -> Atom | int:
        match group.items:
            case (_, Group((Symbol("total-cost"),)), Group() as term):
                return self._applied(term, scope, self._domain.function_by_name, "function")
            case (_, Group((Symbol("total-cost"),)), Symbol(text)) if text.isdigit():
                return int(text)
        raise self._error(
            group.line, "write 'increase' as (increase (total-cost) (function ...)) or a number"
        )

    def _error(self, line: int, message: str) -> PddlError:
        return PddlError(self._domain.file, line, message)
