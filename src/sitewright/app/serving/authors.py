"""Whose wishes a plan carries out: who chose it, asked for it, or drew what it goes round."""

from __future__ import annotations

from collections.abc import Mapping

from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.events import AnyEvent, ApprovalGiven, ProposalMade
from sitewright.interaction_twin.roles import Verb

_WISHES = frozenset({Verb.INSTEAD, Verb.NEW_MOTION, Verb.ZONE, Verb.MANUAL})


class Authors:
    """A fold of the journal; wishes count for every plan until one is approved."""

    def __init__(self) -> None:
        self._wished: frozenset[str] = frozenset()
        self._of: dict[str, frozenset[str]] = {}

    @property
    def by_fingerprint(self) -> Mapping[str, frozenset[str]]:
        """Names by the plan that carries out what they wished."""
        return self._of

    def note(self, event: AnyEvent) -> None:
        """Learn from an event that is on the disk."""
        match event:
            case ProposalMade(fingerprint=made):
                self._of[made] = self._wished
            case ApprovalGiven():
                self._wished = frozenset()
            case _:
                record = getattr(event, "decision", None)
                if isinstance(record, DecisionRecord) and record.verb in _WISHES:
                    names = {str(getattr(event, "who", "")), record.second} - {""}
                    self._wished |= names
