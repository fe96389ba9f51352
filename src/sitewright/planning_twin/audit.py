"""What an audit says about a stored certificate. No numpy here."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Protocol

from sitewright.planning_twin.motion import Certificate, JointPath, TeamPath
from sitewright.planning_twin.scene import SceneSnapshot


class Fault(StrEnum):
    """What is wrong with a stored certificate."""

    RECORD = "record"
    """What the journal names is not in the run folder, or is not what was written."""
    SCENE = "scene"
    """The scene is not the cell as the journal says that it was sensed."""
    TRAJECTORY = "trajectory"
    """What ran is not what was certified."""
    THRESHOLD = "threshold"
    """Something may touch that may not, or for too long, or too deep."""
    DISTANCE = "distance"
    """A pair comes nearer than its threshold, or could not be shown not to."""
    CLAIM = "claim"
    """The certificate says more than is true."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Objection:
    """One thing that is wrong, for people."""

    fault: Fault
    what: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Reproof:
    """What a second proof of a path came to.

    Attributes:
        objections: Empty if all was proven.
        pairs: How many pairs of parts it speaks of.
        gaps: How many separating planes it took.
    """

    objections: tuple[Objection, ...]
    pairs: int
    gaps: int


class CertificateAudit(Protocol):
    """Proves a certified path once more, independently of who planned and certified it."""

    def reprove(
        self, scene: SceneSnapshot, path: JointPath | TeamPath, claimed: Certificate
    ) -> Reproof:
        """Prove the path's thresholds, and the certificate's closest distance, in a scene."""
        ...
