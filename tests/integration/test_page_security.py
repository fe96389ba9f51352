"""Who gets in, and what nobody may send: by HTTP and by WebSocket, before anybody looks at it."""

from __future__ import annotations

import http.client
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect

from builders_serving import Served, approval, served_in, wait_for, waiting
from sitewright.app.clock import SystemClock
from sitewright.app.execution import state_home
from sitewright.app.run_folder import installation_key
from sitewright.app.serving.users import new_user
from sitewright.interaction_twin.roles import NEEDED_ROLE, Person, Role, Verb
from sitewright.interaction_twin.web.api import Api
from sitewright.interaction_twin.web.routes import ROUTES
from sitewright.interaction_twin.web.sessions import Sessions

ROLES = tuple(Role)


@pytest.fixture(scope="module")
def tokens() -> dict[str, str]:
    return {}


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory, tokens: dict[str, str]) -> Iterator[Served]:
    folder = tmp_path_factory.mktemp("page")
    users = folder / "users.toml"
    for role in ROLES:
        tokens[role] = new_user(users, f"the {role}", role)
    with served_in(folder, users=users) as running:
        yield running


def raw(
    served: Served, method: str, path: str, headers: list[tuple[str, str]], body: bytes = b""
) -> tuple[int, dict[str, Any]]:
    """Send a request exactly as given, also one that no client library would send."""
    link = http.client.HTTPConnection("127.0.0.1", served.address.port, timeout=60)
    try:
        link.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
        for name, value in headers:
            link.putheader(name, value)
        link.putheader("Content-Length", str(len(body)))
        link.endheaders(body)
        answer = link.getresponse()
        text = answer.read()
        try:
            return answer.status, json.loads(text)
        except ValueError:
            return answer.status, {"error": text.decode()}
    finally:
        link.close()


def cookie_of(served: Served, role: str, tokens: dict[str, str]) -> str:
    client = served.user(f"the {role}", tokens[role])
    return "; ".join(f"{k}={v}" for k, v in client.cookies.items())


def test_every_route_has_a_policy_and_every_verb_a_role() -> None:
    assert all(hasattr(Api, route.handler) for route in ROUTES)
    assert len({(r.method, r.path) for r in ROUTES}) == len(ROUTES)
    assert set(NEEDED_ROLE) == set(Verb)
    open_to_all = {(r.method, r.path) for r in ROUTES if r.policy.needs is None}
    assert open_to_all == {("POST", "/api/session")}


@pytest.mark.parametrize("route", ROUTES, ids=lambda r: f"{r.method} {r.path}")
def test_without_a_session_no_route_answers_but_the_sign_in(served: Served, route: Any) -> None:
    path = (
        route.path.replace("{fingerprint}", "open")
        .replace("{sha256}", "0" * 64)
        .replace("{number:int}", "1")
        .replace("{target}", "stud-1")
    )
    body = "{}" if route.method != "GET" else None
    answer = served.guest().request(
        route.method,
        path.replace("{run}", "0001-0000"),
        content=body,
        headers={"content-type": "application/json"},
    )
    expected = (422, "fields") if route.policy.needs is None else (401, "session")
    assert (answer.status_code, answer.json()["error"]) == expected


@pytest.mark.parametrize("role", ROLES)
@pytest.mark.parametrize("verb", list(Verb))
def test_each_role_may_do_exactly_what_it_is_for(
    served: Served, tokens: dict[str, str], role: Role, verb: Verb
) -> None:
    client = served.user(f"the {role}", tokens[role])
    may = client.get("/api/session").json()["can"]
    allowed = ROLES.index(role) >= ROLES.index(NEEDED_ROLE[verb])
    assert (verb.value in may) == allowed
    if verb is Verb.HOLD:
        return  # its own test: it would hold the run of the others
    body = {
        "verb": verb.value,
        "key": f"matrix-{role}-{verb}",
        "fingerprint": "0" * 64,
        "scope": {"kind": "plan"},
        "reason": "other",
        "step": 1,
        "call": {"skill": "reach", "robot": "r", "arguments": []},
        "question_id": "none",
        "answer": "done",
        "component": "stud-1",
        "zone": {"remove": "keep-out-9"},
        "target": "stud-1",
        "effects": ["(standing stud-1)"],
    }
    if verb is Verb.RESUME:
        wait_for(client, lambda s: s["phase"] == "waiting")
    answer = client.post("/api/decisions", json=body)
    if allowed:
        assert answer.status_code == 409, answer.text  # taken seriously, then found out of date
    else:
        assert (answer.status_code, answer.json()["error"]) == (403, "role")
        assert answer.json()["needs"] == NEEDED_ROLE[verb].value


