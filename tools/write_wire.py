# ruff: noqa: INP001
"""Writes the page's types, ``wire.ts``, from the types of the server's documents.

Part of ``make page``; CI compares what it writes with what is committed.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from sitewright.interaction_twin import wire

WIRE = Path(wire.__file__).parents[1] / "page" / "src" / "wire.ts"
_HEAD = "// What goes over the wire. Written by tools/write_wire.py from interaction_twin/wire.\n"
_REF = "#/$defs/"
_PLAIN = {
    "string": "string",
    "number": "number",
    "integer": "number",
    "boolean": "boolean",
    "null": "null",
}
Schema = Mapping[str, Any]


def wire_schema() -> dict[str, Any]:
    """Return the JSON Schema of all documents by name; nothing beside their fields is allowed."""
    kinds = [*(k for kinds in wire.ANSWERS.values() for k in kinds), *wire.NEWS, wire.Refusal]
    found: dict[str, Any] = {}
    for kind in kinds:
        schema = TypeAdapter[Any](kind).json_schema(mode="serialization")
        found |= schema.pop("$defs", {})
        if "$ref" not in schema:
            found[kind.__name__] = schema
    for content in found.values():
        if "properties" in content:
            content["additionalProperties"] = False
    return {"$defs": dict(sorted(found.items()))}


def type_script() -> str:
    """Return the types as TypeScript, by name."""
    return _HEAD + "".join(_declared(n, s) for n, s in wire_schema()["$defs"].items())


def _declared(name: str, schema: Schema) -> str:
    words = schema.get("description", "")
    note = f"/** {words} */\n" if words else ""
    if "properties" not in schema:
        return f"\n{note}export type {name} = {_type(schema)};\n"
    lines = "".join(f"  {line}\n" for line in _fields(schema))
    return f"\n{note}export interface {name} {{\n{lines}}}\n"


def _fields(schema: Schema) -> list[str]:
    needed = set(schema.get("required", ()))
    return [
        f"{name}{'' if name in needed else '?'}: {_type(content)};"
        for name, content in schema["properties"].items()
    ]


def _type(schema: Schema) -> str:  # noqa: C901, PLR0911 -- one line per kind of schema
    match schema:
        case {"$ref": ref}:
            return str(ref).removeprefix(_REF)
        case {"const": value}:
            return json.dumps(value)
        case {"enum": values}:
            return " | ".join(json.dumps(v) for v in values)
        case {"anyOf": kinds}:
            return " | ".join(dict.fromkeys(_type(k) for k in kinds))
        case {"prefixItems": items}:
            return f"[{', '.join(_type(i) for i in items)}]"
        case {"type": "array", "items": items}:
            inner = _type(items)
            return f"({inner})[]" if " | " in inner else f"{inner}[]"
        case {"type": "object", "additionalProperties": content}:
            inner = _type(content) if isinstance(content, Mapping) else "unknown"
            return f"Record<string, {inner}>"
        case {"type": kind}:
            return _PLAIN[kind]
        case _:
            return "unknown"


def main() -> None:
    """Write the file."""
    WIRE.write_text(type_script(), encoding="utf-8")


if __name__ == "__main__":
    main()
