"""A run that is looked at again is what its journal says was sensed, moment by moment."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from builders_serving import Served, approval, served_in, waiting
from sitewright.app.run_folder import RunFolder, event_of
from sitewright.central_controller.cycle import folded
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import SiteObserved
from sitewright.journal.sqlite import read_records


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    with served_in(tmp_path_factory.mktemp("replay")) as running:
        yield running


@pytest.fixture(scope="module")
def page(served: Served) -> httpx.Client:
    """Return a page that has approved two plans of the run."""
    client = served.local()
    seen = ""
    for _ in range(2):
        plan = waiting(client, other_than=seen)
        seen = plan["fingerprint"]
        assert client.post("/api/decisions", json=approval(plan)).status_code == 200
    waiting(client, other_than=seen)
    return client


@pytest.fixture(scope="module")
def replay(page: httpx.Client) -> dict[str, Any]:
    answer = page.get(f"/api/runs/{page.get('/api/state').json()['run']}/replay")
    assert answer.status_code == 200
    found: dict[str, Any] = answer.json()
    return found


def history(served: Served, run: str) -> list[tuple[int, Any]]:
    folder = RunFolder(Path(served.folder) / "runs" / run)
    return [(r.seq, event_of(folder, r)) for r in read_records(folder.journal)]


def test_the_moments_put_together_are_what_the_controller_had_sensed(
    served: Served, replay: dict[str, Any]
) -> None:
    state = CycleState(site=served.site.site)
    robots, pieces = dict(replay["start"]["robots"]), dict(replay["start"]["pieces"])
    moments = {m["n"]: m for m in replay["moments"]}
    looked_at = 0
    for number, event in history(served, replay["run"]):
        state = folded(state, event)
        if not isinstance(event, SiteObserved):
            continue
        moment = moments.pop(number)
        robots |= moment["robots"]
        pieces = {p: T for p, T in pieces.items() if p not in moment["gone"]} | moment["pieces"]
        sensed = state.site.sensed
        assert sensed is not None
        assert set(pieces) == set(sensed.world_T_piece)
        for piece, pose in sensed.world_T_piece.items():
            assert pieces[piece]["p_m"] == pytest.approx(list(pose.position_m), abs=1e-6)
        for robot, seen in sensed.robots.items():
            assert robots[robot]["q_rad"] == pytest.approx(list(seen.q_rad), abs=1e-6)
            assert (robots[robot]["gripped"], robots[robot]["mounted"]) == (
                seen.gripped,
                seen.mounted,
            )
        looked_at += 1
    assert moments == {}
    assert looked_at > 10


def test_what_is_in_place_at_the_end_is_what_the_run_has_placed(
    served: Served, replay: dict[str, Any]
) -> None:
    state = CycleState(site=served.site.site)
    for _, event in history(served, replay["run"]):
        state = folded(state, event)
    placed = dict(replay["placed"])
    for placing in replay["placings"]:
        if placing["piece"] is None:
            placed.pop(placing["target"])
        else:
            placed[placing["target"]] = placing["piece"]
    assert placed == {t: p.piece for t, p in state.site.placed.items()}
    assert len(placed) >= 2


def test_the_axis_is_that_of_the_schedule_and_never_goes_back(
    page: httpx.Client, replay: dict[str, Any]
) -> None:
    shown = page.get("/api/schedule").json()["actual"]
    assert [(s["robot"], s["step"], s["fingerprint"]) for s in replay["skills"]] == [
        (b["robot"], b["step"], b["fingerprint"]) for b in shown
    ]
    starts = [s["starts_s"] for s in replay["skills"]]
    assert starts == pytest.approx([b["starts_s"] for b in shown], abs=1e-3)
    for times in (replay["events"], replay["moments"], replay["placings"]):
        stamps = [(t["n"], t["at_s"]) for t in times]
        assert stamps == sorted(stamps)
    ends_s = [e["at_s"] for e in replay["events"]]
    assert ends_s == sorted(ends_s)
    assert replay["duration_s"] == max(ends_s)


def test_a_run_that_never_was_is_refused_in_words(page: httpx.Client) -> None:
    answer = page.get("/api/runs/0009-none/replay")
    assert (answer.status_code, answer.json()["error"]) == (404, "unknown")


def test_a_plan_of_any_run_can_be_asked_for(page: httpx.Client, replay: dict[str, Any]) -> None:
    for fingerprint in {s["fingerprint"] for s in replay["skills"]}:
        plan = page.get(f"/api/proposals/{fingerprint}").json()
        assert plan["status"] == "done"
