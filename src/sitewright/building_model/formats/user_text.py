"""The attributes of one part by our keys, and the words that came with it."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.building_model.formats.import_map import (
    PREFIX,
    READ_KEYS,
    WRITTEN_KEYS,
    ImportMap,
)
from sitewright.building_model.formats.neutral import NeutralPart
from sitewright.errors import Problem, did_you_mean
from sitewright.foundation.canonical import Json

_FORMULA = re.compile(r"%<.*>%", re.DOTALL)
_UNSEEN = re.compile(
    r"[\x00-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2066-\u2069\ufeff\ufff9-\ufffb]"
)
_MAX_WORD = 256
_YES = frozenset({"1", "true", "yes", "y", "x"})
_NO = frozenset({"", "0", "false", "no", "n"})


@dataclass(frozen=True, slots=True, kw_only=True)
class Attributes:
    """What a part says of itself.

    Attributes:
        value_by_key: Our keys (without prefix) with their text.
        rest: Everything else, as it stands in the file.
        problems: Formulas, unknown keys of ours.
    """

    value_by_key: Mapping[str, str] = field(default_factory=dict)
    rest: Mapping[str, Json] = field(default_factory=dict)
    problems: tuple[Problem, ...] = ()

    def get(self, key: str) -> str:
        """Return the text of one of our keys; empty if there is none."""
        return self.value_by_key.get(key, "")


class WrongValueError(ValueError):
    """A value of ours cannot be read; its text says why."""


def attributes_of(part: NeutralPart, words: ImportMap) -> Attributes:
    """Return a part's attributes: our own keys first, then those of the user's map.

    What an earlier export wrote is passed over.
    """
    ours: dict[str, str] = {}
    rest: dict[str, Json] = dict(part.raw)
    problems: list[Problem] = []
    has_told_formulas = any(code == "T1" for code, _, _ in part.problems)
    for key, text in sorted(part.user_text.items()):
        name = _own(key)
        if _FORMULA.search(text):
            rest[key] = text
            if not has_told_formulas:
                problems.append(_formula(part, key))
        elif name in READ_KEYS:
            ours[name] = text.strip()
        elif name not in WRITTEN_KEYS:
            rest[key] = text
            if name:
                problems.append(_unknown(part, key, name))
    theirs = {k: v for k, foreign in words.foreign_keys.items() if (v := _foreign(part, foreign))}
    return Attributes(value_by_key={**theirs, **ours}, rest=rest, problems=tuple(problems))


def _own(key: str) -> str:
    """Return a key of ours without its prefix, in small letters; empty if it is none."""
    return key[len(PREFIX) :].lower() if key.lower().startswith(PREFIX) else ""


def word(text: str) -> str:
    """Return a text as a label: composed, without control or direction marks, not too long."""
    return _UNSEEN.sub("", unicodedata.normalize("NFC", _printable(text))).strip()[:_MAX_WORD]


def whole_number(text: str) -> int:
    """Return an integer.

    Raises:
        WrongValueError: It is none.
    """
    try:
        value = float(text.replace(",", "."))
        number = int(value)
    except (ValueError, OverflowError):
        raise WrongValueError(f"{text[:60]!r} is no whole number") from None
    if number != value or abs(number) > 10**9:
        raise WrongValueError(f"{text[:60]!r} is no whole number")
    return number


def positive_number(text: str) -> float:
    """Return a number above zero.

    Raises:
        WrongValueError: It is none.
    """
    try:
        value = float(text.replace(",", "."))
    except ValueError:
        raise WrongValueError(f"{text[:60]!r} is no number") from None
    if not 0.0 < value < 1e9:  # noqa: PLR2004 - more than any building weighs
        raise WrongValueError(f"{text[:60]!r} is no number above zero")
    return value


def yes_or_no(text: str) -> bool:
    """Return whether a text says yes.

    Raises:
        WrongValueError: It says neither.
    """
    folded = text.casefold()
    if folded in _YES:
        return True
    if folded in _NO:
        return False
    raise WrongValueError(f"{text[:60]!r} says neither yes nor no")


def _foreign(part: NeutralPart, keys: tuple[str, ...]) -> str:
    for key in keys:
        value: Json = part.user_text.get(key, part.raw.get(key))
        if value is None and "." in key:
            head, tail = key.split(".", 1)
            table = part.raw.get(head)
            value = table.get(tail) if isinstance(table, Mapping) else None
        text = str(value) if isinstance(value, str | int | float) else ""
        if text and not _FORMULA.search(text):
            return text.strip()
    return ""


def _printable(text: str) -> str:
    return text.encode("utf-8", errors="replace").decode("utf-8")


def _formula(part: NeutralPart, key: str) -> Problem:
    message = f"{key!r} holds a Rhino formula; it is not evaluated."
    return _warned(part, "T1", message, "Write the value itself where it matters.")


def _unknown(part: NeutralPart, key: str, name: str) -> Problem:
    message = f"Sitewright reads no key {key!r}.{did_you_mean(name, READ_KEYS)}"
    return _warned(part, "K1", message, "Correct the key; its value is kept under 'raw'.")


def _warned(part: NeutralPart, code: str, message: str, fix: str) -> Problem:
    return Problem(
        code=code,
        severity="W",
        where=word(part.name) or part.source_id,
        message=message,
        fix=fix,
        source_id=part.source_id,
    )
