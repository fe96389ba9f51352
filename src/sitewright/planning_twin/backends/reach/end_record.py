"""What is known of one end of a handling, over all grasps that were looked at."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from sitewright.planning_twin.backends.reach.arm_poses import Postures
from sitewright.planning_twin.backends.reach.ends import Blame
from sitewright.planning_twin.refusal import BlockedBy, NoIk


@dataclass(slots=True)
class EndRecord:
    """Reach and blockers at one end.

    Attributes:
        is_served: Some grasp has a clear posture there.
        nearest_m: How far the best grasp is out of reach; infinity while none was looked at.
        is_never: No grasp had a posture, and each of these noes is proven.
        has_posture: Some grasp had a posture, clear or not.
        poses: How many were looked at.
    """

    is_served: bool = False
    nearest_m: float = np.inf
    is_never: bool = True
    has_posture: bool = False
    poses: int = 0
    blame: Blame = field(default_factory=Blame)

    def note(self, rows: Postures) -> None:
        """Take in the inverse kinematics of some grasps."""
        has = rows.has()
        self.poses += len(has)
        self.has_posture |= bool(has.any())
        self.is_never &= bool((rows.is_never & ~has).all())
        if len(has):
            self.nearest_m = min(self.nearest_m, float(np.where(has, 0.0, rows.beyond_m).min()))

    def refusal(self) -> NoIk | BlockedBy:
        """Return why no grasp serves, once all were looked at."""
        if self.has_posture:
            return self.blame.refusal()
        beyond_m = self.nearest_m if self.is_never else 0.0
        return NoIk(
            is_proven=self.is_never,
            extension_m=beyond_m,
            tried=self.poses,
            reason="every posture is outside the joint limits" if beyond_m == 0.0 else "",
        )
