"""Frozen dataclasses to plain JSON values and back, by their type annotations."""

# ruff: noqa: ANN401 -- type annotations are looked at as values here

from __future__ import annotations

import types
from collections.abc import Mapping, Sequence
from dataclasses import MISSING, Field, fields, is_dataclass
from enum import Enum
from functools import cache
from typing import Any, NewType, TypeVar, Union, get_args, get_origin, get_type_hints

from sitewright.foundation.canonical import Json
from sitewright.foundation.sentence import Sentence, parts_of, sentence_of

_T = TypeVar("_T")
_TAG = "is"
_TOLD = "~"


class DecodeError(ValueError):
    """Stored JSON does not fit the type that it should be."""


def to_json(value: object) -> Json:
    """Return a dataclass value as JSON; each dataclass carries its name under ``is``.

    Beside a field with a `Sentence` stands what it is made of: ``reason`` and ``reason~``.
    Mappings with keys other than text become sorted lists of pairs.
    """
    if value is None or isinstance(value, bool | int | float | str):
        plain = str(value) if isinstance(value, Sentence) else value
        return plain.value if isinstance(plain, Enum) else plain
    if is_dataclass(value) and not isinstance(value, type):
        named = {f.name: getattr(value, f.name) for f in fields(value)}
        told = {f"{n}{_TOLD}": parts_of(v) for n, v in named.items() if isinstance(v, Sentence)}
        return {_TAG: type(value).__name__, **{n: to_json(v) for n, v in named.items()}, **told}
    if isinstance(value, Mapping):
        return _mapping_to_json(value)
    if isinstance(value, frozenset):
        return [to_json(v) for v in sorted(value)]
    if isinstance(value, Sequence):
        return [to_json(v) for v in value]
    raise TypeError(f"{type(value).__name__} has no JSON form")


def _mapping_to_json(value: Mapping[Any, object]) -> Json:
    if all(isinstance(k, str) for k in value):
        return {str(k): to_json(value[k]) for k in value}
    return [[to_json(k), to_json(value[k])] for k in sorted(value)]


def from_json(kind: type[_T], data: Json) -> _T:
    """Return the value of type `kind` that `to_json` wrote; anything else is a `DecodeError`."""
    result: _T = _decode(kind, data, kind.__name__)
    return result


def _decode(kind: Any, data: Json, where: str) -> Any:
    while isinstance(kind, NewType):
        kind = kind.__supertype__
    origin = get_origin(kind)
    if origin in (Union, types.UnionType):
        return _decode_union(get_args(kind), data, where)
    if origin is not None:
        return _decode_container(origin, get_args(kind), data, where)
    if is_dataclass(kind):
        return _decode_dataclass(kind, data, where)
    return _decode_scalar(kind, data, where)


def _decode_scalar(kind: Any, data: Json, where: str) -> Any:
    if kind is float and isinstance(data, int | float) and not isinstance(data, bool):
        return float(data)
    if isinstance(kind, type) and issubclass(kind, Enum) and isinstance(data, str):
        try:
            return kind(data)
        except ValueError as error:
            raise DecodeError(f"{where}: {error}") from error
    if isinstance(kind, type) and type(data) is kind:
        return data
    raise DecodeError(f"{where}: {data!r:.60} is not {kind}")


def _decode_union(options: tuple[Any, ...], data: Json, where: str) -> Any:
    if any(get_origin(o) is Sequence for o in options):  # the recursive alias `Json`
        return data
    if data is None and type(None) in options:
        return None
    choices = [o for o in options if o is not type(None)]
    if isinstance(data, Mapping) and any(is_dataclass(o) for o in choices):
        choices = [o for o in choices if getattr(o, "__name__", "") == data.get(_TAG)]
    if len(choices) != 1:
        raise DecodeError(f"{where}: no type of {options} fits {data!r:.60}")
    return _decode(choices[0], data, where)


def _decode_container(origin: Any, arguments: tuple[Any, ...], data: Json, where: str) -> Any:
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return _decode_mapping(arguments[0], arguments[1], data, where)
    if not isinstance(data, Sequence) or isinstance(data, str):
        raise DecodeError(f"{where}: {data!r:.60} is no list")
    if origin is tuple and arguments[-1:] != (Ellipsis,):
        if len(arguments) != len(data):
            raise DecodeError(f"{where}: {len(data)} entries, not {len(arguments)}")
        return tuple(_decode(a, d, where) for a, d in zip(arguments, data, strict=True))
    items = [_decode(arguments[0], d, where) for d in data]
    return frozenset(items) if origin is frozenset else tuple(items)


def _decode_mapping(key: Any, value: Any, data: Json, where: str) -> dict[Any, Any]:
    if isinstance(data, Mapping):
        return {_decode(key, k, where): _decode(value, v, f"{where}.{k}") for k, v in data.items()}
    if get_origin(key) is not tuple or not isinstance(data, Sequence) or isinstance(data, str):
        raise DecodeError(f"{where}: {data!r:.60} is no mapping")
    pairs = [_decode(tuple[key, value], pair, where) for pair in data]
    return dict(pairs)


def _decode_dataclass(kind: Any, data: Json, where: str) -> Any:
    if not isinstance(data, Mapping) or data.get(_TAG, kind.__name__) != kind.__name__:
        raise DecodeError(f"{where}: {data!r:.60} is no {kind.__name__}")
    hints, known = _hints(kind), {f.name: f for f in fields(kind)}
    told = {n: data[f"{n}{_TOLD}"] for n in known if f"{n}{_TOLD}" in data}
    unknown = sorted(set(data) - set(known) - {_TAG, *(f"{n}{_TOLD}" for n in told)})
    if unknown:
        raise DecodeError(f"{where}: {kind.__name__} has no {', '.join(unknown)}")
    missing = [n for n, f in known.items() if n not in data and not _has_default(f)]
    if missing:
        raise DecodeError(f"{where}: {kind.__name__} lacks {', '.join(missing)}")
    found = {n: _decode(hints[n], data[n], f"{where}.{n}") for n in known if n in data}
    try:
        return kind(**{**found, **{n: sentence_of(parts) for n, parts in told.items()}})
    except ValueError as error:
        raise DecodeError(f"{where}: {error}") from error


def _has_default(field: Field[Any]) -> bool:
    return field.default is not MISSING or field.default_factory is not MISSING


@cache
def _hints(kind: type) -> dict[str, Any]:
    return get_type_hints(kind)
