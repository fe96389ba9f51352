"""The types of the wire: the page's are written from the server's, and they refuse what is none."""

from __future__ import annotations

from typing import Any

import pytest
from tools.write_wire import WIRE, type_script

from builders_wire import assert_fits
from sitewright.interaction_twin import wire
from sitewright.interaction_twin.web.routes import ROUTES
from sitewright.interaction_twin.wire.answers import Ticket

NOT_JSON = ("/api/blobs/", "/report", ".svg")


def test_the_types_of_the_page_are_those_that_are_written_from_the_server() -> None:
    assert WIRE.read_text(encoding="utf-8") == type_script()


def test_every_route_that_answers_in_json_has_a_type() -> None:
    routes = {f"{r.method} {r.path}" for r in ROUTES if not any(n in r.path for n in NOT_JSON)}
    assert set(wire.ANSWERS) == routes


TICKET: dict[str, Any] = {"ticket": "t", "expires_s": 30}


@pytest.mark.parametrize(
    "other", [{"more": 1}, {"ticket": 1}, {"expires_s": 30.5}, {"expires_s": None}]
)
def test_a_document_that_is_otherwise_is_refused(other: dict[str, Any]) -> None:
    assert_fits((Ticket,), TICKET)
    with pytest.raises(AssertionError, match=r"Ticket.*\$"):
        assert_fits((Ticket,), {**TICKET, **other})
    with pytest.raises(AssertionError, match="required"):
        assert_fits((Ticket,), {"ticket": "t"})
