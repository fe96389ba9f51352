"""The ASGI application: the gate, the interface by its table, the WebSocket, the page's files."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from pathlib import Path

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import FileResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp

from sitewright.interaction_twin.decisions import refusal
from sitewright.interaction_twin.web.api import Api, answer
from sitewright.interaction_twin.web.gate import Gate
from sitewright.interaction_twin.web.hub import Hub
from sitewright.interaction_twin.web.pins import Pins
from sitewright.interaction_twin.web.place import Place
from sitewright.interaction_twin.web.requests import BadRequestError
from sitewright.interaction_twin.web.routes import ROUTES, ApiRoute
from sitewright.interaction_twin.web.sessions import Sessions
from sitewright.interaction_twin.web.socket import Socket
from sitewright.interaction_twin.web.twin import Twin

STATIC = Path(__file__).parent / "static"
Endpoint = Callable[[Request], Awaitable[Response]]


def application(
    twin: Twin,
    sessions: Sessions,
    hub: Hub,
    *,
    place: Place,
    pins: Pins | None = None,
) -> ASGIApp:
    """Return the whole server.

    Args:
        twin: The world behind it.
        sessions: Who is signed in.
        hub: The pages that are connected.
        place: Where it is reached.
        pins: Names who decides; None if whoever is signed in does.
    """
    api = Api(twin, sessions, place, pins)
    socket = Socket(twin, sessions, hub)
    routes = [Route(r.path, _endpoint(api, r), methods=[r.method]) for r in ROUTES]
    app = Starlette(
        routes=[
            *routes,
            WebSocketRoute("/ws", socket.serve),
            Route("/", _page),
            Mount("/static", StaticFiles(directory=STATIC, check_dir=False)),
        ],
    )
    return Gate(app, place)


def _endpoint(api: Api, route: ApiRoute) -> Endpoint:
    """Return the handler of a route behind its policy."""
    handler = getattr(api, route.handler)
    needed = route.policy.needs

    async def endpoint(request: Request) -> Response:
        person = api.person_behind(request)
        if needed is not None and person is None:
            message = "Nobody is signed in. Open the link that `sitewright serve` printed."
            return answer(refusal(401, "session", message))
        if needed is not None and person is not None and not person.role.may(needed):
            message = f"Only a person with the role {needed.value} (or higher) may do this."
            return answer(refusal(403, "role", message, needs=needed.value))
        try:
            response: Response = await handler(request, person)
        except BadRequestError as error:
            return answer(error.reply)
        return response

    return endpoint


async def _page(request: Request) -> Response:
    del request
    index = STATIC / "index.html"
    if not index.exists():
        message = "This installation has no page; the interface under /api works."
        return answer(refusal(404, "unknown", message))
    return FileResponse(index, headers={"cache-control": "no-cache"})
