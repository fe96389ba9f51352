"""The server's side of the pipe: starts the process of the run, asks it, hears what happens."""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import sys
from collections.abc import Callable, Mapping, Sequence
from itertools import count
from typing import Protocol

from sitewright.app.serving.channel import Message, line_of
from sitewright.foundation.canonical import Json
from sitewright.foundation.sentence import Sentence
from sitewright.interaction_twin.decisions import Reply, no_run

_LONGEST_LINE = 4_000_000
_ANSWER_S = 120.0
_END_S = 20.0
Hear = Callable[[Message], None]


class RunLink(Protocol):
    """The process of a run as the server sees it."""

    async def start(self, hear: Hear, *, waits: bool = False) -> None:
        """Start it; from then on `hear` gets all that it says but its replies.

        Args:
            hear: Gets what happens, and that it is gone.
            waits: It goes on only when somebody says so, whatever the journal says.
        """
        ...

    async def ask(self, what: str, content: Mapping[str, Json]) -> Reply:
        """Send a message and wait for its reply."""
        ...

    async def stop(self) -> None:
        """Let it hold and end."""
        ...

    @property
    def process_id(self) -> int | None:
        """Of the process; None if it is not there."""
        ...


class PipeLink:
    """Messages over two streams; replies find those who asked by their numbers."""

    def __init__(self) -> None:
        self._writer: asyncio.StreamWriter | None = None
        self._waiting: dict[str, asyncio.Future[Reply]] = {}
        self._numbers = count(1)
        self._listening: asyncio.Task[None] | None = None

    async def listen_to(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, hear: Hear
    ) -> None:
        """Begin to hear what comes."""
        self._writer = writer
        self._listening = asyncio.create_task(self._listen(reader, hear))

    async def ask(self, what: str, content: Mapping[str, Json]) -> Reply:
        """Send a message and wait for its reply; a process that is gone is a 503."""
        writer = self._writer
        if writer is None or writer.is_closing():
            return no_run(
                Sentence("The process of the run is not there. Start `sitewright serve` again.")
            )
        number = str(next(self._numbers))
        reply: asyncio.Future[Reply] = asyncio.get_running_loop().create_future()
        self._waiting[number] = reply
        try:
            writer.write(line_of({"do": what, "id": number, **content}))
            await writer.drain()
            return await asyncio.wait_for(reply, _ANSWER_S)
        except (OSError, TimeoutError):
            return no_run(Sentence("The process of the run does not answer; nothing is known."))
        finally:
            self._waiting.pop(number, None)

    async def hang_up(self) -> None:
        """Close the pipe: the other side holds and ends."""
        if self._writer is not None:
            self._writer.close()
            with contextlib.suppress(OSError):
                await self._writer.wait_closed()
        if self._listening is not None:
            await asyncio.wait({self._listening}, timeout=_END_S)
            self._listening.cancel()

    async def _listen(self, reader: asyncio.StreamReader, hear: Hear) -> None:
        while line := await reader.readline():
            message = json.loads(line)
            if message["is"] == "reply":
                self._pass_on(message)
            else:
                hear(message)
        self._writer = None
        for reply in self._waiting.values():
            if not reply.done():
                reply.set_result(
                    no_run(Sentence("The process of the run ended; nothing is known."))
                )
        hear({"is": "run", "what": "gone"})

    def _pass_on(self, message: Mapping[str, Json]) -> None:
        reply = self._waiting.get(str(message["id"]))
        status, body = message["status"], message["body"]
        if reply is not None and not reply.done():
            assert isinstance(status, int)  # noqa: S101 -- our own process
            assert isinstance(body, Mapping)  # noqa: S101
            reply.set_result(Reply(status=status, body=body))


class RunProcess:
    """The run in a process of its own, so that the event loop never plans."""

    def __init__(self, arguments: Sequence[str]) -> None:
        """Prepare it.

        Args:
            arguments: Of `sitewright.app.serving.process`.
        """
        self._arguments = tuple(arguments)
        self._link = PipeLink()
        self._process: asyncio.subprocess.Process | None = None

    @property
    def process_id(self) -> int | None:
        """Of the process; None if it is not there."""
        alive = self._process is not None and self._process.returncode is None
        return self._process.pid if alive and self._process is not None else None

    async def start(self, hear: Hear, *, waits: bool = False) -> None:
        """Start the process, or a new one after it has gone."""
        self._link = PipeLink()
        self._process = await asyncio.create_subprocess_exec(
            sys.executable,
            "-m",
            "sitewright.app.serving.process",
            *self._arguments,
            *(("--waits",) if waits else ()),
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            limit=_LONGEST_LINE,
            env={**os.environ, "PYTHONUNBUFFERED": "1"},
            start_new_session=True,
        )
        assert self._process.stdout is not None  # noqa: S101 -- piped above
        assert self._process.stdin is not None  # noqa: S101
        await self._link.listen_to(self._process.stdout, self._process.stdin, hear)

    async def ask(self, what: str, content: Mapping[str, Json]) -> Reply:
        """Send a message and wait for its reply."""
        return await self._link.ask(what, content)

    async def stop(self) -> None:
        """Let it hold and end; one that does not is killed, the journal is whole either way."""
        await self._link.hang_up()
        if self._process is None:
            return
        try:
            await asyncio.wait_for(self._process.wait(), _END_S)
        except TimeoutError:
            self._process.kill()
            await self._process.wait()
