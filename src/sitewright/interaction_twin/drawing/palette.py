"""Colours of all flat pictures, the same as those of the page."""

from __future__ import annotations

INK, SOFT, LINE, LANE, SHADE = "#1b242b", "#56626b", "#dcdad2", "#f3f2ed", "#e9eef1"
FAILED = "#b3261e"
ROBOT_COLOURS = ("#2f6f9f", "#b5651d", "#4d7f3d", "#7a569b", "#9c4657", "#3a7d7d")
"""By the robot's number, which is always written beside it: nobody has to tell colours apart."""


def robot_colour(number: int) -> str:
    """Return the colour of a robot by its number, from 1."""
    return ROBOT_COLOURS[(number - 1) % len(ROBOT_COLOURS)]
