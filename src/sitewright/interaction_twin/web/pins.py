"""Who decides at a shared tablet: each decision names a person and carries his PIN.

A PIN is short, so it is kept as a salted scrypt hash, and a few wrong ones lock the name for a
while. It is in no record and in no hash of a record.
"""

from __future__ import annotations

import asyncio
import hashlib
import hmac
import secrets
from collections.abc import Mapping
from dataclasses import dataclass

from sitewright.foundation.clock import Clock
from sitewright.interaction_twin.decisions import Reply, refusal
from sitewright.interaction_twin.roles import Person
from sitewright.interaction_twin.web.sessions import User

MOST_WRONG = 5
LOCKED_S = 300
_AT_ONCE = 2
_N, _R, _P = 2**14, 8, 1
_NS = 1_000_000_000


def pin_hash(pin: str, salt: bytes) -> str:
    """Return what is kept of a PIN: salt and scrypt hash in hex."""
    digest = hashlib.scrypt(pin.encode(), salt=salt, n=_N, r=_R, p=_P, dklen=32)
    return f"{salt.hex()}${digest.hex()}"


def new_pin_hash(pin: str) -> str:
    """Return the hash of a PIN with a salt of its own."""
    return pin_hash(pin, secrets.token_bytes(16))


@dataclass(slots=True)
class _Tries:
    """Wrong PINs in a row for a name, and until when it is locked."""

    wrong: int = 0
    locked_until_ns: int = 0


class Pins:
    """Tells who decides by name and PIN."""

    def __init__(self, users: Mapping[str, User], clock: Clock) -> None:
        self._users = {u.name: u for u in users.values() if u.pin_scrypt}
        self._clock = clock
        self._tries = {name: _Tries() for name in self._users}
        self._turn = asyncio.Semaphore(_AT_ONCE)
        self._nobodys = new_pin_hash("")

    @property
    def people(self) -> tuple[str, ...]:
        """Names of those who have a PIN."""
        return tuple(sorted(self._users))

    async def person(self, name: str, pin: str, session: str) -> Person | Reply:
        """Return whose PIN it is, or the "no"; a wrong name takes as long as a wrong PIN."""
        tries, now_ns = self._tries.get(name, _Tries()), self._clock.monotonic_ns()
        if now_ns < tries.locked_until_ns:
            return _locked(name, (tries.locked_until_ns - now_ns) // _NS + 1)
        user = self._users.get(name)
        kept = self._nobodys if user is None else user.pin_scrypt
        salt = bytes.fromhex(kept.partition("$")[0])
        async with self._turn:
            given = await asyncio.to_thread(pin_hash, pin, salt)
        if user is not None and hmac.compare_digest(given, kept):
            tries.wrong = 0
            return Person(who=name, role=user.role, session=session)
        tries.wrong += 1
        if tries.wrong >= MOST_WRONG:
            tries.wrong, tries.locked_until_ns = 0, now_ns + LOCKED_S * _NS
        return refusal(403, "pin", "The name or the PIN is wrong; nothing was done.")


def _locked(name: str, wait_s: int) -> Reply:
    message = f"Too many wrong PINs for {name}; nobody can decide under this name for {wait_s} s."
    return refusal(429, "pin-locked", message, wait_s=wait_s)
