"""Plans in all languages: the same sentences everywhere, and a project's own words."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import fields

import pytest

from builders_run import A
from sitewright.app.project import ProjectError
from sitewright.app.serving.own_words import own_words
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.languages import PHRASEBOOKS, with_own_skills
from sitewright.interaction_twin.narration import ARGUMENT_NAMES, act_of
from sitewright.interaction_twin.phrases import ENGLISH
from sitewright.robot_team.skill import Skill, SkillCall

OTHERS = [b for b in PHRASEBOOKS.values() if b is not ENGLISH]
PLACE = re.compile(r"\{(\w+)\}")
WORD = re.compile("[a-z]{4}")

WORD = re.compile("[a-z]{4}")


def places(text: object) -> set[str]:
    texts = text if isinstance(text, tuple) else (text,)
    return {p for t in texts for p in PLACE.findall(str(t))}


@pytest.mark.parametrize("book", OTHERS, ids=lambda b: b.language)
def test_every_language_says_everything_with_the_same_facts(book: object) -> None:
    for field in fields(ENGLISH):
        mine, theirs = getattr(ENGLISH, field.name), getattr(book, field.name)
        if field.name == "told":
            continue  # English needs no entry for what is said in English: see test_sentences
        if not isinstance(mine, Mapping):
            assert places(mine) == places(theirs), field.name
            continue
        assert set(mine) == set(theirs), field.name
        for key, sentence in mine.items():
            assert places(sentence) == places(theirs[key]), (field.name, key)
            assert theirs[key] != sentence or not WORD.search(PLACE.sub("", str(sentence)))


def test_every_built_in_skill_has_a_sentence() -> None:
    assert set(ARGUMENT_NAMES) == set(Skill)
    assert set(Skill) <= set(ENGLISH.skill)


def test_a_skill_of_ones_own_brings_its_own_words() -> None:
    call = SkillCall("glue-up", A, ("joint-1", "glue-gun"))
    assert act_of(call, Labels()) == f"glue-up({A}, joint-1, glue-gun)"
    own = own_words({"words": {"en": {"glue-up": "glues {0} with {1}"}}})
    books = with_own_skills(PHRASEBOOKS, own)
    assert act_of(call, Labels(), books["en"]) == "glues joint-1 with glue-gun"
    assert "glue-up" in act_of(call, Labels(), books["de"])  # spelled, never hidden


@pytest.mark.parametrize(
    "words", [{"xx": {"reach": "x"}}, {"en": ["x"]}, {"en": {"reach": 3}}, "words"]
)
def test_words_that_are_none_are_refused(words: object) -> None:
    with pytest.raises(ProjectError, match="words"):
        own_words({"words": words})  # type: ignore[dict-item]
