"""A small writer of SVG: elements as text, presentation attributes only, everything escaped."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

from sitewright.interaction_twin.drawing.palette import INK

Attribute = str | float | int

FONT = "system-ui, 'DejaVu Sans', sans-serif"


def element(tag: str, content: str = "", /, **attributes: Attribute) -> str:
    """Return an element; ``_`` in attribute names becomes ``-``, numbers get two decimals.

    Args:
        tag: Name of the element.
        content: Its inside, already SVG; use `text` for words.
        attributes: In the order in which they are written.
    """
    parts = [
        f'{name.rstrip("_").replace("_", "-")}="{_value(v)}"' for name, v in attributes.items()
    ]
    head = " ".join((tag, *parts))
    return f"<{head}>{content}</{tag}>" if content else f"<{head}/>"


def _value(value: Attribute) -> str:
    if isinstance(value, float):
        return f"{value:.2f}".rstrip("0").rstrip(".")
    return escape(str(value), quote=True)


def text(words: str, x: float, y: float, /, **attributes: Attribute) -> str:
    """Return a text element at a place."""
    style: dict[str, Attribute] = {"font_size": 12, "fill": INK, **attributes}
    return element("text", escape(words, quote=False), x=x, y=y, **style)


def tooltip(words: str) -> str:
    """Return the title of an element, which browsers show on hover and screen readers say."""
    return f"<title>{escape(words, quote=False)}</title>"


def picture(
    width: float, height: float, title: str, parts: Iterable[str], /, **attributes: Attribute
) -> str:
    """Return a whole SVG document that scales to the width it is given."""
    across, down = float(width), float(height)
    return element(
        "svg",
        tooltip(title) + "".join(parts),
        xmlns="http://www.w3.org/2000/svg",
        viewBox=f"0 0 {_value(across)} {_value(down)}",
        width=across,
        height=down,
        role="img",
        font_family=FONT,
        **attributes,
    )


def shortened(words: str, width_px: float, *, char_px: float = 6.6) -> str:
    """Return words cut to a width, with an ellipsis; nothing if not even three letters fit."""
    fit = int(width_px / char_px)
    if len(words) <= fit:
        return words
    return words[: fit - 1].rstrip() + "…" if fit > 3 else ""  # noqa: PLR2004 -- three letters
