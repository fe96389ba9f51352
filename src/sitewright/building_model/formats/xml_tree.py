"""A small XML tree, read with suspicion: no DOCTYPE, bounded depth and number of nodes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.parsers import expat

from sitewright.building_model.formats.detect import refused
from sitewright.errors import ModelRejectedError

MAX_NODES = 2_000_000
MAX_DEPTH = 64
MAX_ATTRIBUTES = 1_000
MAX_TEXT = 1_000_000
_NO_ATTRIBUTES: Mapping[str, str] = {}
_SEPARATOR = " "
_CUT_OFF = frozenset(
    {
        expat.errors.codes[expat.errors.XML_ERROR_NO_ELEMENTS],
        expat.errors.codes[expat.errors.XML_ERROR_UNCLOSED_TOKEN],
        expat.errors.codes[expat.errors.XML_ERROR_PARTIAL_CHAR],
        expat.errors.codes[expat.errors.XML_ERROR_UNCLOSED_CDATA_SECTION],
    }
)


@dataclass(slots=True)
class XmlNode:
    """An element.

    Attributes:
        namespace: Its namespace; empty if it has none.
        tag: Its name without prefix.
        text: All text directly in it.
    """

    namespace: str
    tag: str
    attributes: Mapping[str, str]
    text: str = ""
    children: Sequence[XmlNode] = ()

    def child(self, tag: str) -> XmlNode | None:
        """Return the first child of a name."""
        return next((c for c in self.children if c.tag == tag), None)

    def all(self, *tags: str) -> Iterator[XmlNode]:
        """Yield what lies along a path of names."""
        here = [self]
        for tag in tags:
            here = [c for node in here for c in node.children if c.tag == tag]
        yield from here


def read_xml(path: Path, content: bytes) -> XmlNode:
    """Return the root of an XML text.

    Raises:
        ModelRejectedError: It is cut off, no XML, holds a DOCTYPE, or is beyond the bounds.
    """
    builder = _Builder(path)
    parser = expat.ParserCreate(namespace_separator=_SEPARATOR)
    parser.buffer_text = True
    parser.StartDoctypeDeclHandler = builder.doctype
    parser.StartElementHandler = builder.start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.text
    try:
        parser.Parse(content, True)  # noqa: FBT003 - final
    except expat.ExpatError as error:
        raise _broken(path, error) from None
    except (ValueError, LookupError) as error:  # an encoding that Python lacks
        raise refused(path, "E5", f"it is no XML: {error}.", "Export it again.") from None
    return builder.root()


class _Builder:
    """Hears the parser; nodes without children or attributes share the empty ones."""

    def __init__(self, path: Path) -> None:
        self._path, self._open, self._total = path, list[XmlNode](), 0
        self._names: dict[str, tuple[str, str]] = {}
        self._texts: list[str] = []
        self._chars = 0
        self._first: XmlNode | None = None

    def doctype(self, *_: object) -> None:
        raise refused(self._path, "E2", "it holds a DOCTYPE.", "Remove that line.")

    def start(self, name: str, attributes: dict[str, str]) -> None:
        self._total += 1
        if self._total > MAX_NODES or len(self._open) >= MAX_DEPTH:
            message = f"it has more than {MAX_NODES} nodes, or is deeper than {MAX_DEPTH}."
            raise refused(self._path, "E2", message, "Export only what is to be built.")
        self._demand_short(attributes)
        self._keep_text()
        namespace, tag = self._name(name)
        node = XmlNode(namespace, tag, attributes or _NO_ATTRIBUTES)
        if self._open:
            above = self._open[-1]
            if isinstance(above.children, list):
                above.children.append(node)
            else:
                above.children = [node]
        else:
            self._first = node
        self._open.append(node)

    def end(self, _name: str) -> None:
        self._keep_text()
        self._open.pop()

    def text(self, text: str) -> None:
        self._chars += len(text)
        if self._chars > MAX_TEXT:
            raise self._too_long(f"a text in {self._open[-1].tag!r}")
        self._texts.append(text)

    def _keep_text(self) -> None:
        if self._texts:
            self._open[-1].text += "".join(self._texts)
            self._texts.clear()
        self._chars = 0

    def _demand_short(self, attributes: Mapping[str, str]) -> None:
        if len(attributes) > MAX_ATTRIBUTES:
            message = f"an element has {len(attributes)} attributes, more than {MAX_ATTRIBUTES}."
            raise refused(self._path, "E2", message, "Export it again.")
        for key, value in attributes.items():
            if len(key) + len(value) > MAX_TEXT:
                raise self._too_long(f"attribute {key[:40]!r}")

    def _too_long(self, what: str) -> ModelRejectedError:
        message = f"{what} is longer than {MAX_TEXT} characters."
        return refused(self._path, "E2", message, "Remove it, and export it again.")

    def _name(self, name: str) -> tuple[str, str]:
        if name not in self._names:
            namespace, _, tag = name.rpartition(_SEPARATOR)
            self._names[name] = namespace, tag
        return self._names[name]

    def root(self) -> XmlNode:
        assert self._first is not None  # noqa: S101 - expat refuses a text without elements
        return self._first


def _broken(path: Path, error: expat.ExpatError) -> ModelRejectedError:
    place = f"line {error.lineno}, column {error.offset + 1}"
    if error.code in _CUT_OFF:
        return refused(
            path, "E4", f"it is cut off at {place} (the XML does not end).", "Export it again."
        )
    words = expat.ErrorString(error.code)
    return refused(path, "E5", f"it is no XML at {place}: {words}.", "Export it again.")
