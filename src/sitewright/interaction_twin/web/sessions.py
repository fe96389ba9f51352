"""Sign-in: a one-time token becomes a signed cookie; tickets open one WebSocket each."""

from __future__ import annotations

import base64
import hashlib
import hmac
import json
import secrets
from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.foundation.clock import Clock
from sitewright.interaction_twin.roles import Person, Role

SESSION_S = 12 * 3600
TICKET_S = 30
_NS = 1_000_000_000
_PURPOSE = b"sitewright-session/1"


@dataclass(frozen=True, slots=True, kw_only=True)
class User:
    """Somebody with a token of his own.

    Attributes:
        token_sha256: Of a token of 256 random bits; the token itself is kept nowhere.
        pin_scrypt: Salt and hash of the PIN; empty if there is none.
    """

    name: str
    role: Role
    token_sha256: str
    pin_scrypt: str = ""


@dataclass
class Sessions:
    """Who is signed in; sessions are signed, so that they outlive the server.

    Attributes:
        key: Of this installation.
        users: By name; empty if there is only the one local user. Where people have names,
            nobody is local: one person would count as two.
        local_role: Role of whoever opens the link that the server printed.
        one_time: Tokens that were printed and not used yet.
        program_sha256: Of the token by which this user's own programs decide; empty if none may.
    """

    key: bytes
    clock: Clock
    users: Mapping[str, User] = field(default_factory=dict)
    local_role: Role = Role.ADMIN
    one_time: set[str] = field(default_factory=set)
    program_sha256: str = ""
    _tickets: dict[str, tuple[Person, int]] = field(default_factory=dict)

    def invite(self) -> str:
        """Return a token that signs in one time."""
        token = secrets.token_urlsafe(32)
        self.one_time.add(token)
        return token

    def program_token(self) -> str:
        """Return a token for programs of whoever started the server; it ends with the server."""
        token = secrets.token_urlsafe(32)
        self.program_sha256 = _sha256(token)
        return token

    def sign_in(self, user: str, token: str) -> Person | None:
        """Return who a token belongs to; None if it is wrong or was used before."""
        session = secrets.token_hex(8)
        known = self.users.get(user)
        if user and known is not None:
            is_right = hmac.compare_digest(_sha256(token), known.token_sha256)
            return Person(who=user, role=known.role, session=session) if is_right else None
        if user or self.users or token not in self.one_time:
            return None
        self.one_time.discard(token)
        return Person(who="local", role=self.local_role, session=session)

    def cookie_of(self, person: Person) -> str:
        """Return a signed value that says who it is until it expires."""
        facts = {
            "who": person.who,
            "role": person.role,
            "session": person.session,
            "until": self.clock.utc_ns() // _NS + SESSION_S,
        }
        text = base64.urlsafe_b64encode(json.dumps(facts).encode()).decode()
        return f"{text}.{self._mac(text)}"

    def person_of(self, cookie: str) -> Person | None:
        """Return whose cookie it is; None if it is forged, too old, or the user has gone."""
        text, _, mac = cookie.partition(".")
        if not hmac.compare_digest(mac, self._mac(text)):
            return None
        facts = json.loads(base64.urlsafe_b64decode(text))
        if facts["until"] < self.clock.utc_ns() // _NS:
            return None
        person = Person(who=facts["who"], role=Role(facts["role"]), session=facts["session"])
        if self.users:
            known = self.users.get(person.who)
            return person if known is not None and known.role is person.role else None
        return person

    def person_of_token(self, bearer: str) -> Person | None:
        """Return whose own token it is (``Authorization: Bearer``)."""
        digest = _sha256(bearer)
        if self.program_sha256 and hmac.compare_digest(digest, self.program_sha256):
            return Person(who="local", role=self.local_role, session="command-line")
        for user in self.users.values():
            if hmac.compare_digest(digest, user.token_sha256):
                return Person(who=user.name, role=user.role, session=f"token-{digest[:8]}")
        return None

    def ticket_for(self, person: Person) -> str:
        """Return a ticket that opens one WebSocket within half a minute."""
        now_s = self.clock.monotonic_ns() // _NS
        self._tickets = {t: (p, end) for t, (p, end) in self._tickets.items() if end >= now_s}
        ticket = secrets.token_urlsafe(24)
        self._tickets[ticket] = (person, now_s + TICKET_S)
        return ticket

    def use_ticket(self, ticket: str) -> Person | None:
        """Return whose ticket it is, and let it go."""
        person, end_s = self._tickets.pop(ticket, (None, 0))
        return person if end_s >= self.clock.monotonic_ns() // _NS else None

    def _mac(self, text: str) -> str:
        key = hmac.new(self.key, _PURPOSE, hashlib.sha256).digest()
        return hmac.new(key, text.encode(), hashlib.sha256).hexdigest()


def _sha256(token: str) -> str:
    return hashlib.sha256(token.encode()).hexdigest()
