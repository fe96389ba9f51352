"""Health of the server, and answers to what was sent."""

from __future__ import annotations

from typing import Literal, NotRequired

from typing_extensions import TypedDict

from sitewright.interaction_twin.wire.basics import Phase
from sitewright.interaction_twin.wire.plan import Difference


class ServerHealth(TypedDict):
    version: str
    uptime_s: float
    clients: int


class ProcessHealth(TypedDict):
    phase: Phase
    pid: int | None
    is_alive: bool


class CellHealth(TypedDict):
    state: Literal["live", "absent"]
    age_ms: float | None


class JournalHealth(TypedDict):
    run: str
    n: int
    is_whole: bool


class Health(TypedDict):
    server: ServerHealth
    run: ProcessHealth
    cell: CellHealth
    journal: JournalHealth
    disk_free_bytes: int


class Session(TypedDict):
    """Who is signed in; with `asks_pin` each decision carries name and PIN of who makes it."""

    asks_pin: bool
    people: list[str]
    who: str
    role: Literal["viewer", "operator", "supervisor", "admin"]
    can: list[str]
    port: int
    is_simulation: bool
    languages: list[str]


class SignedOut(TypedDict):
    ok: bool


class Ticket(TypedDict):
    ticket: str
    expires_s: int


class Recorded(TypedDict):
    """A decision was taken; `waiting_for` says that one person was not enough."""

    ok: bool
    verb: str
    who: NotRequired[str]
    at_ms: NotRequired[int]
    run: NotRequired[str]
    n: NotRequired[int]
    code: NotRequired[str]
    approval_id: NotRequired[str]
    repeated: NotRequired[bool]
    waiting_for: NotRequired[str]
    message: NotRequired[str]


class HoldAnswer(TypedDict):
    ok: bool
    told_cell: bool


class Wrong(TypedDict):
    field: str
    message: str


class OpenNow(TypedDict):
    fingerprint: str
    code: str


class Refusal(TypedDict):
    """Body of every answer that is no success."""

    error: str
    message: str
    open: NotRequired[OpenNow | None]
    changed: NotRequired[list[Difference]]
    why: NotRequired[str]
    shown: NotRequired[str]
    who: NotRequired[str]
    verb: NotRequired[str]
    at_ms: NotRequired[int | None]
    needs: NotRequired[str]
    step: NotRequired[int]
    next_step: NotRequired[int]
    authors: NotRequired[list[str]]
    wait_s: NotRequired[float]
    possible: NotRequired[list[str]]
    told_cell: NotRequired[bool]
    where: NotRequired[list[Wrong]]
