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
        has_posture: Some grasp had a posture, clear or not.
        is_proven: Each "no" of the inverse kinematics is a proof.
        poses: How many poses were solved; all grasps at once, or none.
    """

    is_served: bool = False
    nearest_m: float = np.inf
    has_posture: bool = False
    is_proven: bool = True
    poses: int = 0
    blame: Blame = field(default_factory=Blame)

    @property
    def is_never(self) -> bool:
        """Whether it is proven that no grasp has a posture here."""
        return self.poses > 0 and self.is_proven and not self.has_posture

    def note(self, rows: Postures) -> None:
        """Take in the inverse kinematics of all grasps of a group."""
        has = rows.has()
        self.poses += len(has)
        self.has_posture |= bool(has.any())
        self.is_proven &= bool((rows.is_never | has).all())
        if len(has):
            self.nearest_m = min(self.nearest_m, float(np.where(has, 0.0, rows.beyond_m).min()))

    def join(self, other: EndRecord) -> None:
        """Take in what is known of other grasps at this end."""
        self.is_served |= other.is_served
        self.has_posture |= other.has_posture
        self.is_proven &= other.is_proven
        self.nearest_m = min(self.nearest_m, other.nearest_m)
        self.poses += other.poses
        self.blame.note([other.blame.pairs])

    def refusal(self) -> NoIk | BlockedBy:
        """Return why no grasp serves; hands that are in the way were looked at first."""
        if self.has_posture or not self.poses:
            return self.blame.refusal()
        beyond_m = self.nearest_m if self.is_never else 0.0
        return NoIk(
            is_proven=self.is_never,
            extension_m=beyond_m,
            tried=self.poses,
            reason="every posture is outside the joint limits" if beyond_m == 0.0 else "",
        )
