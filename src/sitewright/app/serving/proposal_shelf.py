"""Proposals of the runs, read back from their files, and the exact bytes of their trajectories."""

from __future__ import annotations

import re
from collections import OrderedDict
from pathlib import Path

from sitewright.app.run_folder import RunFolder
from sitewright.central_controller.proposal import Proposal

_KEPT = 12
_HASH = re.compile(r"[0-9a-f]{64}")


class ProposalShelf:
    """Keeps the proposals that were looked at last; every one is checked against its name."""

    def __init__(self, runs: Path) -> None:
        self._runs = runs
        self._kept: OrderedDict[str, tuple[str, Proposal]] = OrderedDict()
        self._trajectories: dict[str, tuple[str, int, int]] = {}

    def find(self, fingerprint: str) -> tuple[str, Proposal] | None:
        """Return a proposal with its run; None if no run of the project has it."""
        if not _HASH.fullmatch(fingerprint):
            return None
        if fingerprint in self._kept:
            self._kept.move_to_end(fingerprint)
            return self._kept[fingerprint]
        for folder in sorted(self._runs.glob("*/proposals"), reverse=True):
            if (folder / f"{fingerprint}.json").exists():
                return self._load(RunFolder(folder.parent), fingerprint)
        return None

    def trajectory(self, sha256: str) -> bytes | None:
        """Return the bytes whose SHA-256 is the trajectory's; None if no proposal has it."""
        if not _HASH.fullmatch(sha256):
            return None
        if sha256 not in self._trajectories:
            self._look_through(sha256)
        place = self._trajectories.get(sha256)
        if place is None:
            return None
        fingerprint, step, motion = place
        found = self.find(fingerprint)
        if found is None:
            return None
        return found[1].steps[step].motions[motion].timed.trajectory.content()

    def _look_through(self, sha256: str) -> None:
        known = {fingerprint for fingerprint, _, _ in self._trajectories.values()}
        files = sorted(
            self._runs.glob("*/proposals/*.json"), key=lambda f: f.stat().st_mtime_ns, reverse=True
        )
        for file in files:
            if file.stem not in known:
                self.find(file.stem)
            if sha256 in self._trajectories:
                return

    def _load(self, folder: RunFolder, fingerprint: str) -> tuple[str, Proposal]:
        found = (folder.run, folder.load_proposal(fingerprint))
        self._kept[fingerprint] = found
        if len(self._kept) > _KEPT:
            self._kept.popitem(last=False)
        for s, step in enumerate(found[1].steps):
            for m, motion in enumerate(step.motions):
                self._trajectories[motion.timed.trajectory.sha256()] = (fingerprint, s, m)
        return found
