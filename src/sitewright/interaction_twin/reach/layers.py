"""One view of the reach picture, layer by layer."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sitewright.interaction_twin.drawing.svg import Attribute, element, text, tooltip
from sitewright.interaction_twin.reach.drawing import Drawing, Drawn, DrawnRobot, Spotted
from sitewright.interaction_twin.reach.names import names
from sitewright.interaction_twin.reach.outline import Point
from sitewright.interaction_twin.reach.palette import ALARM, INK, PAPER
from sitewright.interaction_twin.reach.view import Frame, Side

_DOT_PX = 2.6


def layers(drawing: Drawing, frame: Frame, side: Side) -> Iterator[str]:
    """Yield the elements of a view, from behind to the front."""
    yield from _bodies((d for d in drawing.fixtures if d.is_floor), frame, side)
    yield from _grid(frame)
    yield from _bodies((d for d in drawing.fixtures if not d.is_floor), frame, side)
    yield from _bodies(drawing.zones, frame, side)
    yield from (_sphere(r, frame, side) for r in drawing.robots)
    robots = [_robot(r, frame, side) for r in drawing.robots]
    stock, targets = (list(_bodies(b, frame, side)) for b in (drawing.stock, drawing.targets))
    yield from (*stock, *robots, *targets) if side is Side.PLAN else (*stock, *targets, *robots)
    yield from (_spot(s, frame, side) for s in drawing.spots)
    yield from names(drawing, frame, side)


def _grid(frame: Frame) -> Iterator[str]:
    columns, rows = frame.grid_m()
    for x in columns:
        (x_px, top), (_, bottom) = frame.at((x, frame.high_m[1])), frame.at((x, frame.low_m[1]))
        yield _line((x_px, top), (x_px, bottom))
        yield text(f"{x}", x_px + 2.0, bottom - 3.0, font_size=9, fill="#9aa7b5")
    for y in rows:
        (left, y_px), (right, _) = frame.at((frame.low_m[0], y)), frame.at((frame.high_m[0], y))
        yield _line((left, y_px), (right, y_px))
        yield text(f"{y} m", left + 3.0, y_px - 2.0, font_size=9, fill="#9aa7b5")


def _line(a: Point, b: Point) -> str:
    return element("line", x1=a[0], y1=a[1], x2=b[0], y2=b[1], stroke="#eef1f4")


def _bodies(bodies: Iterable[Drawn], frame: Frame, side: Side) -> Iterator[str]:
    for body in sorted(bodies, key=lambda d: side.depth(d.outline)):
        path = "".join(frame.path(p) for p in side.polygons(body.outline))
        dashes = {"stroke_dasharray": "5 4"} if body.is_zone else {}
        yield element(
            "path",
            tooltip(body.hint) if body.hint else "",
            d=path,
            fill=body.look.fill,
            fill_opacity=body.opacity,
            stroke=body.look.edge,
            stroke_width=1,
            stroke_linejoin="round",
            **dashes,
        )


def _sphere(robot: DrawnRobot, frame: Frame, side: Side) -> str:
    """Return how far the wrist reaches: one ball, or what it sweeps along rails."""
    if robot.sphere is None:
        return ""
    radius = robot.sphere.radius_m * frame.px_per_m
    middles = [frame.at(side.point(c)) for c in robot.sphere.centres_m]
    style: dict[str, Attribute] = {
        "fill": robot.colour,
        "fill_opacity": 0.035,
        "stroke": robot.colour,
    }
    return "".join(
        element("circle", cx=x, cy=y, r=radius, stroke_dasharray="2 5", stroke_width=1.2, **style)
        for x, y in sorted(set(middles))
    )


def _robot(robot: DrawnRobot, frame: Frame, side: Side) -> str:
    links = "".join(
        element(
            "path",
            d="".join(frame.path(p) for p in side.polygons(link)),
            fill=robot.colour,
            fill_opacity=0.28 if side is Side.PLAN else 0.12,
            stroke=robot.colour,
            stroke_width=0.8,
            stroke_opacity=1.0 if side is Side.PLAN else 0.6,
            stroke_linejoin="round",
        )
        for link in sorted(robot.links, key=side.depth)
    )
    return element("g", tooltip(robot.id) + links)


def _spot(spot: Spotted, frame: Frame, side: Side) -> str:
    x, y = frame.at(side.point(spot.at_m))
    fill = INK if spot.is_reached else ALARM
    return element(
        "circle",
        tooltip(spot.hint),
        cx=x,
        cy=y,
        r=_DOT_PX if spot.is_reached else 1.5 * _DOT_PX,
        fill=fill,
        stroke=PAPER,
        stroke_width=0.6,
    )
