"""What several documents have: poses, layers, words for how things stand."""

from __future__ import annotations

from typing import Literal

from typing_extensions import TypeAliasType, TypedDict

Vec3 = TypeAliasType("Vec3", tuple[float, float, float])
Triangle = TypeAliasType("Triangle", tuple[int, int, int])
Layer = TypeAliasType(
    "Layer", Literal["target", "material", "as_built", "as_designed", "virtual_collision"]
)
StepStatus = TypeAliasType(
    "StepStatus", Literal["open", "running", "done", "not done", "superseded"]
)
Phase = TypeAliasType(
    "Phase",
    Literal[
        "idle",
        "planning",
        "waiting",
        "running",
        "holding",
        "held",
        "question",
        "needs-help",
        "finished",
        "broken",
    ],
)


class Pose(TypedDict):
    p_m: Vec3
    q_wxyz: tuple[float, float, float, float]
