"""Reads JSON text with suspicion: size, depth, duplicate keys, numbers that are none, cut files."""

from __future__ import annotations

import json
import math
import re
from collections import Counter
from pathlib import Path

from sitewright.errors import Problem
from sitewright.foundation.canonical import Json

MAX_BYTES = 100_000_000
MAX_DEPTH = 32
_MAX_DIGITS = 300
_TOLD = 20
_WIDTH = 60
_BRACKET_OR_STRING = re.compile(r'[][{}]|"[^"\\]*+(?:\\.[^"\\]*+)*+"?', re.DOTALL)


def read_text(path: Path) -> str | Problem:
    """Return a file's text without a byte order mark, or why it cannot be read."""
    try:
        if path.stat().st_size > MAX_BYTES:
            return _problem(path, "E5", f"The file is larger than {MAX_BYTES // 10**6} MB.")
        return path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        return _problem(path, "E5", f"Byte {error.start} is not UTF-8.", "Save the file as UTF-8.")
    except OSError as error:
        reason = error.strerror or str(error)
        return _problem(path, "E2", f"The file cannot be read: {reason}.", "Check the path.")


def parse(text: str, path: Path) -> tuple[Json, list[Problem]]:
    """Return the document and what is wrong with its text; the document is None if unreadable.

    Of the wrong keys and numbers the first twenty are told one by one.
    """
    if text.startswith("version https://git-lfs.github.com/"):
        return None, [_problem(path, "E2", "It is a Git LFS pointer.", "Run git lfs pull.")]
    if place := _too_deep(text):
        message = f"Line {place[0]}, column {place[1]}: nested deeper than {MAX_DEPTH}."
        return None, [_problem(path, "E5", message)]
    scan = _Scan(path)
    try:
        document: Json = json.loads(
            text,
            object_pairs_hook=scan.unique,
            parse_constant=scan.no_number,
            parse_float=scan.finite,
            parse_int=scan.whole,
        )
    except json.JSONDecodeError as error:
        return None, [_syntax_problem(error, text, path)]
    except ValueError as error:
        fix = f"Write one of at most {_MAX_DIGITS} digits."
        return None, [_problem(path, "E5", f"It cannot be read: {error}.", fix)]
    if _has_lone_surrogate(text, document):
        message = "A text holds half a character (a lone surrogate such as \\ud800)."
        return None, [_problem(path, "E5", message, "Write the character whole, or remove it.")]
    return document, scan.problems()


class _Scan:
    """What is wrong with keys and numbers, as they are met."""

    def __init__(self, path: Path) -> None:
        self._path, self._found, self._total = path, list[Problem](), 0

    def problems(self) -> list[Problem]:
        """Return the first of them, and how many more there are."""
        if self._total == len(self._found):
            return self._found
        more = f"{self._total - len(self._found)} more keys and numbers are wrong."
        code = self._found[0].code
        return [*self._found, _problem(self._path, code, more, "Correct these first.")]

    def unique(self, pairs: list[tuple[str, Json]]) -> dict[str, Json]:
        """Return an object; a key that stands twice is told."""
        result = dict(pairs)
        if len(result) < len(pairs):
            near = next((f" of {_shown(v)}" for k, v in pairs if k == "id"), "")
            for key, count in Counter(k for k, _ in pairs).items():
                if count > 1:
                    times = "twice" if count == 2 else f"{count} times"  # noqa: PLR2004
                    message = f"The key {_shown(key)}{near} stands {times} in one object."
                    self._add("K2", message, "Leave only one of them.")
        return result

    def no_number(self, word: str) -> float:
        """Tell ``NaN`` and ``Infinity``."""
        self._add("K3", f"{word} is not a number.", "Write a finite number.")
        return 0.0

    def finite(self, digits: str) -> float:
        """Return a number with a point or an exponent; one that is infinite is told."""
        value = float(digits)
        if math.isfinite(value):
            return value
        self._add("K3", f"{digits[:40]} is too large for a number.", "Write a finite number.")
        return 0.0

    def whole(self, digits: str) -> int:
        """Return a whole number.

        Raises:
            ValueError: It has more digits than anything in a building.
        """
        if len(digits) > _MAX_DIGITS:
            raise ValueError(f"a number has {len(digits)} digits ({digits[:20]}...)")
        return int(digits)

    def _add(self, code: str, message: str, fix: str) -> None:
        self._total += 1
        if len(self._found) < _TOLD:
            self._found.append(_problem(self._path, code, message, fix))


def _shown(value: object) -> str:
    text = repr(value)
    return text if len(text) <= _WIDTH else f"{text[:_WIDTH]}..."


def _has_lone_surrogate(text: str, document: Json) -> bool:
    """Whether an escape in the text is half a character; UTF-8 cannot hold one."""
    if "\\ud" not in text and "\\uD" not in text:
        return False
    try:
        json.dumps(document, ensure_ascii=False).encode()
    except UnicodeEncodeError:
        return True
    return False


def _too_deep(text: str) -> tuple[int, int] | None:
    """Return line and column of the first bracket nested too deep; strings are skipped."""
    depth = 0
    for match in _BRACKET_OR_STRING.finditer(text):
        character = match[0]
        if character in "[{":
            depth += 1
            if depth > MAX_DEPTH:
                line = text.count("\n", 0, match.start()) + 1
                return line, match.start() - text.rfind("\n", 0, match.start())
        elif character in "]}":
            depth -= 1
    return None


def _syntax_problem(error: json.JSONDecodeError, text: str, path: Path) -> Problem:
    place = f"Line {error.lineno}, column {error.colno}"
    if error.pos >= len(text.rstrip()) or error.msg.startswith("Unterminated string"):
        fix = "Get the whole file again; the end is missing."
        return _problem(path, "E4", f"{place}: the file is cut off ({error.msg}).", fix)
    return _problem(path, "E5", f"{place}: not JSON ({error.msg}).", "Correct the text there.")


def _problem(path: Path, code: str, message: str, fix: str = "Check the file.") -> Problem:
    return Problem(code=code, severity="E", where=path.name, message=message, fix=fix)
