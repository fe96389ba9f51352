"""The pages that are connected: each gets every text in order, and of the frames the newest."""

from __future__ import annotations

import asyncio
import json
from collections import deque
from dataclasses import dataclass, field

from sitewright.interaction_twin.web.twin import Document, News

MOST_UNSENT_BYTES = 1_000_000
"""A page that is further behind is closed; it comes back and asks for what it missed."""


def text_of(news: Document) -> str:
    """Return a document as it goes over the wire."""
    return json.dumps(news, ensure_ascii=False, allow_nan=False, separators=(",", ":"))


@dataclass(eq=False)
class Listener:
    """One page: its unsent texts, the newest frame of each kind, and a bell.

    Attributes:
        is_behind: So much is unsent that it is better closed.
        language: In which it reads.
    """

    texts: deque[str] = field(default_factory=deque)
    frames: dict[int, bytes] = field(default_factory=dict)
    bell: asyncio.Event = field(default_factory=asyncio.Event)
    is_behind: bool = False
    language: str = "en"
    _unsent: int = 0

    def tell(self, text: str) -> None:
        """Queue a text."""
        self.texts.append(text)
        self._unsent += len(text)
        self.is_behind = self.is_behind or self._unsent > MOST_UNSENT_BYTES
        self.bell.set()

    def show(self, frame: bytes) -> None:
        """Replace the unsent frame of the same kind."""
        self.frames[frame[0]] = frame
        self.bell.set()

    async def next(self) -> str | bytes:
        """Wait for what is to be sent next: texts first."""
        while True:
            if self.texts:
                text = self.texts.popleft()
                self._unsent -= len(text)
                return text
            if self.frames:
                return self.frames.pop(min(self.frames))
            self.bell.clear()
            await self.bell.wait()


class Hub:
    """All listeners of a server."""

    def __init__(self) -> None:
        self._listeners: set[Listener] = set()

    @property
    def size(self) -> int:
        """How many pages are connected."""
        return len(self._listeners)

    def join(self, listener: Listener) -> None:
        """Let a page hear all that comes from now on."""
        self._listeners.add(listener)

    def leave(self, listener: Listener) -> None:
        """Let a page go."""
        self._listeners.discard(listener)

    def tell(self, news: News) -> None:
        """Send a text to all, encoded once for each language that somebody reads."""
        texts: dict[str, str] = {}
        for listener in self._listeners:
            language = listener.language
            if language not in texts:
                texts[language] = text_of(news(language))
            listener.tell(texts[language])

    def show(self, frame: bytes) -> None:
        """Send a frame to all; the slow ones get the newest only."""
        for listener in self._listeners:
            listener.show(frame)
