"""Texts of strangers are shown without their power over terminals and readers."""

from __future__ import annotations

import json

import pytest

from sitewright.foundation.plain_text import json_text, one_line, printable


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("Träger 柱 a\u00a0b", "Träger 柱 a\u00a0b"),
        ("red \x1b[31m", "red \\x1b[31m"),
        ("c1 \x9b31m", "c1 \\x9b31m"),
        ("a\nE E2 wall: all is well", "a\\nE E2 wall: all is well"),
        ("bidi \u202egnp.exe", "bidi \\u202egnp.exe"),
        ("half \udc80", "half \\udc80"),
        ("none\u200bwide", "none\\u200bwide"),
    ],
)
def test_what_no_one_sees_is_shown_as_an_escape(text: str, shown: str) -> None:
    assert one_line(text) == shown


def test_lines_stay_lines() -> None:
    assert printable("a\n  b\x07\n") == "a\n  b\\x07\n"


def test_json_keeps_its_value() -> None:
    value = {"name": "\x9b31m \u202e \U000e0001 柱\u00a0ä", "lines": ["a\nb"]}
    text = json_text(json.dumps(value, indent=2, ensure_ascii=False))
    assert json.loads(text) == value
    assert "柱" in text
    assert one_line(text.replace("\n", "")) == text.replace("\n", "")
