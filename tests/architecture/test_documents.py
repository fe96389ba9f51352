"""The documents keep up with the code."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sitewright.building_model.codes import CODES

ROOT = Path(__file__).parents[2]
DECISIONS = ROOT / "docs" / "decisions"
DOCUMENTS = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])


@pytest.mark.parametrize("file", DOCUMENTS, ids=lambda f: str(f.relative_to(ROOT)))
def test_links_between_documents_lead_somewhere(file: Path) -> None:
    targets = re.findall(r"\]\(([^)#]+)[^)]*\)", file.read_text(encoding="utf-8"))
    missing = [t for t in targets if "://" not in t and not (file.parent / t).exists()]
    assert missing == []


def test_every_decision_is_listed() -> None:
    listed = (DECISIONS / "README.md").read_text(encoding="utf-8")
    records = sorted(f.name for f in DECISIONS.glob("[0-9]*.md"))
    assert records
    assert [r for r in records if f"({r})" not in listed] == []
    assert [r[:4] for r in records] == [f"{n:04d}" for n in range(1, len(records) + 1)]


def test_every_make_target_of_the_readme_exists() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    for target in re.findall(r"make ([a-z-]+)", readme):
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), target


def test_change_notes_are_one_sentence_and_named_by_kind() -> None:
    notes = sorted((ROOT / "changelog.d").glob("*.md"))
    for note in notes:
        assert note.name.endswith((".added.md", ".changed.md", ".fixed.md")), note.name
        text = note.read_text(encoding="utf-8").strip()
        assert text.endswith("."), note.name
        assert "\n" not in text, note.name


def test_the_lock_files_name_no_index_and_hash_everything() -> None:
    for name in ("requirements.lock", "requirements-dev.lock", "requirements-all.lock"):
        text = (ROOT / name).read_text(encoding="utf-8")
        assert "://" not in text
        assert "index-url" not in text
        pins = re.findall(r"^\S+==\S+", text, re.MULTILINE)
        blocks = re.split(r"^(?=\S+==)", text, flags=re.MULTILINE)[1:]
        assert len(pins) == len(blocks) > 20
        assert all("--hash=sha256:" in b for b in blocks)


def test_every_code_of_a_problem_is_in_the_page_about_checks() -> None:
    page = (ROOT / "docs" / "check.md").read_text(encoding="utf-8")
    named = set(re.findall(r"\b[A-Z][0-9]\b", page))
    for letter, first, last in re.findall(r"\b([A-Z])([0-9])-\1([0-9])\b", page):
        named |= {f"{letter}{n}" for n in range(int(first), int(last) + 1)}
    of_cells = {"K1", "K2", "K3", "L1", "L2", "L3"}
    assert set(CODES) - of_cells - named == set()
    assert named - set(CODES) == set()
