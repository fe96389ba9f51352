"""Which solids come near each other, found without looking at every pair."""

from __future__ import annotations

from collections.abc import Mapping

from sitewright.building_model.inference.solid import Solid
from sitewright.foundation.ids import ComponentId


def near_pairs(
    solid_by_id: Mapping[ComponentId, Solid], within_m: float
) -> list[tuple[ComponentId, ComponentId]]:
    """Return the pairs, in order of id, whose boxes along the model's axes come this near."""
    ordered = sorted(solid_by_id, key=lambda i: solid_by_id[i].low_m[0])
    found = []
    for place, a in enumerate(ordered):
        one = solid_by_id[a]
        reach_m = one.high_m[0] + within_m
        for b in ordered[place + 1 :]:
            other = solid_by_id[b]
            if other.low_m[0] > reach_m:
                break
            if one.may_be_near(other, within_m):
                found.append((min(a, b), max(a, b)))
    return sorted(found)
