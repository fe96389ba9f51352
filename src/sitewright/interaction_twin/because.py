"""Why a step of a plan is there, in one clause."""

from __future__ import annotations

from collections.abc import Sequence

from sitewright.central_controller.causes import CausalLink, causal_links, is_asked_for
from sitewright.central_controller.proposal import ProposedStep
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.narration import fact_in_words, narrate, reason
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook

_NOT = "(not "


def reasons(steps: Sequence[ProposedStep], labels: Labels, book: Phrasebook = ENGLISH) -> list[str]:
    """Return a clause such as ``because kr120-b needs stud 1 in place`` for each step.

    What another robot waits for comes first, then what the design asks for, then the next step
    that needs this one, then what of it lasts to the end of the plan. Empty if nothing of that
    is known.
    """
    links = causal_links(steps)
    return [
        reason(steps, index, labels, book) or _clause(step, steps, links, labels, book)
        for index, step in enumerate(steps)
    ]


def _clause(
    step: ProposedStep,
    steps: Sequence[ProposedStep],
    links: Sequence[CausalLink],
    labels: Labels,
    book: Phrasebook,
) -> str:
    own = [x for x in links if x.producer == step.number and not x.fact.startswith(_NOT)]
    lasting = [x.fact for x in own if x.consumer is None]
    asked = next((f for f in lasting if is_asked_for(f)), None)
    if asked is not None:
        return book.page["asked-for"].format(need=fact_in_words(asked, labels, book))
    needed = min((x.consumer for x in own if x.consumer is not None), default=None)
    if needed is not None:
        words = narrate(steps[needed - 1].call, labels, book)
        return book.page["then"].format(number=needed, words=words)
    if lasting:
        return book.page["ends"].format(need=fact_in_words(lasting[0], labels, book))
    return ""
