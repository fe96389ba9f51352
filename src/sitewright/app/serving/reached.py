"""Where a server listens and is reached: this machine alone, or an address with TLS."""

from __future__ import annotations

import ipaddress
import socket
import ssl
from dataclasses import dataclass
from pathlib import Path

from sitewright.errors import BackendError
from sitewright.interaction_twin.web.place import LOOPBACK, Place


@dataclass(frozen=True, slots=True)
class Tls:
    """Files of a certificate (PEM, with its chain) and of its key."""

    certificate: Path
    key: Path

    def fault(self) -> str:
        """Return why they cannot be used; empty if they can."""
        try:
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            context.load_cert_chain(self.certificate, self.key, password=lambda: "")
        except (OSError, ValueError) as error:
            return f"{self.certificate} and {self.key} are no certificate with its key: {error}"
        return ""


def host_fault(host: str) -> str:
    """Return why no page can be reached under a host; empty if one can."""
    try:
        if ipaddress.ip_address(host).is_unspecified:
            return f"{host} stands for every address; give the one under which tablets come."
    except ValueError:
        letters = host.replace("-", "").replace(".", "")
        if not (letters.isascii() and letters.isalnum()):
            return f"{host!r} is no address and no name of a machine."
    return ""


def place_of(host: str | None, port: int, *, is_secure: bool) -> Place:
    """Return where a server is reached; None as host is this machine alone."""
    names = LOOPBACK if host is None else (f"[{host}]" if ":" in host else host.lower(),)
    return Place(port=port, names=names, is_secure=is_secure)


def listening(host: str | None, port: int) -> socket.socket:
    """Return a socket that listens; 0 takes a free port.

    Raises:
        BackendError: The host is not one of this machine's, or the port is taken.
    """
    name = LOOPBACK[0] if host is None else host
    try:
        found = socket.getaddrinfo(name, port, type=socket.SOCK_STREAM)
    except OSError as error:
        raise BackendError(f"No address belongs to the host {name}: {error.strerror}.") from error
    family, kind, protocol, _, address = found[0]
    listener = socket.socket(family, kind, protocol)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind(address)
    except OSError as error:
        listener.close()
        raise BackendError(
            f"Port {port} of {name} cannot be taken ({error.strerror}). Give another one with "
            "--port, or --port 0 for any free one; --host must be an address of this machine."
        ) from error
    return listener
