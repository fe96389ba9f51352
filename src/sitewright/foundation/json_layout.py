"""Lays out JSON for people and for diffs: short values on one line, the rest indented."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence

from sitewright.foundation.canonical import Json

_WIDTH = 100
_FLAT_LEVELS = 3
"""Values nested deeper are never put on one line."""


def laid_out(value: Json) -> str:
    """Return the document as text that ends with a newline; keys keep their order."""
    return _text(value, 0, 0) + "\n"


def _text(value: Json, indent: int, used: int) -> str:
    """Return `value` as text; `used` columns of its first line are taken already."""
    flat = json.dumps(value, ensure_ascii=False, allow_nan=False)
    if not isinstance(value, Mapping | list | tuple) or not value:
        return flat
    if indent + used + len(flat) <= _WIDTH and _nesting(value) <= _FLAT_LEVELS:
        return flat
    inner = indent + 2
    pad = "\n" + " " * inner
    if isinstance(value, Mapping):
        keys = {key: json.dumps(key, ensure_ascii=False) + ": " for key in value}
        rows = [keys[k] + _text(v, inner, len(keys[k]) + 1) for k, v in value.items()]
        return "{" + pad + f",{pad}".join(rows) + "\n" + " " * indent + "}"
    rows = [_text(item, inner, 1) for item in value]
    return "[" + pad + f",{pad}".join(rows) + "\n" + " " * indent + "]"


def _nesting(value: Json) -> int:
    if isinstance(value, Mapping):
        return 1 + max((_nesting(v) for v in value.values()), default=0)
    if isinstance(value, Sequence) and not isinstance(value, str):
        return 1 + max((_nesting(v) for v in value), default=0)
    return 0
