"""Reads a project's own sentences for its own skills from its settings."""

from __future__ import annotations

from collections.abc import Mapping

from pydantic import TypeAdapter, ValidationError

from sitewright.app.project import SETTINGS, ProjectError
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.languages import PHRASEBOOKS

_WORDS: TypeAdapter[dict[str, dict[str, str]]] = TypeAdapter(dict[str, dict[str, str]])


def own_words(settings: Mapping[str, Json]) -> Mapping[str, Mapping[str, str]]:
    """Return ``[words.LANGUAGE]`` of the settings: a sentence for each skill.

    Raises:
        ProjectError: It is no table of sentences, or in a language that there is not.
    """
    try:
        found = _WORDS.validate_python(settings.get("words", {}))
    except ValidationError as error:
        raise ProjectError(f"{SETTINGS}, [words]: {error}") from error
    unknown = sorted(set(found) - set(PHRASEBOOKS))
    if unknown:
        known = ", ".join(PHRASEBOOKS)
        raise ProjectError(f"{SETTINGS}, [words.{unknown[0]}]: the languages are {known}.")
    return found
