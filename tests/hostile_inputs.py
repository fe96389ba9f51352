"""Hostile files, one by one, with the exit code and the words that each is answered with."""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass

from builders_foreign import ASSEMBLY, BARS, BTLX, NATIVE, OBJ

MM = ("--unit", "m")
UNIT_BY_KIND = {"btlx": (), "obj": MM, "compas_assembly": MM, "bar_frame": (), "native": ()}
TEXT_BY_KIND = {
    "btlx": BTLX,
    "obj": OBJ,
    "compas_assembly": ASSEMBLY,
    "bar_frame": BARS,
    "native": NATIVE,
}
JSON_KINDS = ("native", "compas_assembly", "bar_frame", "compas_timber")
TIMBER = b'{"dtype": "compas_timber.model/TimberModel", "data": {}}'
GOOD = {**TEXT_BY_KIND, "compas_timber": TIMBER}
DEEP = 100_000
DIGITS = b"9" * 1_000_000
BEYOND = b"2147483648"
POINTER = b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n"


@dataclass(frozen=True, slots=True, kw_only=True)
class Hostile:
    """A file and what the command line says to it.

    Attributes:
        says: Words of the error, code first.
        exit_code: 3 for a refused file, 0 for one that is harmless after all.
    """

    id: str
    content: bytes
    says: tuple[str, ...] = ()
    options: tuple[str, ...] = ()
    name: str = "hostile.file"
    exit_code: int = 3


def rows() -> Iterator[Hostile]:
    """Yield every row of the matrix that needs no library to be made."""
    yield from _any_format()
    yield from _json()
    yield from _xml()
    yield from _obj()
    yield from _numbers()
    yield from _structure()
    yield from _archives()


def _row(kind: str, attack: str, content: bytes, *says: str, exit_code: int = 3) -> Hostile:
    options = UNIT_BY_KIND.get(kind, MM)
    return Hostile(
        id=f"{kind}-{attack}", content=content, says=says, options=options, exit_code=exit_code
    )


