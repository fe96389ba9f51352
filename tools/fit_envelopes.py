# ruff: noqa: INP001, T201
"""Fit the convex envelopes of the built-in KR 120 around measured link meshes.

    python tools/fit_envelopes.py FOLDER_OF_MEASURED_STL OUT_FOLDER

The measured shapes themselves never enter the project. Each link is first enclosed by planes
perpendicular to directions of our own choice, their distances rounded outwards to whole millimetres
after half a millimetre more, so that no corner falls on a measured point. From the corners of that
body as few are kept as leave every measured point inside or within the tolerance.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from sitewright.robot_team.formats.hulls import Facets, hull_facets
from sitewright.robot_team.formats.mesh_points import Points, read_points

DIRECTIONS = 1200
TOLERANCE_M = {"link_1": 0.0045, "link_4": 0.0025, "link_5": 0.003, "link_6": 0.0015}
OTHER_TOLERANCE_M = 0.0035
CORNER_GRID_M = 1e-4
PLANE_GRID_M = 1e-3
MARGIN_M = 5e-4


def directions(count: int) -> Points:
    """Return the six axis directions and `count` more on a golden spiral."""
    i = np.arange(count) + 0.5
    polar, azimuth = np.arccos(1.0 - 2.0 * i / count), np.pi * (1.0 + 5.0**0.5) * i
    spiral = np.stack(
        [np.cos(azimuth) * np.sin(polar), np.sin(azimuth) * np.sin(polar), np.cos(polar)], axis=1
    )
    return np.vstack([np.eye(3), -np.eye(3), spiral])


def enclosing_corners(points: Points, around: Points) -> Points:
    """Return the corners of the body bounded by one plane per direction.

    A corner is the polar dual of a facet of the hull of the planes' poles.
    """
    centre = np.round(points.mean(axis=0), 3)
    support_m = (points @ around.T).max(axis=0) + MARGIN_M
    reach = np.ceil(support_m / PLANE_GRID_M) * PLANE_GRID_M - around @ centre
    poles = hull_facets(around / reach[:, None])
    return np.asarray(poles.normals / poles.offsets_m[:, None] + centre)


def fewest_corners(points: Points, corners: Points, tolerance_m: float) -> Points:
    """Choose corners until no point is further outside than the tolerance; drop idle ones."""
    chosen = sorted({int(i) for i in (corners @ directions(20).T).argmax(axis=0)})
    while True:
        facets = hull_facets(corners[chosen])
        excess = facets.excess_m(points)
        if excess.max() <= tolerance_m:
            break
        facet = np.unravel_index(excess.argmax(), excess.shape)[1]
        chosen.append(int((corners @ facets.normals[facet]).argmax()))
    for index in reversed(chosen):
        rest = [i for i in chosen if i != index]
        if hull_facets(corners[rest]).excess_m(points).max() <= tolerance_m:
            chosen = rest
    return np.round(corners[chosen] / CORNER_GRID_M) * CORNER_GRID_M


def write_obj(path: Path, facets: Facets) -> None:
    """Write a hull as Wavefront OBJ in metres."""
    lines = ["# Sitewright's own envelope, in metres; made by tools/fit_envelopes.py"]
    lines += [f"v {x:.4f} {y:.4f} {z:.4f}" for x, y, z in facets.corners]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in facets.triangles]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def main() -> None:
    """Fit every link and print how tight the result is."""
    parser = argparse.ArgumentParser(description="Fit convex envelopes around link meshes.")
    parser.add_argument("measured", type=Path)
    parser.add_argument("out", type=Path)
    arguments = parser.parse_args()
    for source in sorted(arguments.measured.glob("*.stl")):
        measured = hull_facets(read_points(source))
        corners = enclosing_corners(measured.corners, directions(DIRECTIONS))
        tolerance_m = TOLERANCE_M.get(source.stem, OTHER_TOLERANCE_M)
        envelope = hull_facets(fewest_corners(measured.corners, corners, tolerance_m))
        write_obj(arguments.out / f"{source.stem}.obj", envelope)
        ratio = envelope.volume_m3() / measured.volume_m3()
        outside_mm = 1e3 * float(envelope.excess_m(measured.corners).max())
        print(
            f"{source.stem:10} {len(envelope.corners):3} vertices, volume x {ratio:.3f}, "
            f"at most {outside_mm:.1f} mm outside"
        )


if __name__ == "__main__":
    main()
