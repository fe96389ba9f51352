"""All languages in which plans are told, and a project's own words for its own skills."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.interaction_twin.phrases_chinese import CHINESE
from sitewright.interaction_twin.phrases_german import GERMAN
from sitewright.interaction_twin.phrases_spanish import SPANISH

PHRASEBOOKS: Mapping[str, Phrasebook] = {
    book.language: book for book in (ENGLISH, GERMAN, SPANISH, CHINESE)
}


def with_own_skills(
    books: Mapping[str, Phrasebook], own: Mapping[str, Mapping[str, str]]
) -> dict[str, Phrasebook]:
    """Return the books with a project's sentences for its own skills.

    Args:
        books: By language.
        own: By language: template by skill; ``{0}``, ``{1}`` ... stand for the arguments.
    """
    return {
        language: replace(book, skill={**own.get(language, {}), **book.skill})
        for language, book in books.items()
    }
