"""Reader of PDDL domain files: the subset that Sitewright plans with, nothing guessed."""

from __future__ import annotations

from collections.abc import Iterable

from sitewright.symbolic_planning.action_reader import ActionReader
from sitewright.symbolic_planning.domain import OBJECT, Domain, Parameter, Schema
from sitewright.symbolic_planning.pddl_syntax import Group, PddlError, Symbol, read_group
from sitewright.symbolic_planning.typed_list import check_types, typed_list

_REQUIREMENTS = frozenset(
    {
        ":strips",
        ":typing",
        ":adl",
        ":action-costs",
        ":negative-preconditions",
        ":universal-preconditions",
    }
)
_SECTIONS = frozenset(
    {":requirements", ":types", ":constants", ":predicates", ":functions", ":action"}
)


def read_domain(text: str, *, file: str = "domain.pddl") -> Domain:
    """Return the domain in a PDDL text.

    Args:
        text: The file's content.
        file: Its name, for messages.

    Raises:
        PddlError: The text is not PDDL, or uses what is not supported; the line is named.
    """
    root = read_group(text, file)
    return _DomainReader(file).read(root, text)


class _DomainReader:
    def __init__(self, file: str) -> None:
        self._file = file

    def read(self, root: Group, text: str) -> Domain:
        sections = self._sections(root)
        for section in sections:
            if section.head == ":requirements":
                self._check_requirements(section)
        parents = self._types(_named(sections, ":types"))
        vocabulary = Domain(
            name=self._name(root),
            file=self._file,
            text=text,
            parent_by_type=parents,
            constants=self._constants(_named(sections, ":constants"), parents),
            predicate_by_name=self._schemas(_named(sections, ":predicates"), parents),
            function_by_name=self._schemas(_named(sections, ":functions"), parents),
        )
        reader = ActionReader(vocabulary)
        actions = tuple(reader.read(s) for s in sections if s.head == ":action")
        names = [a.name for a in actions]
        for action in actions:
            if names.count(action.name) > 1:
                raise PddlError(self._file, action.line, f"action '{action.name}' stands twice")
        domain = Domain(
            name=vocabulary.name,
            file=vocabulary.file,
            text=text,
            parent_by_type=parents,
            constants=vocabulary.constants,
            predicate_by_name=vocabulary.predicate_by_name,
            function_by_name=vocabulary.function_by_name,
            actions=actions,
        )
        self._check_guards(domain)
        return domain

    def _name(self, root: Group) -> str:
        match root.items:
            case (Symbol("define"), Group((Symbol("domain"), Symbol(name)), _), *_):
                return name
            case _:
                pass
        raise PddlError(self._file, root.line, "expected '(define (domain NAME) ...)'")

    def _sections(self, root: Group) -> list[Group]:
        self._name(root)
        sections = []
        for item in root.items[2:]:
            if not isinstance(item, Group) or item.head not in _SECTIONS:
                word = item.head if isinstance(item, Group) else item.text
                raise PddlError(self._file, item.line, f"'{word}' is not supported")
            sections.append(item)
        return sections

    def _check_requirements(self, section: Group) -> None:
        for item in section.items[1:]:
            if not isinstance(item, Symbol) or item.text not in _REQUIREMENTS:
                word = item.text if isinstance(item, Symbol) else "("
                known = ", ".join(sorted(_REQUIREMENTS))
                raise PddlError(
                    self._file, item.line, f"requirement '{word}' is not supported; known: {known}"
                )

    def _types(self, sections: Iterable[Group]) -> dict[str, str]:
        parents: dict[str, str] = {}
        for section in sections:
            for parameter in typed_list(section.items[1:], self._file):
                if parameter.name == OBJECT or parameter.name in parents:
                    raise PddlError(
                        self._file, section.line, f"type '{parameter.name}' stands twice"
                    )
                parents[parameter.name] = parameter.type
            self._check_tree(parents, section.line)
        return parents

    def _check_tree(self, parents: dict[str, str], line: int) -> None:
        for name in parents:
            seen = [name]
            while seen[-1] != OBJECT:
                above = parents.get(seen[-1])
                if above is None:
                    raise PddlError(self._file, line, f"type '{seen[-1]}' is not declared")
                if above in seen:
                    raise PddlError(self._file, line, f"type '{name}' lies above itself")
                seen.append(above)

    def _constants(
        self, sections: Iterable[Group], parents: dict[str, str]
    ) -> tuple[Parameter, ...]:
        found: list[Parameter] = []
        for section in sections:
            found.extend(typed_list(section.items[1:], self._file))
            check_types(found, parents, self._file, section.line)
        return tuple(found)

    def _schemas(self, sections: Iterable[Group], parents: dict[str, str]) -> dict[str, Schema]:
        schemas: dict[str, Schema] = {}
        for section in sections:
            for item in section.items[1:]:
                if isinstance(item, Symbol):
                    if item.text in ("-", "number"):
                        continue
                    raise PddlError(self._file, item.line, f"'{item.text}' needs brackets")
                parameters = tuple(typed_list(item.items[1:], self._file))
                check_types(parameters, parents, self._file, item.line)
                if not item.head or item.head in schemas:
                    word = item.head or "("
                    raise PddlError(self._file, item.line, f"'{word}' is declared twice or unnamed")
                schemas[item.head] = Schema(item.head, parameters, item.line)
        return schemas

    def _check_guards(self, domain: Domain) -> None:
        changed = domain.fluents()
        guards = (g for a in domain.actions for part in a.guarded for g in part.guards)
        for guard in guards:
            if guard.name in changed:
                raise PddlError(
                    self._file,
                    guard.line,
                    f"'{guard.name}' guards an 'imply' but is changed by an action; "
                    "a guard must be static",
                )


def _named(sections: list[Group], head: str) -> list[Group]:
    return [s for s in sections if s.head == head]
