"""Messages between the server and the process of its run: one JSON document per line."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from threading import Lock
from typing import BinaryIO

from sitewright.foundation.canonical import Json

Message = Mapping[str, Json]


class Channel:
    """The run's side of the pipe; sending is safe from any thread."""

    def __init__(self, reader: BinaryIO, writer: BinaryIO) -> None:
        self._reader, self._writer, self._lock = reader, writer, Lock()

    def send(self, message: Message) -> None:
        """Send a message; a server that is gone hears nothing more."""
        with self._lock:
            try:
                self._writer.write(line_of(message))
                self._writer.flush()
            except (BrokenPipeError, ValueError):
                return

    def close(self) -> None:
        """End the pipe: the server learns that nobody is here any more."""
        with self._lock:
            self._writer.close()
            self._reader.close()

    def messages(self) -> Iterator[Message]:
        """Return what the server sends, until it is gone."""
        for line in self._reader:
            if line.endswith(b"\n"):
                yield json.loads(line)


def line_of(message: Message) -> bytes:
    """Return a message as it goes through the pipe."""
    return json.dumps(message, ensure_ascii=False, allow_nan=False).encode() + b"\n"
