"""What pages hear: every event once and in order, also those missed while the server was gone."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest
from websockets.sync.client import ClientConnection, connect

from builders_serving import Served, approval, wait_for, waiting
from builders_wire import assert_fits
from sitewright.app.serving.history import history_of
from sitewright.interaction_twin import wire


@pytest.fixture(autouse=True)
def state_home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


@contextmanager
def listening(
    served: Served, page: httpx.Client, after: object, language: str = "en"
) -> Iterator[ClientConnection]:
    with connect(
        f"ws://127.0.0.1:{served.address.port}/ws",
        additional_headers={"origin": served.origin},
        open_timeout=60,
        close_timeout=2,
    ) as link:
        ticket = page.post("/api/ws-ticket", json={}).json()["ticket"]
        link.send(json.dumps({"ticket": ticket, "after": after, "lang": language}))
        yield link


def heard_until(link: ClientConnection, kind: str) -> list[dict[str, Any]]:
    """Return all texts up to the first of a kind of event or message."""
    found: list[dict[str, Any]] = []
    while not found or kind not in {found[-1]["type"], found[-1].get("kind")}:
        message = link.recv(60)
        if isinstance(message, str):
            found.append(json.loads(message))
            assert_fits(wire.NEWS, found[-1])
    return found


def numbers(messages: list[dict[str, Any]]) -> list[tuple[str, int]]:
    return [(m["run"], m["n"]) for m in messages if m["type"] == "event"]


def test_events_come_in_order_and_missed_ones_after_the_server_was_gone(tmp_path: Path) -> None:
    folder = tmp_path / "project"
    with Served(folder) as served:
        page = served.local()
        proposal = waiting(page)
        with listening(served, page, {"run": "", "n": 0}) as link:
            press = approval(proposal)
            told = page.post("/api/decisions", json=press).json()
            first = heard_until(link, "component_installed")
        cookies = dict(page.cookies)
        wait_for(page, lambda s: s["phase"] == "waiting")
    last = numbers(first)[-1]
    with Served(folder) as served:
        page = served.guest()
        (value,) = cookies.values()
        page.cookies.set(f"sitewright-{served.address.port}", value)
        assert page.get("/api/session").status_code == 200  # still signed in
        again = page.post("/api/decisions", json=press).json()
        assert again == {**told, "repeated": True}  # a key decides once, also across servers
        with listening(served, page, {"run": last[0], "n": last[1]}) as link:
            missed = heard_until(link, "caught-up")
    heard = [*numbers(first), *numbers(missed)]
    written = [(r.run, r.stamped.number) for r in history_of(folder / "runs")]
    assert heard == written[: len(heard)]
    assert len(set(heard)) == len(heard)
    assert "run_held" in {m.get("kind") for m in missed}


def test_a_page_that_asks_for_nothing_old_hears_only_what_comes(tmp_path: Path) -> None:
    with Served(tmp_path / "project") as served:
        page = served.local()
        proposal = waiting(page)
        with listening(served, page, None) as link:
            opening = heard_until(link, "state")
            assert numbers(opening) == []
            assert opening[-1]["open"]["code"] == proposal["code"]
            page.post("/api/decisions", json=approval(proposal))
            assert numbers(heard_until(link, "approval_given"))[0][1] == opening[0]["n"] + 1


def test_frames_are_a_header_and_numbers() -> None:
    from sitewright.foundation.pose import Pose
    from sitewright.interaction_twin.web.frames import joints_frame, poses_frame

    frame = joints_frame([0.5, -1.25], epoch=65_537, sequence=7, t_ms=1.5)
    assert struct.unpack("<BBHId2f", frame) == (1, 1, 1, 7, 1.5, 0.5, -1.25)
    frame = poses_frame([(3, Pose((1.0, 2.0, 3.0)))], epoch=2, sequence=8, t_ms=2.5)
    assert len(frame) == 16 + 32
    assert struct.unpack("<BBHIdHH7f", frame)[5:] == (3, 0, 1, 2, 3, 1, 0, 0, 0)


def test_each_page_is_told_in_its_own_language_and_may_change_it(tmp_path: Path) -> None:
    with Served(tmp_path / "project") as served:
        page = served.local()
        proposal = waiting(page)
        everything = {"run": "", "n": 0}
        with listening(served, page, everything, "de") as link:
            told = heard_until(link, "state")
            assert f"Lauf {told[0]['run']} beginnt." in [m.get("words") for m in told]
            assert told[-1]["words"].startswith("Wartet auf eine Entscheidung: ")
            link.send(json.dumps({"lang": "zh", "after": everything}))
            again = heard_until(link, "caught-up")
            assert f"运行 {told[0]['run']} 开始。" in [m.get("words") for m in again]
            assert numbers(again) == numbers(told)
            assert heard_until(link, "state")[-1]["words"].startswith("等待您的决定")
        press = {**approval(proposal), "verb": "resume", "lang": "es"}
        del press["scope"]
        refused = page.post("/api/decisions", json=press)
        assert (refused.status_code, refused.json()["message"]) == (
            409,
            "La ejecución ya está en marcha.",
        )
        assert "message~" not in refused.json()
