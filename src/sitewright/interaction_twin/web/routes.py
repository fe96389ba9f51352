"""All routes with their policies: a route without one cannot be written down."""

from __future__ import annotations

from dataclasses import dataclass

from sitewright.interaction_twin.roles import Role


@dataclass(frozen=True, slots=True, kw_only=True)
class Policy:
    """Who may use a route.

    Attributes:
        needs: The lowest role; None is open to whoever passes the gate (to sign in).
        by_verb: The body's verb asks for a role of its own.
    """

    needs: Role | None
    by_verb: bool = False


@dataclass(frozen=True, slots=True)
class ApiRoute:
    """One route of the interface.

    Attributes:
        handler: Name of the method of `Api` that answers.
    """

    method: str
    path: str
    handler: str
    policy: Policy


_OPEN = Policy(needs=None)
_LOOK = Policy(needs=Role.VIEWER)

ROUTES: tuple[ApiRoute, ...] = (
    ApiRoute("POST", "/api/session", "sign_in", _OPEN),
    ApiRoute("GET", "/api/session", "who_am_i", _LOOK),
    ApiRoute("DELETE", "/api/session", "sign_out", _LOOK),
    ApiRoute("POST", "/api/ws-ticket", "ticket", _LOOK),
    ApiRoute("GET", "/api/state", "state", _LOOK),
    ApiRoute("GET", "/api/scene", "scene", _LOOK),
    ApiRoute("GET", "/api/proposals/{fingerprint}", "proposal", _LOOK),
    ApiRoute("GET", "/api/proposals/{fingerprint}/alternatives", "ways", _LOOK),
    ApiRoute("GET", "/api/proposals/{fingerprint}/steps/{number:int}/why", "why", _LOOK),
    ApiRoute("GET", "/api/proposals/{fingerprint}/schedule.svg", "plan_schedule", _LOOK),
    ApiRoute("GET", "/api/manual/{target}", "manual", _LOOK),
    ApiRoute("GET", "/api/blobs/{sha256}", "blob", _LOOK),
    ApiRoute("GET", "/api/runs", "runs", _LOOK),
    ApiRoute("GET", "/api/runs/{run}", "run", _LOOK),
    ApiRoute("GET", "/api/runs/{run}/replay", "replay", _LOOK),
    ApiRoute("GET", "/api/runs/{run}/report", "report", _LOOK),
    ApiRoute("GET", "/api/runs/{run}/schedule.svg", "run_schedule", _LOOK),
    ApiRoute("GET", "/api/schedule", "schedule", _LOOK),
    ApiRoute("GET", "/api/graph", "graph", _LOOK),
    ApiRoute("GET", "/api/graph.svg", "graph_picture", _LOOK),
    ApiRoute("GET", "/api/audit", "audit", _LOOK),
    ApiRoute("GET", "/api/health", "health", _LOOK),
    ApiRoute("POST", "/api/decisions", "decide", Policy(needs=Role.VIEWER, by_verb=True)),
    ApiRoute("POST", "/api/hold", "hold", _LOOK),
)
