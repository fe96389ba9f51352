"""A stored wall of blocks and two arms with clamps: light blocks are reached, heavy ones not."""

from __future__ import annotations

from pathlib import Path

from builders_masonry import block_wall
from builders_reach import checked
from sitewright.planning_twin.reachability.verdict import Standing

_AERATED_KG_M3, _HEAVY_KG_M3 = 600.0, 2400.0


def test_a_clamp_of_150_to_450_mm_carries_light_blocks_and_no_heavy_ones(shared_data: Path) -> None:
    """A whole block of heavy concrete weighs 88 kg, the clamp 42, and the arm may carry 120."""
    file = shared_data / "masonry" / "wall_assembly.json"
    light, heavy = (
        checked(block_wall(file, density_kg_m3=kg_m3)) for kg_m3 in (_AERATED_KG_M3, _HEAVY_KG_M3)
    )
    assert len(light.verdicts) == 52
    assert light.share > 0.3
    assert not any("payload" in r or "heavy" in r for v in light.verdicts for r in v.reasons)
    half = {"block-10", "block-20", "block-31", "block-41"}
    whole = [v for v in heavy.verdicts if v.target not in half]
    assert {v.standing for v in whole} == {Standing.IMPOSSIBLE}
