"""What the server needs of the world behind it: a port, filled in by `app`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Protocol

from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.decisions import Decision, Reply
from sitewright.interaction_twin.roles import Person

Document = Mapping[str, Json]

News = Callable[[str], Document]
"""Returns what is told, in a language."""


class Twin(Protocol):
    """The read side of a project, and the way to the process of its run.

    Reads that may take longer are coroutines; none of them blocks the event loop.
    """

    def state(self, language: str = "en") -> Document:
        """Return how the run stands now (the WebSocket's ``state``)."""
        ...

    async def scene(self) -> tuple[str, bytes]:
        """Return hash and text of everything that is drawn."""
        ...

    async def proposal(self, fingerprint: str, language: str) -> Document | None:
        """Return a proposal; the open one if `fingerprint` is empty."""
        ...

    async def blob(self, sha256: str) -> bytes | None:
        """Return the exact bytes of a trajectory of any proposal of the runs."""
        ...

    async def decide(self, decision: Decision, person: Person, body_sha256: str) -> Reply:
        """Pass a decision on; a "yes" comes when it is on the disk."""
        ...

    async def hold(self, decision: Decision, person: Person, body_sha256: str) -> Reply:
        """Stop the robots: the cell first, the journal after."""
        ...

    async def ways(self, fingerprint: str, language: str) -> Reply:
        """Return what else could be done instead of the next step."""
        ...

    def by_hand(self, target: str, language: str) -> Document | None:
        """Return what a person can vouch for at a target."""
        ...

    def events_after(self, run: str, number: int, language: str) -> Sequence[Document]:
        """Return the events after one, in order, as the WebSocket sends them."""
        ...

    def last_event(self) -> tuple[str, int]:
        """Return run and number of the newest event."""
        ...

    async def runs(self) -> Document:
        """Return all runs of the project."""
        ...

    async def run(self, run: str, language: str) -> Document | None:
        """Return one run with its events and bars."""
        ...

    async def replay(self, run: str) -> Document | None:
        """Return everything that was sensed in a run, to be looked at again."""
        ...

    async def why(self, fingerprint: str, number: int, language: str) -> Document | None:
        """Return why a step of a proposal is as it is."""
        ...

    async def report(self, run: str) -> bytes | None:
        """Return the report of a run as a page of its own; None while there is none."""
        ...

    async def schedule(self) -> Document:
        """Return planned and actual skills of the newest run on one time axis."""
        ...

    async def plan_schedule(self, fingerprint: str, language: str, width_px: float) -> str | None:
        """Return the schedule of a plan, and what ran of it, as a picture."""
        ...

    async def run_schedule(self, run: str, language: str, width_px: float) -> str | None:
        """Return the schedule of a whole run as a picture."""
        ...

    async def graph_picture(self, language: str) -> str:
        """Return what rests on what in the building now as a picture."""
        ...

    async def graph(self) -> Document:
        """Return the construction relationship graph now."""
        ...

    def audit(self, language: str) -> Document:
        """Return all decisions, the newest first."""
        ...

    async def health(self) -> Document:
        """Return how server, run, cell and journal are."""
        ...


class Audience(Protocol):
    """Where news goes: to all pages."""

    def tell(self, news: News) -> None:
        """Send a text that nobody may miss."""
        ...

    def show(self, frame: bytes) -> None:
        """Send a picture of the joints; whoever is slow gets the newest only."""
        ...

    @property
    def size(self) -> int:
        """How many pages are connected."""
        ...
