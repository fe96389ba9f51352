"""Text that remembers what it was made of, so that it can be said in another language."""

from __future__ import annotations

from collections.abc import Mapping
from string import Formatter
from typing import Any, Self

from typing_extensions import override

from sitewright.foundation.canonical import Json

Place = "str | int | float | Sentence | tuple[str, ...] | tuple[Sentence, ...]"
"""What stands in a place of a sentence: an id or somebody's own words, a figure, or sentences."""
JOINTS: Mapping[str, str] = {"and": " and ", "comma": ", ", "semi": "; ", "or": "; or "}
"""How several things in one place are joined: ``{things:and}``."""


class Speaker:
    """Says what stands in the places of a sentence; this one speaks English, in ids."""

    def word(self, text: str) -> str:
        """Return an id, somebody's own words, or a sentence."""
        return str(text)

    def figure(self, text: str) -> str:
        """Return a number that is written in English."""
        return text

    def joint(self, text: str) -> str:
        """Return what stands between several things."""
        return text


_ENGLISH = Speaker()


class Sentence(str):
    """English text, made of a template and of what stands in its places.

    It is a `str` for everybody who only reads it: equal texts are equal, and JSON has the text.
    Whoever speaks another language looks the template up and fills it again; nothing is parsed.

    Attributes:
        template: With places by name: ``{robot} cannot leave {place}: {why}``. A place may have
            a format for figures (``{gap_mm:.1f}``) or one of `JOINTS` for several things.
        places: What stands there.
    """

    __slots__ = ("places", "template")
    template: str
    places: Mapping[str, Any]

    def __new__(cls, template: str, /, **places: Any) -> Self:  # noqa: ANN401 -- see `Place`
        """Make the English text.

        Raises:
            KeyError: A place of the template is not given.
        """
        made = super().__new__(cls, filled(template, places, _ENGLISH))
        made.template = template
        made.places = places
        return made

    @override
    def __getnewargs__(self) -> tuple[str]:
        return (self.template,)

    @override
    def __reduce__(self) -> tuple[Any, ...]:
        return (_made_again, (type(self), self.template, dict(self.places)))


def filled(template: str, places: Mapping[str, Any], speaker: Speaker) -> str:
    """Return a template with its places filled by a speaker."""
    return _Filler(speaker).vformat(template, (), places)


class _Filler(Formatter):
    """Knows names only: no attributes, no indices."""

    def __init__(self, speaker: Speaker) -> None:
        self._speaker = speaker

    @override
    def get_field(self, field_name: str, args: Any, kwargs: Mapping[str, Any]) -> tuple[Any, str]:
        return kwargs[field_name], field_name

    @override
    def format_field(self, value: Any, format_spec: str) -> str:
        speaker = self._speaker
        if isinstance(value, tuple | list):
            joint = speaker.joint(JOINTS[format_spec or "and"])
            return joint.join(speaker.word(v) for v in value)
        if isinstance(value, int | float):
            return speaker.figure(format(value, format_spec))
        return speaker.word(value)


def parts_of(sentence: Sentence) -> Json:
    """Return template and places as JSON."""
    places = {name: _plain(value) for name, value in sentence.places.items()}
    return {"template": sentence.template, "places": places}


def sentence_of(parts: Json) -> Sentence:
    """Return the sentence of its parts.

    Raises:
        ValueError: These are no parts of a sentence.
    """
    match parts:
        case {"template": str() as template, "places": Mapping() as places}:
            try:
                return Sentence(template, **{str(k): _value(v) for k, v in places.items()})
            except (KeyError, IndexError, TypeError) as error:
                raise ValueError(f"{template!r} cannot be filled: {error}") from error
        case _:
            raise ValueError(f"{parts!r:.60} is no sentence")


def _plain(value: object) -> Json:
    if isinstance(value, Sentence):
        return parts_of(value)
    if isinstance(value, tuple | list):
        return [_plain(v) for v in value]
    return value if isinstance(value, int | float) else str(value)


def _value(data: Json) -> object:
    if isinstance(data, Mapping):
        return sentence_of(data)
    if isinstance(data, tuple | list):
        return tuple(_value(v) for v in data)
    return data


def _made_again(kind: type[Sentence], template: str, places: dict[str, Any]) -> Sentence:
    return kind(template, **places)
