"""Every document that a server sends, as types: what the page's TypeScript is written from.

`tools/write_wire.py` writes ``page/src/wire.ts`` from here; tests hold what a real server sends
against the JSON Schema of these types. Metres, radians, seconds, Unix milliseconds; `_wxyz`.
"""

from __future__ import annotations

from collections.abc import Mapping

from sitewright.interaction_twin.wire.answers import (
    Health,
    HoldAnswer,
    Recorded,
    Refusal,
    Session,
    SignedOut,
    Ticket,
)
from sitewright.interaction_twin.wire.plan import ByHand, NoProposal, OtherWays, Proposal, Why
from sitewright.interaction_twin.wire.runs import (
    Audit,
    Graph,
    ReplayRecord,
    RunRecord,
    Runs,
    Schedule,
)
from sitewright.interaction_twin.wire.scene import Scene
from sitewright.interaction_twin.wire.state import CaughtUp, RunEvent, RunState

ANSWERS: Mapping[str, tuple[type, ...]] = {
    "GET /api/session": (Session,),
    "POST /api/session": (Session,),
    "DELETE /api/session": (SignedOut,),
    "POST /api/ws-ticket": (Ticket,),
    "GET /api/state": (RunState,),
    "GET /api/scene": (Scene,),
    "GET /api/proposals/{fingerprint}": (Proposal, NoProposal),
    "GET /api/proposals/{fingerprint}/alternatives": (OtherWays,),
    "GET /api/proposals/{fingerprint}/steps/{number:int}/why": (Why,),
    "GET /api/manual/{target}": (ByHand,),
    "GET /api/runs": (Runs,),
    "GET /api/runs/{run}": (RunRecord,),
    "GET /api/runs/{run}/replay": (ReplayRecord,),
    "GET /api/schedule": (Schedule,),
    "GET /api/graph": (Graph,),
    "GET /api/audit": (Audit,),
    "GET /api/health": (Health,),
    "POST /api/decisions": (Recorded,),
    "POST /api/hold": (HoldAnswer,),
}
"""What a success of each JSON route is, or one of two; all others are a `Refusal`."""

NEWS: tuple[type, ...] = (RunState, RunEvent, CaughtUp)
"""What a WebSocket tells."""

__all__ = ["ANSWERS", "NEWS", "Refusal"]
