"""The handlers of all routes: read what was sent, ask the twin, answer in one form."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from starlette.requests import Request
from starlette.responses import JSONResponse, Response

from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.decisions import Decision, Reply, body_hash, refusal
from sitewright.interaction_twin.languages import PHRASEBOOKS
from sitewright.interaction_twin.roles import NEEDED_ROLE, Person, Role, Verb
from sitewright.interaction_twin.web.pins import Pins
from sitewright.interaction_twin.web.place import Place
from sitewright.interaction_twin.web.requests import (
    BadRequestError,
    DecisionBody,
    HoldBody,
    Nothing,
    SignIn,
    decision_from,
    hold_from,
    read_body,
)
from sitewright.interaction_twin.web.sessions import SESSION_S, Sessions
from sitewright.interaction_twin.web.twin import Twin

LANGUAGES = tuple(PHRASEBOOKS)
_FOR_EVER = "private, max-age=31536000, immutable"
_OPEN = "open"
_NARROWEST_PX, _WIDEST_PX = 200, 4_000
_PICTURE_POLICY = "default-src 'none'; frame-ancestors 'none'"
_REPORT_POLICY = "default-src 'none'; style-src 'unsafe-inline'; frame-ancestors 'self'"


class Api:
    """Everything under ``/api``; each method answers one route of `ROUTES`."""

    def __init__(
        self, twin: Twin, sessions: Sessions, place: Place, pins: Pins | None = None
    ) -> None:
        self._twin, self._sessions, self._place, self._pins = twin, sessions, place, pins

    @property
    def cookie(self) -> str:
        """Name of the cookie: SameSite does not tell ports apart, so the name does."""
        return f"sitewright-{self._place.port}"

    # ---- who ---------------------------------------------------------------------------------

    def person_behind(self, request: Request) -> Person | None:
        """Return who sent a request: by cookie, or by a token of his own."""
        bearer = request.headers.get("authorization", "")
        if bearer.startswith("Bearer "):
            return self._sessions.person_of_token(bearer.removeprefix("Bearer "))
        cookie = request.cookies.get(self.cookie)
        return None if cookie is None else self._sessions.person_of(cookie)

    async def sign_in(self, request: Request, person: Person | None) -> Response:
        """Exchange a token for a cookie."""
        del person
        body = read_body(SignIn, await request.body())
        found = self._sessions.sign_in(body.user, body.token)
        if found is None:
            message = "This link or token is not valid, or was used before."
            return answer(refusal(401, "token", message))
        response = JSONResponse(self._about(found))
        response.set_cookie(
            self.cookie,
            self._sessions.cookie_of(found),
            max_age=SESSION_S,
            httponly=True,
            samesite="strict",
            secure=self._place.is_secure,
            path="/",
        )
        return response

    async def who_am_i(self, request: Request, person: Person) -> Response:
        """Tell name, role and what that role may do."""
        del request
        return JSONResponse(self._about(person))

    async def sign_out(self, request: Request, person: Person) -> Response:
        """Take the cookie back."""
        del request, person
        response = JSONResponse({"ok": True})
        response.delete_cookie(self.cookie, path="/", httponly=True, samesite="strict")
        return response

    async def ticket(self, request: Request, person: Person) -> Response:
        """Hand out a ticket for one WebSocket."""
        read_body(Nothing, await request.body())
        return JSONResponse({"ticket": self._sessions.ticket_for(person), "expires_s": 30})

    def _about(self, person: Person) -> Mapping[str, Any]:
        verbs = [v.value for v in Verb if self._pins or person.role.may(NEEDED_ROLE[v])]
        return {
            "asks_pin": self._pins is not None,
            "people": list(self._pins.people) if self._pins else [],
            "who": person.who,
            "role": person.role.value,
            "can": verbs,
            "port": self._place.port,
            "is_simulation": True,
            "languages": list(LANGUAGES),
        }

    # ---- looking -----------------------------------------------------------------------------

    async def state(self, request: Request, person: Person) -> Response:
        """Tell how the run stands."""
        del person
        return JSONResponse(self._twin.state(_language(request)))

    async def scene(self, request: Request, person: Person) -> Response:
        """Return what is drawn, or that nothing changed."""
        del person
        digest, text = await self._twin.scene()
        tag = f'"{digest}"'
        headers = {"etag": tag, "cache-control": "private, no-cache"}
        if request.headers.get("if-none-match") == tag:
            return Response(status_code=304, headers=headers)
        return Response(text, media_type="application/json", headers=headers)

    async def proposal(self, request: Request, person: Person) -> Response:
        """Return the open proposal, or one by its fingerprint."""
        wanted = request.path_params["fingerprint"]
        found = await self._twin.proposal("" if wanted == _OPEN else wanted, _language(request))
        if found is None:
            return answer(unknown("proposal", wanted))
        allowed = {
            v.value: bool(self._pins) or person.role.may(NEEDED_ROLE[v]) or _only(NEEDED_ROLE[v])
            for v in Verb
        }
        return JSONResponse({**found, "decisions_allowed": allowed})

    async def ways(self, request: Request, person: Person) -> Response:
        """Return what else could be done now."""
        del person
        return answer(await self._twin.ways(request.path_params["fingerprint"], _language(request)))

    async def manual(self, request: Request, person: Person) -> Response:
        """Return the checklist of what was perhaps done by hand at a target."""
        del person
        wanted = request.path_params["target"]
        found = self._twin.by_hand(wanted, _language(request))
        return (
            answer(unknown("piece in place at", wanted)) if found is None else JSONResponse(found)
        )

    async def blob(self, request: Request, person: Person) -> Response:
        """Return the exact bytes of a trajectory."""
        del person
        wanted = request.path_params["sha256"]
        found = await self._twin.blob(wanted)
        if found is None:
            return answer(unknown("trajectory", wanted))
        headers = {"cache-control": _FOR_EVER}
        return Response(found, media_type="application/octet-stream", headers=headers)

    async def runs(self, request: Request, person: Person) -> Response:
        """Return all runs."""
        del request, person
        return JSONResponse(await self._twin.runs())

    async def run(self, request: Request, person: Person) -> Response:
        """Return one run with its events."""
        del person
        wanted = request.path_params["run"]
        found = await self._twin.run(wanted, _language(request))
        return answer(unknown("run", wanted)) if found is None else JSONResponse(found)

    async def replay(self, request: Request, person: Person) -> Response:
        """Return everything that was sensed in a run."""
        del person
        wanted = request.path_params["run"]
        found = await self._twin.replay(wanted)
        return answer(unknown("run", wanted)) if found is None else JSONResponse(found)

    async def why(self, request: Request, person: Person) -> Response:
        """Return why a step is there, by this robot, in this way."""
        del person
        fingerprint, number = request.path_params["fingerprint"], request.path_params["number"]
        found = await self._twin.why(fingerprint, number, _language(request))
        return answer(unknown("step", str(number))) if found is None else JSONResponse(found)

    async def report(self, request: Request, person: Person) -> Response:
        """Return the report of a run; it loads nothing and runs nothing."""
        del person
        wanted = request.path_params["run"]
        found = await self._twin.report(wanted)
        if found is None:
            return answer(unknown("report of run", wanted))
        headers = {"content-security-policy": _REPORT_POLICY}
        return Response(found, media_type="text/html; charset=utf-8", headers=headers)

    async def schedule(self, request: Request, person: Person) -> Response:
        """Return planned and actual skills of the newest run."""
        del request, person
        return JSONResponse(await self._twin.schedule())

    async def plan_schedule(self, request: Request, person: Person) -> Response:
        """Return the schedule of a plan as a picture."""
        del person
        wanted = request.path_params["fingerprint"]
        width_px = _width_px(request)
        found = await self._twin.plan_schedule(wanted, _language(request), width_px)
        return answer(unknown("proposal", wanted)) if found is None else _picture(found)

    async def run_schedule(self, request: Request, person: Person) -> Response:
        """Return the schedule of a run as a picture."""
        del person
        wanted = request.path_params["run"]
        found = await self._twin.run_schedule(wanted, _language(request), _width_px(request))
        return answer(unknown("run", wanted)) if found is None else _picture(found)

    async def graph_picture(self, request: Request, person: Person) -> Response:
        """Return the construction relationship graph as a picture."""
        del person
        return _picture(await self._twin.graph_picture(_language(request)))

    async def graph(self, request: Request, person: Person) -> Response:
        """Return the construction relationship graph."""
        del request, person
        return JSONResponse(await self._twin.graph())

    async def audit(self, request: Request, person: Person) -> Response:
        """Return who decided what, when, and what was seen."""
        del person
        return JSONResponse(self._twin.audit(_language(request)))

    async def health(self, request: Request, person: Person) -> Response:
        """Return how everything is."""
        del request, person
        return JSONResponse(await self._twin.health())

    # ---- deciding ----------------------------------------------------------------------------

    async def decide(self, request: Request, person: Person) -> Response:
        """Pass a decision to the run; the answer is 200 only when it is on the disk."""
        raw = await request.body()
        body = read_body(DecisionBody, raw)
        decision, named = decision_from(body), await self._named(request, person, body)
        if isinstance(named, Reply):
            return answer(named)
        person = named
        if not person.role.may(needed := NEEDED_ROLE[decision.verb]):
            return answer(_not_your_role(decision, needed))
        return answer(await self._twin.decide(decision, person, _hash(raw, person)))

    async def _named(self, request: Request, person: Person, body: DecisionBody) -> Person | Reply:
        """Return who decides: by PIN if the project asks for one; programs have their tokens."""
        if self._pins is None:
            if body.pin or body.by:
                return refusal(422, "fields", "This project asks for no PIN; send none.")
            return person
        if request.headers.get("authorization", ""):
            return person
        return await self._pins.person(body.by or person.who, body.pin, person.session)

    async def hold(self, request: Request, person: Person) -> Response:
        """Stop the robots."""
        raw = await request.body()
        decision = hold_from(read_body(HoldBody, raw))
        return answer(await self._twin.hold(decision, person, _hash(raw, person)))


def answer(reply: Reply) -> Response:
    """Return a reply as a response."""
    return JSONResponse(reply.body, reply.status)


def unknown(what: str, name: str) -> Reply:
    """Return that something is not there."""
    return refusal(404, "unknown", f"There is no {what} {name!r}.")


def _not_your_role(decision: Decision, needed: Role) -> Reply:
    return refusal(403, "role", _only(needed), verb=decision.verb.value, needs=needed.value)


def _only(needed: Role) -> str:
    return f"Only a person with the role {needed.value} (or higher) may do this."


def _hash(raw: bytes, person: Person) -> str:
    content = {k: v for k, v in json.loads(raw).items() if k != "pin"}  # a hash would tell it
    return body_hash(content, person.who)


def _picture(svg: str) -> Response:
    headers = {"content-security-policy": _PICTURE_POLICY}
    return Response(svg, media_type="image/svg+xml", headers=headers)


def _width_px(request: Request) -> float:
    """Return how wide a picture shall be.

    Raises:
        BadRequestError: The width is none.
    """
    asked = request.query_params.get("width", "1120")
    if asked.isdecimal() and _NARROWEST_PX <= int(asked) <= _WIDEST_PX:
        return float(asked)
    message = f"width is {asked!r}, not pixels from {_NARROWEST_PX} to {_WIDEST_PX}."
    where: list[Json] = [{"field": "width", "message": message}]
    raise BadRequestError(refusal(422, "fields", message, where=where))


def _language(request: Request) -> str:
    return request.query_params.get("lang", LANGUAGES[0])
