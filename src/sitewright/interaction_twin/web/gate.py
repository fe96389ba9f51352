"""The gate before everything: exact Host and Origin, small bodies, JSON only, strict headers.

Pure ASGI, for HTTP and for WebSockets before they are accepted: what the usual CORS and host
middleware let through (a page on another local port, a foreign Origin on a socket) stops here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from starlette.datastructures import MutableHeaders
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.web.place import Place

MOST_BODY_BYTES = 1_000_000
_SAFE = ("GET", "HEAD")
_HEADERS: Mapping[str, str] = {
    "content-security-policy": (
        "default-src 'self'; connect-src 'self' blob:; img-src 'self' blob: data:; "
        "base-uri 'none'; frame-ancestors 'none'; form-action 'none'"
    ),
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
}


@dataclass(frozen=True, slots=True)
class _No:
    status: int
    error: str
    message: str

    def body(self) -> Mapping[str, Json]:
        return {"error": self.error, "message": self.message}


class Gate:
    """Lets in what comes from the server's own page, and programs with a token of their own."""

    def __init__(self, app: ASGIApp, place: Place) -> None:
        """Guard an application.

        Args:
            app: What is guarded.
            place: Where the server is reached.
        """
        self._app, self._place = app, place

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it before anybody looks at it."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        no = self._objection(scope)
        if scope["type"] == "websocket":
            if no is not None:
                await receive()
                await send({"type": "websocket.close", "code": 1008, "reason": no.error})
                return
            await self._app(scope, receive, send)
            return
        is_file = not scope["path"].startswith("/api")
        answer = _with_headers(send, "no-cache" if is_file else "no-store")
        if no is not None:
            await JSONResponse(no.body(), no.status)(scope, receive, answer)
            return
        await self._app(scope, _bounded(receive), answer)

    def _objection(self, scope: Scope) -> _No | None:
        headers = _headers(scope)
        host = headers.get("host", [])
        if len(host) != 1 or host[0] not in self._place.hosts:
            return _No(403, "host", "This server is reached under its own address only.")
        own = f"{self._place.scheme}://{host[0]}"
        return _of_origin(scope, headers, own) or _of_body(scope, headers)


def _of_origin(scope: Scope, headers: Mapping[str, list[str]], own: str) -> _No | None:
    foreign = _No(403, "origin", "This request comes from another page.")
    origin = headers.get("origin", [])
    if origin:
        return None if origin == [own] else foreign
    if headers.get("sec-fetch-site", ["none"]) not in (["none"], ["same-origin"]):
        return foreign
    is_change = scope["type"] == "websocket" or scope["method"] not in _SAFE
    if is_change and "cookie" in headers:
        return foreign
    return None


def _of_body(scope: Scope, headers: Mapping[str, list[str]]) -> _No | None:
    if scope["type"] != "http" or scope["method"] in _SAFE:
        return None
    kind = headers.get("content-type", [""])[0].split(";")[0].strip().lower()
    if kind != "application/json":
        return _No(415, "content-type", "Only application/json is taken.")
    length = headers.get("content-length", ["0"])[0]
    if not length.isdigit() or int(length) > MOST_BODY_BYTES:
        return _No(413, "too-large", f"A request holds at most {MOST_BODY_BYTES} bytes.")
    return None


def _headers(scope: Scope) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for name, value in scope["headers"]:
        found.setdefault(name.decode("latin-1").lower(), []).append(value.decode("latin-1"))
    return found


def _bounded(receive: Receive) -> Receive:
    """Return a `receive` that breaks off a body that is longer than it may be."""
    size = 0

    async def bounded() -> Message:
        nonlocal size
        message = await receive()
        size += len(message.get("body", b""))
        if size > MOST_BODY_BYTES:
            return {"type": "http.disconnect"}
        return message

    return bounded


def _with_headers(send: Send, caching: str) -> Send:
    """Return a `send` that adds what every answer says; files may be kept, and asked for anew."""

    async def with_headers(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in _HEADERS.items():
                headers.setdefault(name, value)
            headers.setdefault("cache-control", caching)
        await send(message)

    return with_headers
