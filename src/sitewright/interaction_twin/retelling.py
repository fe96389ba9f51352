"""Sentences of planners, controller and drivers in any language, with names that people know."""

from __future__ import annotations

from dataclasses import dataclass

from typing_extensions import override

from sitewright.foundation.sentence import Sentence, Speaker, filled
from sitewright.interaction_twin.labels import DRAWN_ZONE, Kind, Labels
from sitewright.interaction_twin.narration import fact_in_words, words_of
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook

_COMMA = {"de", "es"}
"""Languages that write 0,5."""


def retold(text: str, labels: Labels, book: Phrasebook = ENGLISH) -> str:
    """Return a text in a language; one that nobody has put into words stays English.

    Args:
        text: A `Sentence`, or a text of before there were any.
        labels: Names that people see.
        book: The language.
    """
    if not isinstance(text, Sentence):
        return book.told.get(text) or labels.told(text)
    return _Speaker(labels, book).word(text)


@dataclass(frozen=True, slots=True)
class Telling:
    """Retells texts in one language, with the names of one site."""

    labels: Labels
    book: Phrasebook

    def __call__(self, text: str) -> str:
        """Return a text in the language."""
        return retold(text, self.labels, self.book)


@dataclass(frozen=True, slots=True)
class _Speaker(Speaker):
    """Says names for ids, and looks templates up."""

    labels: Labels
    book: Phrasebook

    @override
    def word(self, text: str) -> str:
        if isinstance(text, Sentence):
            template = self.book.told.get(text.template, text.template)
            return filled(template, text.places, self)
        if text.startswith("(") and text.endswith(")"):
            return fact_in_words(text, self.labels, self.book)
        return self.book.told.get(text) or self._name(text)

    def _name(self, site_id: str) -> str:
        label = self.labels.label(site_id)
        match label.kind:
            case Kind.OPERATION:
                return words_of(site_id, self.labels, self.book)
            case Kind.DRAWN_ZONE:
                template = self.book.told.get(DRAWN_ZONE, DRAWN_ZONE)
                return template.format(number=label.name.rpartition(" ")[2])
            case _:
                return self.labels.body(site_id)

    @override
    def figure(self, text: str) -> str:
        return text.replace(".", ",") if self.book.language in _COMMA else text

    @override
    def joint(self, text: str) -> str:
        return self.book.told.get(text, text)
