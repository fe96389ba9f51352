"""Words of drivers and skills in plain English; all other sentences are English as they are made."""

from __future__ import annotations

from collections.abc import Mapping

TOLD_ENGLISH: Mapping[str, str] = {
    "apply-finish": "paint",
    "change-end-effector": "change the tool",
    "set-down": "set down",
    "grasp-failed": "the gripper did not get hold of it",
    "missed": "it missed",
    "dropped": "it was dropped",
    "position-failed": "it did not come to its place",
    "coverage-short": "not all of it is painted",
    "dock-failed": "the tool did not come to its dock",
    "tracking": "the arm left its trajectory",
    "held": "it was held",
}
