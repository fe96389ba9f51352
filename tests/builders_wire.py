"""Holds what a server sends against the types that the page is written from."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

import httpx
from jsonschema import Draft202012Validator
from tools.write_wire import wire_schema

from sitewright.interaction_twin import wire

_PLACE = re.compile(r"\{(\w+)(?::int)?\}")


def assert_fits(kinds: tuple[type, ...], document: Any) -> None:
    """Fail with where and why a document is none of the kinds that it may be."""
    faults = {k.__name__: _faults(k, document) for k in kinds}
    assert [] in faults.values(), f"{faults}"


def _faults(kind: type, document: Any) -> list[str]:
    found = _validator(kind.__name__).iter_errors(document)
    return [f"{error.json_path}: {error.message[:200]}" for error in found]


def assert_answer_fits(response: httpx.Response) -> None:
    """Hold a JSON answer of any route against its type."""
    response.read()
    if response.headers.get("content-type", "").startswith("application/json"):
        request = response.request
        assert_body_fits(
            request.method, request.url.path, response.json(), is_success=response.is_success
        )


def assert_body_fits(method: str, path: str, body: Any, *, is_success: bool) -> None:
    """Hold the body of an answer against what its route answers."""
    kinds = _kinds_of(method, path.partition("?")[0]) if is_success else (wire.Refusal,)
    assert kinds, f"{method} {path} has no type in wire.ANSWERS"
    assert_fits(kinds, body)


def _kinds_of(method: str, path: str) -> tuple[type, ...]:
    for route, kinds in wire.ANSWERS.items():
        verb, _, pattern = route.partition(" ")
        if verb == method and re.fullmatch(_PLACE.sub("[^/]+", pattern), path):
            return kinds
    return ()


@cache
def _validator(name: str) -> Draft202012Validator:
    return Draft202012Validator({**wire_schema(), "$ref": f"#/$defs/{name}"})
