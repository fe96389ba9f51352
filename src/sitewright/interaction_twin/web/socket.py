"""The WebSocket: a ticket, then missed events in order, then news and frames."""

from __future__ import annotations

import asyncio
import contextlib
import json

from starlette.websockets import WebSocket, WebSocketDisconnect

from sitewright.interaction_twin.web.hub import Hub, Listener, text_of
from sitewright.interaction_twin.web.sessions import Sessions
from sitewright.interaction_twin.web.twin import Twin

MOST_PAGES = 64
_TICKET_WAIT_S = 5.0
_NO_TICKET, _TOO_MANY, _TOO_SLOW, _TALKS = 4401, 4429, 1013, 1008
_MOST_MESSAGES = 50


class Socket:
    """Serves one page at a time; each call is one connection."""

    def __init__(self, twin: Twin, sessions: Sessions, hub: Hub) -> None:
        self._twin, self._sessions, self._hub = twin, sessions, hub

    async def serve(self, socket: WebSocket) -> None:
        """Take a page in, send until it leaves."""
        await socket.accept()
        if self._hub.size >= MOST_PAGES:
            await socket.close(_TOO_MANY, "too many pages")
            return
        hello = await _first_message(socket)
        if hello is None or self._sessions.use_ticket(str(hello.get("ticket", ""))) is None:
            await _close(socket, _NO_TICKET, "ticket")
            return
        listener = Listener()
        self._catch_up(listener, hello)
        self._hub.join(listener)
        sender = asyncio.create_task(_send(socket, listener))
        try:
            await self._listen(socket, listener, sender)
        finally:
            self._hub.leave(listener)
            sender.cancel()
            with contextlib.suppress(asyncio.CancelledError, Exception):
                await sender

    def _catch_up(self, listener: Listener, hello: dict[str, object]) -> None:
        """Queue what was missed, in a page's language; nothing is awaited, so nothing is lost."""
        after, language = hello.get("after"), hello.get("lang")
        if isinstance(language, str):
            listener.language = language
        if isinstance(after, dict):
            run, number = str(after.get("run", "")), after.get("n", 0)
            is_number = isinstance(number, int) and not isinstance(number, bool)
            for event in self._twin.events_after(
                run, number if is_number else 0, listener.language
            ):
                listener.texts.append(text_of(event))
        run, number = self._twin.last_event()
        listener.texts.append(text_of({"type": "caught-up", "run": run, "n": number}))
        listener.texts.append(text_of(self._twin.state(listener.language)))
        listener.bell.set()

    async def _listen(
        self, socket: WebSocket, listener: Listener, sender: asyncio.Task[None]
    ) -> None:
        """Wait until the page leaves; it may ask for another language, and for nothing else."""
        heard = 0
        while True:
            receiving = asyncio.ensure_future(socket.receive())
            done, _ = await asyncio.wait({receiving, sender}, return_when=asyncio.FIRST_COMPLETED)
            if sender in done:
                receiving.cancel()
                return
            message = receiving.result()
            if message["type"] == "websocket.disconnect":
                return
            heard += 1
            if heard > _MOST_MESSAGES:
                await _close(socket, _TALKS, "decisions go by POST")
                return
            wish = _read(message.get("text"))
            if wish is not None:
                self._catch_up(listener, wish)


async def _first_message(socket: WebSocket) -> dict[str, object] | None:
    try:
        text = await asyncio.wait_for(socket.receive_text(), _TICKET_WAIT_S)
    except (TimeoutError, KeyError, WebSocketDisconnect):
        return None
    return _read(text)


def _read(text: object) -> dict[str, object] | None:
    """Return what a page says, if it is an object."""
    try:
        found = json.loads(text) if isinstance(text, str) else None
    except ValueError:
        return None
    return found if isinstance(found, dict) else None


async def _send(socket: WebSocket, listener: Listener) -> None:
    """Send one thing after the other: whatever is slow holds up only this page."""
    while not listener.is_behind:
        news = await listener.next()
        if isinstance(news, str):
            await socket.send_text(news)
        else:
            await socket.send_bytes(news)
    await _close(socket, _TOO_SLOW, "too far behind; come back and ask for what you missed")


async def _close(socket: WebSocket, code: int, reason: str) -> None:
    with contextlib.suppress(RuntimeError, WebSocketDisconnect):
        await socket.close(code, reason)
