"""Problems as lines for people: what many components share is said once."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from sitewright.errors import Problem
from sitewright.foundation.plain_text import one_line

_FOLDED_FROM = 3
"""So many problems of one kind become one entry."""
_NAMED = 10
_FIGURE = re.compile(r"'[^']*'|\S*\d\S*|[\w$]{22}")
"""What differs between problems of one kind: names in quotes, numbers and ids."""


def problem_lines(problems: Sequence[Problem], *, is_all: bool = False) -> Iterator[str]:
    """Yield a line for each problem; three or more of one kind make one entry.

    Args:
        problems: In the order in which they are to be said.
        is_all: Fold nothing.
    """
    groups: dict[tuple[str, ...], list[Problem]] = {}
    for number, problem in enumerate(problems):
        key = (str(number),) if is_all else _kind(problem)
        groups.setdefault(key, []).append(problem)
    for group in groups.values():
        if len(group) < _FOLDED_FROM:
            yield from (_with_mark(str(p), p) for p in group)
        else:
            yield from _entry(group)


def _kind(problem: Problem) -> tuple[str, ...]:
    return (
        problem.severity,
        problem.code,
        str(problem.is_fixable),
        _FIGURE.sub("*", problem.message),
        _FIGURE.sub("*", problem.fix),
    )


def _entry(group: Sequence[Problem]) -> Iterator[str]:
    """Say what a group shares, in the words of the text that most of it has."""
    texts: dict[str, list[Problem]] = {}
    for problem in group:
        texts.setdefault(f"{problem.message} {problem.fix}".rstrip(), []).append(problem)
    most = max(texts, key=lambda t: len(texts[t]))
    first = texts[most][0]
    said = f"{first.severity} {first.code} {len(group)} times: {most}"
    yield _with_mark(said, first)
    wheres = list(dict.fromkeys(p.where for p in (*texts[most], *group)))
    rest = f" and {len(wheres) - _NAMED} more" if len(wheres) > _NAMED else ""
    others = len(group) - len(texts[most])
    figures = f" (figures of {first.where}; those of {others} differ)" if others else ""
    yield one_line(f"    {', '.join(wheres[:_NAMED])}{rest}{figures}")


def _with_mark(line: str, problem: Problem) -> str:
    line = one_line(line)
    return f"{line} [--fix]" if problem.is_fixable else line
