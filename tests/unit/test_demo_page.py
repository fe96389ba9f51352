"""When `demo` opens the page: where somebody can see it, and nowhere else."""

from __future__ import annotations

import sys

import pytest

from sitewright.cli.run_commands import can_show_page


class _Screen:
    def __init__(self, *, is_terminal: bool) -> None:
        self._is_terminal = is_terminal

    def isatty(self) -> bool:
        return self._is_terminal


@pytest.mark.parametrize("name", ["DISPLAY", "WAYLAND_DISPLAY", ""])
@pytest.mark.parametrize("is_terminal", [True, False])
def test_the_page_needs_a_terminal_and_a_display(
    monkeypatch: pytest.MonkeyPatch, name: str, *, is_terminal: bool
) -> None:
    for display in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(display, raising=False)
    if name:
        monkeypatch.setenv(name, ":0")
    monkeypatch.setattr(sys, "stdin", _Screen(is_terminal=is_terminal))
    monkeypatch.setattr(sys, "stdout", _Screen(is_terminal=is_terminal))
    assert can_show_page() == (is_terminal and bool(name))
