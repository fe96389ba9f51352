"""Refusals that were met before, used again while the geometry that they depend on is the same."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field

from sitewright.planning_twin.refusal import Disagreement, NoPath, Refusal, WorkerFailed

Question = tuple[str, ...]
"""What was asked, in ids: ``("hold", robot, piece, target)``."""
_MOST_QUESTIONS = 512
_MOST_ANSWERS = 8
"""So many refusals of one question, each in its own surroundings, are kept."""


@dataclass(slots=True)
class KeptRefusals:
    """Refusals by question, each with the hash of all that it depends on.

    A refusal expires when that hash changes, and comes back with it. What another try might
    answer otherwise (a search that ran out of time, engines that disagreed) is not kept.

    Attributes:
        reused: How often a search was spared.
    """

    reused: int = 0
    _kept: OrderedDict[Question, OrderedDict[str, Refusal]] = field(default_factory=OrderedDict)

    def recall(self, question: Question, scope_now: Callable[[Refusal], str]) -> Refusal | None:
        """Return the refusal of a question whose geometry is as it was, if there is one.

        Args:
            question: What is asked.
            scope_now: Hash of what a refusal depends on, as things stand now.
        """
        for scope, refusal in self._kept.get(question, {}).items():
            if scope_now(refusal) == scope:
                self.reused += 1
                return refusal
        return None

    def keep(self, question: Question, refusal: Refusal, scope: str) -> None:
        """Remember a refusal; the oldest ones are forgotten."""
        if not _is_final(refusal):
            return
        answers = self._kept.setdefault(question, OrderedDict())
        answers[scope] = refusal
        self._kept.move_to_end(question)
        if len(answers) > _MOST_ANSWERS:
            answers.popitem(last=False)
        if len(self._kept) > _MOST_QUESTIONS:
            self._kept.popitem(last=False)


def _is_final(refusal: Refusal) -> bool:
    match refusal:
        case NoPath(is_reproducible=is_reproducible):
            return is_reproducible
        case Disagreement() | WorkerFailed():
            return False
        case _:
            return True