def _any_format() -> Iterator[Hostile]:
    for kind, good in GOOD.items():
        yield _row(kind, "half", good[: len(good) // 2], "E")
        if kind in {"btlx", "native"}:  # the same code finds it in all
            yield _row(kind, "tenth", good[: len(good) // 10], "E4")
            yield _row(kind, "utf16", good.decode().encode("utf-16"), "E3", "UTF-16")
        yield _row(
            kind,
            "nul",
            good.replace(b": ", b": \0", 1)
            .replace(b'"stud"', b'"stu\0d"')
            .replace(b"v 0", b"v \0"),
            "E",
        )
        yield _row(kind, "trailing-data", good + b"\nfoo bar" + good, "E")
        yield _row(
            kind,
            "not-utf8",
            good.replace(b"stud", b"\xff\xfe")
            .replace(b"block", b"\xff\xfe")
            .replace(b"node", b"\xff\xfe"),
            "E",
        )
    yield Hostile(id="any-empty", content=b"", says=("E2", "empty"))
    yield Hostile(id="any-blank", content=b" \n" * 50, says=("E3",))
    yield Hostile(id="any-lfs", content=POINTER, says=("E2", "git lfs pull"))
    yield Hostile(id="any-noise", content=bytes(range(256)) * 40, says=("E3",))
    yield Hostile(id="any-pickle", content=b"\x80\x04cos\nsystem\n(S'true'\ntR.", says=("E3",))


_LONG = b"k" * 200_000
_ADDED: dict[str, tuple[bytes, tuple[str, ...]]] = {
    "deep-lists": (b'"x": ' + b"[" * DEEP + b"]" * DEEP, ("E5", "deeper than 32")),
    "digits": (b'"x": ' + DIGITS, ("E5", "1000000 digits")),
    "duplicate-key": (b'"x": 1, "x": 2', ("K2", "'x' stands twice")),
    "nan": (b'"x": NaN', ("K3", "NaN")),
    "surrogate": (b'"x": "\\ud800", "\\udfff": 1', ("E5", "surrogate")),
}
"""What is added to a JSON file of any kind."""
_ADDED_TO_TWO: dict[str, tuple[bytes, tuple[str, ...]]] = {
    "deep-objects": (b'"x": ' + b'{"a":' * DEEP + b"1" + b"}" * DEEP, ("E5", "deeper than 32")),
    "duplicate-keys": (
        b'"x": {' + b",".join([b'"k":1'] * 50_000) + b"}",
        ("K2", "stands 50000 times"),
    ),
    "distinct-duplicates": (
        b'"x": {' + b",".join(b'"k%d":1,"k%d":1' % (i, i) for i in range(20_000)) + b"}",
        ("K2", "more keys and numbers are wrong"),
    ),
    "long-key": (b'"' + _LONG + b'": 1, "' + _LONG + b'": 1', ("K2",)),
    "infinity": (b'"x": [-Infinity]', ("K3", "-Infinity")),
    "1e400": (b'"x": 1e400', ("K3", "1e400")),
    "many-nans": (b'"x": [' + b"NaN," * 50_000 + b"0]", ("K3", "more keys and numbers")),
}
"""What is added to one file of ours and one of others: the same code reads all JSON."""


def _json() -> Iterator[Hostile]:
    for kind in JSON_KINDS:
        good = GOOD[kind]
        inside = good.rstrip()[:-1]
        two = _ADDED_TO_TWO if kind in {"native", "compas_assembly"} else {}
        for attack, (added, says) in {**_ADDED, **two}.items():
            yield _row(kind, attack, inside + b", " + added + b"}", *says)
        is_whole = kind != "compas_timber"  # the small one holds no beams
        yield _row(kind, "bom", b"\xef\xbb\xbf" + good, exit_code=0 if is_whole else 3)
    yield _row("native", "list", b"[" + NATIVE + b"]", "E3")


def _xml() -> Iterator[Hostile]:
    for name, doctype in {
        "internal": b"<!DOCTYPE BTLx [<!ELEMENT BTLx ANY>]>",
        "system": b'<!DOCTYPE BTLx SYSTEM "file:///etc/passwd">',
        "public": b'<!DOCTYPE BTLx PUBLIC "-//x//y" "http://127.0.0.1:9/x.dtd">',
        "external-entity": b'<!DOCTYPE BTLx [<!ENTITY x SYSTEM "file:///etc/passwd">]>',
        "parameter-entity": b'<!DOCTYPE BTLx [<!ENTITY % x SYSTEM "http://127.0.0.1:9/x">%x;]>',
        "laughs": b"<!DOCTYPE BTLx [" + _laughs() + b"]>",
        "quadratic": b'<!DOCTYPE BTLx [<!ENTITY a "' + b"a" * 100_000 + b'">]>',
    }.items():
        yield _row(
            "btlx", f"doctype-{name}", doctype + BTLX.replace(b"stud", b"&a9;"), "E2", "DOCTYPE"
        )
    yield _row("btlx", "deep", BTLX.replace(b"<Parts>", b"<Parts>" + b"<a>" * DEEP), "E2", "deeper")
    yield _row(
        "btlx", "wide", BTLX.replace(b"<Parts>", b"<Parts>" + b"<a/>" * 2_000_001), "E2", "nodes"
    )
    yield _row(
        "btlx",
        "attributes",
        BTLX.replace(
            b"<Part ", b"<Part " + b" ".join(b'a%d=""' % i for i in range(300_000)) + b" "
        ),
        "E2",
        "attributes",
    )
    yield _row("btlx", "double-attribute", BTLX.replace(b"<Part ", b'<Part Count="2" '), "E5")
    yield _row("btlx", "undefined-entity", BTLX.replace(b"stud", b"&a;"), "E5")
    yield _row(
        "btlx",
        "xinclude",
        BTLX.replace(
            b"<Parts>",
            b'<Parts><xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="/etc/passwd"/>',
        ),
        exit_code=0,
    )
    yield _row("btlx", "utf7", b'<?xml version="1.0" encoding="UTF-7"?>' + BTLX, "E5")
    yield _row("btlx", "encoding", b'<?xml version="1.0" encoding="rot13"?>' + BTLX, "E5")
    yield _row(
        "btlx", "namespace", BTLX.replace(b"design2machine.com", b"design2machine.evil"), "E3"
    )
    yield _row(
        "btlx", "long-text", BTLX.replace(b"end</O", b"x" * 2_000_000 + b"</O"), "E2", "longer"
    )
    yield _row("btlx", "length-0", BTLX.replace(b'"800"', b'"0"'), "G6")
    yield _row("btlx", "length-minus", BTLX.replace(b'"800"', b'"-800"'), "G6")
    yield _row("btlx", "count-2e31", BTLX.replace(b'Count="1"', b'Count="2147483648"'), "P5")
    yield _row(
        "btlx",
        "count-digits",
        BTLX.replace(b'Count="1"', b'Count="' + DIGITS[:100_000] + b'"'),
        "P5",
        "whole number",
    )


def _laughs() -> bytes:
    lines = [b'<!ENTITY a0 "ha">']
    lines += [b'<!ENTITY a%d "%s">' % (n, b"&a%d;" % (n - 1) * 10) for n in range(1, 10)]
    return b"".join(lines)


def _obj() -> Iterator[Hostile]:
    yield _row(
        "obj", "face-2e31", OBJ.replace(b"f 5 6 7 8", b"f 5 6 7 2147483648"), "E5", "Line 11"
    )
    yield _row("obj", "face-minus-2e31", OBJ.replace(b"f 5 6 7 8", b"f 5 6 7 -2147483648"), "E5")
    yield _row("obj", "face-digits", OBJ.replace(b"f 5 6 7 8", b"f 5 6 7 " + DIGITS), "E5")
    yield _row("obj", "face-0", OBJ.replace(b"f 5 6 7 8", b"f 5 6 7 0"), "E5")
    yield _row("obj", "one-long-line", OBJ.replace(b"block 1", b"b" * 5_000_000), "E3")
    yield _row("obj", "long-face", OBJ + b"f " + b"1 2 3 " * 100_000, exit_code=0)
    yield _row("obj", "same-face", OBJ + b"f 1 2 3\n" * 50_000, exit_code=0)
    yield _row("obj", "objects", OBJ + b"o x\n" * 400_000, exit_code=0)
    yield _row("obj", "parts", OBJ + b"o x\nf 1 2 3\n" * 50_001, "E2", "50000")
    yield _row("obj", "continued", b"\\\n" * 2_000_000 + OBJ, "E")
    yield _row("obj", "mtllib", b"mtllib ../../../../etc/passwd\n" + OBJ, exit_code=0)


_HARMLESS = {
    *("obj-vertex-1e-300", "compas_assembly-vertex-1e-300", "bar_frame-point-1e-300"),
    *("btlx-place-1e-300", "native-place-1e-300"),
    *("btlx-place-2147483648", "bar_frame-area-2147483648"),  # far off, and thick: told
}


def _numbers() -> Iterator[Hostile]:
    for word in (b"NaN", b"1e400", b"1e30", BEYOND, b"1e-300"):
        for kind, place, old, new in (
            ("obj", "vertex", b"v 1 1 1", b"v 1 1 %s"),
            ("btlx", "place", b'Point X="0"', b'Point X="%s"'),
            ("btlx", "length", b'"800"', b'"%s"'),
            ("compas_assembly", "vertex", b'"z": 1.0', b'"z": %s'),
            ("bar_frame", "point", b'"Z": 2', b'"Z": %s'),
            ("bar_frame", "area", b"16.0", b"%s"),
            ("native", "size", b"[1.8,", b"[%s,"),
            ("native", "place", b'"p_m": [0.0', b'"p_m": [%s'),
        ):
            attack = f"{place}-{word.decode()}"
            content = GOOD[kind].replace(old, new % word, 1)
            code = 0 if f"{kind}-{attack}" in _HARMLESS else 3
            yield _row(kind, attack, content, exit_code=code)


def _structure() -> Iterator[Hostile]:
    yield _row("native", "stack-2e31", NATIVE.replace(b'"count": 2', b'"count": ' + BEYOND), "K1")
    yield _row("native", "stacks", _many_stacks(20_000), "E2", "50000")
    yield _row(
        "native",
        "spacers",
        NATIVE.replace(b'"place": "pallet"', b'"place": "pallet", "spacer_m": 1e30'),
        "K1",
    )
    yield _row(
        "native",
        "double-id",
        NATIVE.replace(b'"id": "pile"', b'"id": "pile.1"').replace(
            b'"id": "stud-1"', b'"id": "pile.1.2"'
        ),
        "D1",
    )
    yield _row(
        "native",
        "own-parent",
        NATIVE.replace(b'"ground": true', b'"construction_parents": ["stud-1"]'),
        "P2",
    )
    yield _row("native", "schema-2", NATIVE.replace(b"building/1", b"building/2"), "K1")
    yield _row(
        "native", "zero-quaternion", NATIVE.replace(b"[1.0, 0.0, 0.0, 0.0]", b"[0, 0, 0, 0]"), "K1"
    )
    yield _row(
        "native",
        "mesh-outside",
        NATIVE.replace(
            b'{"box": {"size_m": [1.8, 0.09, 0.04]}}',
            b'{"mesh": {"uri": "../../../../etc/passwd", "sha256": "' + b"0" * 64 + b'"}}',
        ),
        "E",
    )
    yield _row("bar_frame", "star", _star(5_000), "E2", "contacts")
    yield _row("bar_frame", "node-2e31", BARS.replace(b"[0, 1]", b"[0, 2147483648]"), "P1")
    yield _row("bar_frame", "own-end", BARS.replace(b"[0, 1]", b"[1, 1]"), "G6")
    yield _row("bar_frame", "unit", BARS.replace(b'"meter"', b'"parsec"'), "U1")
    yield _row("bar_frame", "area-0", BARS.replace(b"16.0", b"0"), "E")
    yield _row("bar_frame", "area-minus", BARS.replace(b"16.0", b"-16.0"), "E")
    yield _row(
        "compas_assembly",
        "corner-2e31",
        ASSEMBLY.replace(b"[0, 2, 3, 1]", b"[0, 2, 3, 2147483648]"),
        "E5",
    )
    yield _row(
        "compas_assembly",
        "types",
        ASSEMBLY.replace(b'"vertex": {', b'"vertex": [{').replace(b'}, "face"', b'}], "face"'),
        "K1",
    )
    yield _row(
        "compas_timber",
        "foreign-type",
        TIMBER.replace(b"{}", b'{"x": {"dtype": "os/system", "data": "id"}}'),
        "E2",
        "os/system",
    )
    yield Hostile(id="obj-no-unit", content=OBJ, says=("U1",))
    yield Hostile(id="obj-unit", content=OBJ, options=("--unit", "parsec"), says=("U1",))


def _many_stacks(count: int) -> bytes:
    document = json.loads(NATIVE)
    one = document["stacks"][0]
    one["generated"]["count"] = 1000
    document["stacks"] = [{**one, "id": f"s{n}"} for n in range(count)]
    return json.dumps(document).encode()


def _star(count: int) -> bytes:
    document = json.loads(BARS)
    document["element_list"] = [{"element_id": n, "end_node_ids": [0, 1]} for n in range(count)]
    return json.dumps(document).encode()


def _archives() -> Iterator[Hostile]:
    for attack, member in (
        ("plain", "a.json"),
        ("climbs", "../../a.json"),
        ("absolute", "/a.json"),
    ):
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(member, b"0" * 10_000_000)
        for name in ("a.json.zip", "a.ifczip", "a.3dm"):
            yield Hostile(
                id=f"zip-{attack}-{name}", content=packed.getvalue(), name=name, says=("E3", "ZIP")
            )
    yield Hostile(
        id="gzip", content=b"\x1f\x8b\x08" + bytes(100), name="a.json.gz", says=("E3", "gzip")
    )
