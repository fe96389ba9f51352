"""The pictures that the server draws for its page are those of the report."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree as ET

import httpx
import pytest

from builders_serving import Served, approval, served_in, wait_for, waiting

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    with served_in(tmp_path_factory.mktemp("pictures")) as running:
        yield running


@pytest.fixture(scope="module")
def page(served: Served) -> httpx.Client:
    """Return a page that has approved one plan; the one after it waits."""
    client = served.local()
    first = waiting(client)
    assert client.post("/api/decisions", json=approval(first)).status_code == 200
    wait_for(client, lambda s: s["progress"]["installed"] == 1)
    waiting(client, other_than=first["fingerprint"])
    return client


def bars(client: httpx.Client, path: str) -> dict[str, list[tuple[int, float]]]:
    """Return steps and starts of what a picture shows, by class."""
    answer = client.get(path)
    assert answer.status_code == 200
    assert answer.headers["content-type"].startswith("image/svg+xml")
    assert "default-src 'none'" in answer.headers["content-security-policy"]
    found: dict[str, list[tuple[int, float]]] = {"planned": [], "actual": []}
    for box in ET.fromstring(answer.text).iter(f"{SVG}rect"):  # noqa: S314
        if "data-step" in box.attrib:
            place = (int(box.attrib["data-step"]), float(box.attrib["data-starts-s"]))
            found[box.attrib["class"]].append(place)
    return {kind: sorted(places) for kind, places in found.items()}


def test_the_schedule_of_a_run_is_drawn_as_the_journal_tells_it(page: httpx.Client) -> None:
    run = page.get("/api/state").json()["run"]
    told = page.get("/api/schedule").json()
    drawn = bars(page, f"/api/runs/{run}/schedule.svg?width=700")
    for kind in ("planned", "actual"):
        shown = [b for b in told[kind] if kind == "actual" or b["duration_s"] > 0.0]
        assert drawn[kind] == sorted((b["step"], b["starts_s"]) for b in shown)
    assert drawn["actual"]


def test_the_schedule_of_a_plan_has_its_steps_and_what_ran_of_them(page: httpx.Client) -> None:
    ran = page.get("/api/schedule").json()["actual"][0]["fingerprint"]
    steps = page.get(f"/api/proposals/{ran}").json()["steps"]
    drawn = bars(page, f"/api/proposals/{ran}/schedule.svg?lang=de")
    assert drawn["planned"] == [(s["number"], s["starts_s"]) for s in steps if s["duration_s"]]
    assert [step for step, _ in drawn["actual"]] == [s["number"] for s in steps]
    assert drawn["actual"][0] == (1, steps[0]["starts_s"])
    waits = page.get("/api/proposals/open").json()["fingerprint"]
    assert bars(page, f"/api/proposals/{waits}/schedule.svg")["actual"] == []


def test_the_graph_has_every_component_of_the_building_and_no_stock(page: httpx.Client) -> None:
    answer = page.get("/api/graph.svg?lang=es")
    root = ET.fromstring(answer.text)  # noqa: S314
    drawn = {g.attrib["data-component"] for g in root.iter(f"{SVG}g") if len(g.attrib) > 1}
    nodes = page.get("/api/graph").json()["nodes"]
    assert drawn == {n["id"] for n in nodes if n["layer"] in {"target", "as_built"}}
    assert drawn
    assert "Obra" in answer.text


@pytest.mark.parametrize(
    ("path", "status"),
    [
        (f"/api/proposals/{'0' * 64}/schedule.svg", 404),
        ("/api/runs/nobody/schedule.svg", 404),
        ("/api/runs/../../schedule.svg", 404),
        ("/api/runs/nobody/schedule.svg?width=9", 422),
        ("/api/runs/nobody/schedule.svg?width=wide", 422),
        ("/api/runs/nobody/schedule.svg?width=-700", 422),
    ],
)
def test_what_cannot_be_drawn_is_refused_in_words(
    page: httpx.Client, path: str, status: int
) -> None:
    answer = page.get(path)
    assert answer.status_code == status


def test_nobody_sees_a_picture_who_is_not_signed_in(page: httpx.Client, served: Served) -> None:
    del page
    guest = served.guest()
    assert guest.get("/api/graph.svg").status_code == 401
