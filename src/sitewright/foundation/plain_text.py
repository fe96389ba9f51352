"""Texts of strangers made safe to show: nothing in them steers a terminal or hides words."""

from __future__ import annotations

_SPACES = frozenset("\u00a0\u2007\u202f\u3000")


def one_line(text: str) -> str:
    r"""Return a text in one line, with escapes such as ``\x1b`` for what no one sees.

    These are control characters, line ends, marks that turn the direction of reading or have no
    width, and halves of characters.
    """
    if text.isprintable():
        return text
    return "".join(_seen(c) for c in text)


def printable(text: str) -> str:
    """Return a text of several lines, each as `one_line` gives it."""
    return "\n".join(one_line(line) for line in text.split("\n"))


def json_text(text: str) -> str:
    r"""Return JSON text with ``\u`` escapes for what `one_line` would escape; its value stays."""
    if text.isprintable():
        return text
    return "".join(c if c == "\n" or _is_seen(c) else _json_escape(c) for c in text)


def _is_seen(character: str) -> bool:
    return character.isprintable() or character in _SPACES


def _seen(character: str) -> str:
    return character if _is_seen(character) else character.encode("unicode_escape").decode()


def _json_escape(character: str) -> str:
    units = character.encode("utf-16-be", "surrogatepass")
    pairs = (units[i : i + 2].hex() for i in range(0, len(units), 2))
    return "".join(f"\\u{unit}" for unit in pairs)
