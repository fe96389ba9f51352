"""Reads JSON text with suspicion: size, depth, duplicate keys, numbers that are none, cut files."""

from __future__ import annotations

import json
import math
from pathlib import Path

from sitewright.errors import Problem
from sitewright.foundation.canonical import Json

MAX_BYTES = 100_000_000
MAX_DEPTH = 32


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
    """Return the document and what is wrong with its text; the document is None if unreadable."""
    if text.startswith("version https://git-lfs.github.com/"):
        return None, [_problem(path, "E2", "It is a Git LFS pointer.", "Run git lfs pull.")]
    if place := _too_deep(text):
        message = f"Line {place[0]}, column {place[1]}: nested deeper than {MAX_DEPTH}."
        return None, [_problem(path, "E5", message)]
    found: list[Problem] = []
    try:
        document: Json = json.loads(
            text,
            object_pairs_hook=lambda pairs: _unique(pairs, path, found),
            parse_constant=lambda word: _no_number(word, path, found),
            parse_float=lambda digits: _finite(digits, path, found),
        )
    except json.JSONDecodeError as error:
        return None, [_syntax_problem(error, text, path)]
    except ValueError as error:  # an integer of thousands of digits
        return None, [_problem(path, "E5", f"A number cannot be read: {error}.")]
    return document, found


def _too_deep(text: str) -> tuple[int, int] | None:
    """Return line and column of the first bracket nested too deep; strings are skipped."""
    depth, in_string, escaped = 0, False, False
    for index, character in enumerate(text):
        if in_string:
            in_string = escaped or character != '"'
            escaped = character == "\\" and not escaped
        elif character == '"':
            in_string = True
        elif character in "[{":
            depth += 1
            if depth > MAX_DEPTH:
                line = text.count("\n", 0, index) + 1
                return line, index - text.rfind("\n", 0, index)
        elif character in "]}":
            depth -= 1
    return None


def _unique(pairs: list[tuple[str, Json]], path: Path, found: list[Problem]) -> dict[str, Json]:
    result: dict[str, Json] = {}
    for key, value in pairs:
        if key in result:
            near = next((f" of {v!r}" for k, v in pairs if k == "id"), "")
            message = f"The key {key!r}{near} stands twice in one object."
            found.append(_problem(path, "K2", message, "Remove one of the two."))
        result[key] = value
    return result


def _no_number(word: str, path: Path, found: list[Problem]) -> float:
    found.append(_problem(path, "K3", f"{word} is not a number.", "Write a finite number."))
    return 0.0


def _finite(digits: str, path: Path, found: list[Problem]) -> float:
    value = float(digits)
    if not math.isfinite(value):
        message = f"{digits[:40]} is too large for a number."
        found.append(_problem(path, "K3", message, "Write a finite number."))
        return 0.0
    return value


def _syntax_problem(error: json.JSONDecodeError, text: str, path: Path) -> Problem:
    place = f"Line {error.lineno}, column {error.colno}"
    if error.pos >= len(text.rstrip()) or error.msg.startswith("Unterminated string"):
        fix = "Get the whole file again; the end is missing."
        return _problem(path, "E4", f"{place}: the file is cut off ({error.msg}).", fix)
    return _problem(path, "E5", f"{place}: not JSON ({error.msg}).", "Correct the text there.")


def _problem(path: Path, code: str, message: str, fix: str = "Check the file.") -> Problem:
    return Problem(code=code, severity="E", where=path.name, message=message, fix=fix)
