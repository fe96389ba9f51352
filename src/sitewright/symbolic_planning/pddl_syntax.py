"""The brackets of PDDL: text into nested groups that remember their line."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from sitewright.errors import BuildingModelError

_TOKEN = re.compile(r";[^\n]*|\n|[()]|[^\s();]+")


class PddlError(BuildingModelError):
    """A PDDL file that we cannot use, with the line that is to blame."""

    def __init__(self, file: str, line: int, message: str) -> None:
        self.file, self.line = file, line
        super().__init__(f"{file}:{line}: {message}")


@dataclass(frozen=True, slots=True)
class Symbol:
    """A word in lower case."""

    text: str
    line: int


@dataclass(frozen=True, slots=True)
class Group:
    """Everything between two brackets; `line` is that of the opening one."""

    items: tuple[Symbol | Group, ...]
    line: int

    @property
    def head(self) -> str:
        """The first word, or an empty text."""
        first = self.items[0] if self.items else None
        return first.text if isinstance(first, Symbol) else ""


def read_group(text: str, file: str) -> Group:
    """Return the one bracketed expression that a PDDL file is.

    Raises:
        PddlError: Brackets do not match, or there is more or less than one expression.
    """
    stack: list[tuple[int, list[Symbol | Group]]] = [(1, [])]
    line = 1
    for word, line in _tokens(text):
        if word == "(":
            stack.append((line, []))
        elif word == ")":
            if len(stack) == 1:
                raise PddlError(file, line, "this ')' closes nothing")
            start, items = stack.pop()
            stack[-1][1].append(Group(tuple(items), start))
        else:
            stack[-1][1].append(Symbol(word, line))
    if len(stack) > 1:
        raise PddlError(file, stack[-1][0], "this '(' is never closed")
    return _only_group(stack[0][1], file, line)


def _only_group(items: list[Symbol | Group], file: str, last_line: int) -> Group:
    if not items:
        raise PddlError(file, last_line, "the file is empty")
    first = items[0]
    if len(items) > 1 or not isinstance(first, Group):
        extra = items[1] if len(items) > 1 else first
        raise PddlError(file, extra.line, "a PDDL file is one '(define ...)' and nothing else")
    return first


def _tokens(text: str) -> Iterator[tuple[str, int]]:
    line = 1
    for match in _TOKEN.finditer(text):
        word = match.group()
        if word == "\n":
            line += 1
        elif not word.startswith(";"):
            yield word.lower(), line