def test_the_link_signs_in_one_time_and_the_cookie_is_for_this_port_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    with Served(tmp_path / "project") as served:
        guest = served.guest()
        first = guest.post("/api/session", json={"token": served.token})
        assert first.status_code == 200
        set_cookie = first.headers["set-cookie"]
        assert f"sitewright-{served.address.port}=" in set_cookie
        assert "HttpOnly" in set_cookie
        assert "SameSite=strict" in set_cookie
        again = served.guest().post("/api/session", json={"token": served.token})
        assert (again.status_code, again.json()["error"]) == (401, "token")
        guest.delete("/api/session", headers={"content-type": "application/json"})
        assert guest.get("/api/state").status_code == 401


def test_where_people_have_names_the_link_signs_nobody_in(served: Served) -> None:
    """Whoever started the server would count as one person more."""
    assert served.address.url == f"{served.origin}/"
    local = Person(who="local", role=Role.ADMIN, session="1")
    forger = Sessions(key=installation_key(state_home()), clock=SystemClock())
    guest = served.guest()
    guest.cookies.set(f"sitewright-{served.address.port}", forger.cookie_of(local))
    assert guest.get("/api/state").status_code == 401


def test_a_forged_cookie_is_nobody(served: Served, tokens: dict[str, str]) -> None:
    name, _, value = cookie_of(served, "viewer", tokens).partition("=")
    text, _, mac = value.strip('"').partition(".")
    for forged in (f"{text}.{'0' * 64}", f"{text[:-4]}AAAA.{mac}", "nonsense", "."):
        guest = served.guest()
        guest.cookies.set(name, forged)
        assert guest.get("/api/state").status_code == 401


@pytest.mark.parametrize(
    ("changes", "status", "error"),
    [
        ({"host": "evil.example"}, 403, "host"),
        ({"host": "127.0.0.1"}, 403, "host"),
        ({"host": "127.0.0.1:1"}, 403, "host"),
        ({"origin": "http://evil.example"}, 403, "origin"),
        ({"origin": "http://127.0.0.1:1"}, 403, "origin"),
        ({"origin": "https://127.0.0.1:{port}"}, 403, "origin"),
        ({"origin": "null"}, 403, "origin"),
        ({"origin": None}, 403, "origin"),
        ({"origin": None, "sec-fetch-site": "same-site"}, 403, "origin"),
        ({"content-type": "text/plain"}, 415, "content-type"),
        ({"content-type": "application/x-www-form-urlencoded"}, 415, "content-type"),
        ({"content-type": None}, 415, "content-type"),
    ],
)
def test_what_does_not_come_from_the_page_is_refused(
    served: Served,
    tokens: dict[str, str],
    changes: dict[str, str | None],
    status: int,
    error: str,
) -> None:
    port = served.address.port
    headers: dict[str, str | None] = {
        "host": f"127.0.0.1:{port}",
        "origin": f"http://127.0.0.1:{port}",
        "content-type": "application/json",
        "cookie": cookie_of(served, "operator", tokens),
        **changes,
    }
    sent = [(k, v.replace("{port}", str(port))) for k, v in headers.items() if v is not None]
    body = json.dumps({"verb": "resume", "key": "a-forged-one"}).encode()
    answer = raw(served, "POST", "/api/decisions", sent, body)
    assert (answer[0], answer[1]["error"]) == (status, error)


def test_two_hosts_are_none(served: Served) -> None:
    host = f"127.0.0.1:{served.address.port}"
    status, _ = raw(served, "GET", "/api/state", [("host", host), ("host", host)])
    assert status in {400, 403}


