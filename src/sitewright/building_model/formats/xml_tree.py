"""A small XML tree, read with suspicion: no DOCTYPE, bounded depth and number of nodes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat

from sitewright.building_model.formats.detect import refused
from sitewright.errors import ModelRejectedError

MAX_NODES = 2_000_000
MAX_DEPTH = 64
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
    children: list[XmlNode] = field(default_factory=list)

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
    def __init__(self, path: Path) -> None:
        self._path, self._open, self._total = path, list[XmlNode](), 0
        self._first: XmlNode | None = None

    def doctype(self, *_: object) -> None:
        raise refused(self._path, "E2", "it holds a DOCTYPE.", "Remove that line.")

    def start(self, name: str, attributes: dict[str, str]) -> None:
        self._total += 1
        if self._total > MAX_NODES or len(self._open) >= MAX_DEPTH:
            message = f"it has more than {MAX_NODES} nodes, or is deeper than {MAX_DEPTH}."
            raise refused(self._path, "E2", message, "Export only what is to be built.")
        namespace, _, tag = name.rpartition(_SEPARATOR)
        node = XmlNode(namespace, tag, attributes)
        if self._open:
            self._open[-1].children.append(node)
        else:
            self._first = node
        self._open.append(node)

    def end(self, _name: str) -> None:
        self._open.pop()

    def text(self, text: str) -> None:
        self._open[-1].text += text

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
