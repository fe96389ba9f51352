"""Which step of a proposal needs what another one brings about."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sitewright.central_controller.proposal import ProposedStep

_NOT = "(not "
_ASKED_FOR = ("(fastened ", "(finished ", "(standing ", "(in-place ", "(lies-at ")
"""What a plan is made for; all else is means or tidying up."""


@dataclass(frozen=True, slots=True)
class CausalLink:
    """Step `producer` makes `fact` true, which step `consumer` needs.

    Attributes:
        producer: Number of the step; 0 is the site before the plan.
        consumer: Number of the step; None if the fact still holds at the end of the plan.
        fact: As PDDL text in site ids.
    """

    producer: int
    consumer: int | None
    fact: str


def causal_links(steps: Sequence[ProposedStep]) -> tuple[CausalLink, ...]:
    """Return who makes true what whom needs, by consumer; what lasts comes at the end."""
    made_by: dict[str, int] = {}
    links: list[CausalLink] = []
    for step in steps:
        links += [CausalLink(made_by.get(f, 0), step.number, f) for f in step.relies_on]
        for effect in step.effects:
            made_by.pop(_opposite(effect), None)
            made_by[effect] = step.number
    return (*links, *(CausalLink(n, None, f) for f, n in sorted(made_by.items())))


def is_asked_for(fact: str) -> bool:
    """Tell whether a fact is what the design asks for, not only a means to it."""
    return fact.startswith(_ASKED_FOR)


def way_to_purpose(links: Iterable[CausalLink], number: int) -> tuple[int, ...]:
    """Return steps from one to the nearest that brings about something the design asks for.

    Each needs something of the one before; only the step itself if it does so, none if it is
    of no use for any such step.
    """
    after: dict[int, list[int]] = {}
    for link in links:
        if link.consumer is not None:
            after.setdefault(link.producer, []).append(link.consumer)
    purposeful = {x.producer for x in links if x.consumer is None and is_asked_for(x.fact)}
    waiting: deque[tuple[int, ...]] = deque([(number,)])
    seen = {number}
    while waiting:
        way = waiting.popleft()
        if way[-1] in purposeful:
            return way
        for following in sorted(after.get(way[-1], ())):
            if following not in seen:
                seen.add(following)
                waiting.append((*way, following))
    return ()


def _opposite(fact: str) -> str:
    return fact.removeprefix(_NOT)[:-1] if fact.startswith(_NOT) else f"{_NOT}{fact})"
