"""Where a server is reached: every address that it answers to, and no other."""

from __future__ import annotations

from dataclasses import dataclass

LOOPBACK = ("127.0.0.1", "localhost")
_USUAL_PORT = {"http": 80, "https": 443}


@dataclass(frozen=True, slots=True, kw_only=True)
class Place:
    """Scheme, names and port of a server.

    Attributes:
        names: As they stand in an address; the first is told to people.
        is_secure: Reached by TLS.
    """

    port: int
    names: tuple[str, ...] = LOOPBACK
    is_secure: bool = False

    @property
    def scheme(self) -> str:
        """Of its addresses."""
        return "https" if self.is_secure else "http"

    @property
    def hosts(self) -> frozenset[str]:
        """What a request may name as its host; browsers leave the usual port out."""
        with_port = {f"{name}:{self.port}" for name in self.names}
        is_usual = self.port == _USUAL_PORT[self.scheme]
        return frozenset(with_port | (set(self.names) if is_usual else set()))

    @property
    def origin(self) -> str:
        """The address that is told to people."""
        return f"{self.scheme}://{self.names[0]}:{self.port}"
