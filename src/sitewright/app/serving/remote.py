"""Decisions from the command line: the page's own interface, asked by a program."""

from __future__ import annotations

import http.client
import json
import os
import secrets
import ssl
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from sitewright.app.serving.door import Door, door_of, no_server
from sitewright.errors import ApprovalError, BackendError, ExecutionError

TOKEN = "SITEWRIGHT_TOKEN"  # noqa: S105 -- the name of a variable
_ANSWER_S = 130.0
_OK, _NOTED, _BROKEN = 200, 202, 500
Document = dict[str, Any]


class Remote:
    """The server of a project, as a program on this machine reaches it."""

    def __init__(self, project: Path) -> None:
        """Find the server.

        Raises:
            BackendError: None runs.
            ApprovalError: Its people have tokens of their own, and none was given.
        """
        self._project, self._door = project, door_of(project)
        self._token = os.environ.get(TOKEN) or self._door.token
        if not self._token:
            raise ApprovalError(
                f"The people of this server have tokens of their own; put yours into {TOKEN}."
            )

    def get(self, path: str) -> Document:
        """Return what a route tells.

        Raises:
            SitewrightError: It refuses, or nobody answers.
        """
        return self._told(*self._ask("GET", path, None))

    def decide(self, path: str, body: Mapping[str, object]) -> Document:
        """Send a decision under a key of its own; it returns when it is recorded.

        Raises:
            ApprovalError: It is refused, or a second person must decide the same.
            ExecutionError: It could not be recorded.
            BackendError: Nobody answers.
        """
        status, told = self._ask("POST", path, {**body, "key": secrets.token_hex(16)})
        if status == _NOTED:
            raise ApprovalError(str(told["message"]))
        return self._told(status, told)

    def _told(self, status: int, told: Document) -> Document:
        if status == _OK:
            return told
        message = str(told.get("message") or f"The server answers {status}.")
        raise (ExecutionError if status >= _BROKEN else ApprovalError)(message)

    def _ask(
        self, method: str, path: str, body: Mapping[str, object] | None
    ) -> tuple[int, Document]:
        link = _connection(self._door)
        headers = {"authorization": f"Bearer {self._token}", "content-type": "application/json"}
        content = None if body is None else json.dumps(body)
        try:
            link.request(method, path, content, headers)
            answer = link.getresponse()
            return answer.status, json.loads(answer.read())
        except ConnectionRefusedError as error:  # it was killed, and left its door behind
            raise no_server(self._project) from error
        except (OSError, ValueError, http.client.HTTPException) as error:
            raise BackendError(
                f"The server at {self._door.origin} does not answer as it should: {error}"
            ) from error
        finally:
            link.close()


def _connection(door: Door) -> http.client.HTTPConnection:
    place = urlsplit(door.origin)
    host = place.hostname or ""
    if place.scheme == "http":
        return http.client.HTTPConnection(host, place.port, timeout=_ANSWER_S)
    trusted = ssl.create_default_context(cafile=door.certificate)
    trusted.verify_flags |= ssl.VerifyFlags.VERIFY_X509_PARTIAL_CHAIN  # it is the very certificate
    return http.client.HTTPSConnection(host, place.port, timeout=_ANSWER_S, context=trusted)