@pytest.mark.parametrize(
    ("body", "status", "error"),
    [
        (b"{", 400, "json"),
        (b'{"verb":"resume","key":"k-12345678","key":"k-87654321"}', 400, "json"),
        (b'{"verb":"resume","key":"k-12345678","step":NaN}', 400, "json"),
        (b'{"verb":"resume","key":"k-12345678","admin":true}', 422, "fields"),
        (b'{"verb":"resume","key":12345678}', 422, "fields"),
        (b'{"verb":"become-admin","key":"k-12345678"}', 422, "fields"),
        (b'{"verb":"approve","key":"k-12345678"}', 422, "fields"),
        (b'{"verb":"resume","key":"' + b"k" * 1_000_001 + b'"}', 413, "too-large"),
        (b"[" * 100_000, 400, "json"),
    ],
    ids=lambda v: str(v)[:40],
)
def test_a_body_that_is_not_as_it_should_be_is_refused(
    served: Served, tokens: dict[str, str], body: bytes, status: int, error: str
) -> None:
    client = served.user("the operator", tokens["operator"])
    answer = client.post(
        "/api/decisions", content=body, headers={"content-type": "application/json"}
    )
    assert (answer.status_code, answer.json()["error"]) == (status, error)


def test_every_answer_tells_the_browser_to_be_strict(served: Served) -> None:
    for path in ("/", "/api/state", "/static/nothing.js"):
        headers = served.guest().get(path).headers
        assert "default-src 'self'" in headers["content-security-policy"]
        assert "frame-ancestors 'none'" in headers["content-security-policy"]
        assert headers["x-content-type-options"] == "nosniff"


def test_a_program_with_a_token_of_its_own_needs_no_page(
    served: Served, tokens: dict[str, str]
) -> None:
    program = served.guest(origin="", authorization=f"Bearer {tokens['viewer']}")
    assert program.get("/api/session").json()["who"] == "the viewer"
    wrong = served.guest(origin="", authorization="Bearer nonsense")
    assert wrong.get("/api/session").status_code == 401


# ---- the WebSocket ---------------------------------------------------------------------------


def socket(served: Served, **headers: str) -> ClientConnection:
    found = {"origin": served.origin, **headers}
    return connect(
        f"ws://127.0.0.1:{served.address.port}/ws",
        additional_headers={k: v for k, v in found.items() if v},
        open_timeout=60,
        close_timeout=2,
    )


@pytest.mark.parametrize("origin", ["http://evil.example", "http://127.0.0.1:1", "null"])
def test_a_socket_of_another_page_is_refused_before_it_opens(served: Served, origin: str) -> None:
    with pytest.raises(InvalidStatus) as refused, socket(served, origin=origin):
        pass
    assert refused.value.response.status_code == 403


def test_a_socket_with_a_cookie_and_no_origin_is_refused(
    served: Served, tokens: dict[str, str]
) -> None:
    cookie = cookie_of(served, "viewer", tokens)
    with pytest.raises(InvalidStatus), socket(served, origin="", cookie=cookie):
        pass


def test_a_ticket_opens_one_socket(served: Served, tokens: dict[str, str]) -> None:
    client = served.user("the viewer", tokens["viewer"])
    ticket = client.post("/api/ws-ticket", json={}).json()["ticket"]
    with socket(served) as first:
        first.send(json.dumps({"ticket": ticket, "after": None}))
        assert json.loads(first.recv(60))["type"] == "caught-up"
        with socket(served) as second:
            second.send(json.dumps({"ticket": ticket}))
            with pytest.raises(ConnectionClosed) as closed:
                second.recv(60)
            assert closed.value.rcvd is not None
            assert closed.value.rcvd.code == 4401


def test_a_viewer_may_ask_for_a_hold_and_only_an_operator_resumes(
    served: Served, tokens: dict[str, str]
) -> None:
    viewer = served.user("the viewer", tokens["viewer"])
    operator = served.user("the operator", tokens["operator"])
    proposal = waiting(viewer)
    assert viewer.post("/api/decisions", json=approval(proposal)).status_code == 403
    assert viewer.post("/api/hold", json={"key": "viewer-hold"}).status_code == 200
    held = wait_for(viewer, lambda s: s["phase"] == "held")
    assert held["held"]["reason"] == "the viewer holds the run."
    go = {"verb": "resume", "key": "viewer-resume"}
    assert viewer.post("/api/decisions", json=go).status_code == 403
    assert operator.post("/api/decisions", json={**go, "key": "op-resume"}).status_code == 200
    wait_for(operator, lambda s: s["phase"] == "waiting")
