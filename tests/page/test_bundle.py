"""What is committed of the page: small, complete, and said in every language."""

from __future__ import annotations

import gzip
import json
import re
from pathlib import Path

import pytest

TWIN = Path(__file__).parents[2] / "src" / "sitewright" / "interaction_twin"
STATIC, SOURCE = TWIN / "web" / "static", TWIN / "page"
LIMIT_BYTES = 220_000
LANGUAGES = ("de", "en", "es", "zh")


def test_the_page_is_small_over_the_wire() -> None:
    sent = [STATIC / name for name in ("index.html", "app.js", "page.css", "icon.svg")]
    assert sum(len(gzip.compress(f.read_bytes())) for f in sent) < LIMIT_BYTES


def test_the_page_names_no_address_outside() -> None:
    for name in ("index.html", "page.css", "app.js"):
        text = (STATIC / name).read_text(encoding="utf-8")
        assert re.findall(r"(?:src|href)=\"(?!/static/)[^\"]*\"|url\(|import\(", text) == [], name


def test_everything_in_the_bundle_is_named_with_its_licence() -> None:
    lock = json.loads((SOURCE / "package-lock.json").read_text(encoding="utf-8"))
    shipped = {
        path.removeprefix("node_modules/"): package
        for path, package in lock["packages"].items()
        if path and not package.get("dev")
    }
    notices = (STATIC / "THIRD_PARTY.txt").read_text(encoding="utf-8")
    assert shipped
    for name, package in shipped.items():
        assert f"{name} {package['version']} ({package['license']})" in notices


def test_versions_of_the_page_are_exact() -> None:
    package = json.loads((SOURCE / "package.json").read_text(encoding="utf-8"))
    wanted = {**package["dependencies"], **package["devDependencies"]}
    assert [v for v in wanted.values() if not re.fullmatch(r"\d+\.\d+\.\d+", v)] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_language_says_everything_with_the_same_places(language: str) -> None:
    english, other = _catalogue("en"), _catalogue(language)
    assert set(other) == set(english)
    places = {k: sorted(re.findall(r"\{\w+\}", v)) for k, v in english.items()}
    assert {k: sorted(re.findall(r"\{\w+\}", v)) for k, v in other.items()} == places
    assert "" not in other.values()


def _catalogue(language: str) -> dict[str, str]:
    text = (SOURCE / "src" / "words" / f"{language}.ts").read_text(encoding="utf-8")
    return dict(re.findall(r'^  "([^"]+)": "((?:[^"\\]|\\.)*)",$', text, re.MULTILINE))
