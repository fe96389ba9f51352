"""The door for programs: a private file in the project that says where its server is.

``runs/server.json``, readable by nobody else, is there as long as the server is. It holds the
address, the certificate to expect, and, where people have no tokens of their own, a token that is
good until the server ends.
"""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

from sitewright.errors import BackendError

NAME = "server.json"


@dataclass(frozen=True, slots=True, kw_only=True)
class Door:
    """Where a project's server is, for programs on this machine.

    Attributes:
        origin: Scheme, host and port.
        token: Of whoever started the server; empty if people have tokens of their own.
        certificate: File that its certificate must be in; empty without TLS.
    """

    origin: str
    token: str = ""
    certificate: str = ""


@contextlib.contextmanager
def opened(runs: Path, door: Door) -> Iterator[None]:
    """Keep a door while the server runs."""
    runs.mkdir(parents=True, exist_ok=True)
    file, draft = runs / NAME, runs / f"{NAME}.new"
    draft.unlink(missing_ok=True)
    text = json.dumps(asdict(door), indent=1)
    with os.fdopen(os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as private:
        private.write(text)
    draft.rename(file)
    try:
        yield
    finally:
        with contextlib.suppress(OSError):
            if file.read_text(encoding="utf-8") == text:  # not that of a server that came after
                file.unlink()


def door_of(project: Path) -> Door:
    """Return where the server of a project is.

    Raises:
        BackendError: None runs, as far as the project knows.
    """
    try:
        return Door(**json.loads((project / "runs" / NAME).read_text(encoding="utf-8")))
    except FileNotFoundError as error:
        raise no_server(project) from error
    except (OSError, ValueError, TypeError) as error:
        raise BackendError(f"{project / 'runs' / NAME} cannot be read: {error}") from error


def no_server(project: Path) -> BackendError:
    """Return the error of a project that nobody serves."""
    return BackendError(
        f"No server serves {project}. Start one with `sitewright serve {project}`; decisions "
        "from the command line go through it."
    )
