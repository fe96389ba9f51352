"""URDF text as a tree: safe parsing, and numbers whose faults are collected."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree as ET
from xml.parsers import expat

from sitewright.errors import CellRejectedError, Problem
from sitewright.foundation.pose import Pose, Vector

ZERO: Vector = (0.0, 0.0, 0.0)


@dataclass(slots=True)
class Findings:
    """The faults found so far in one file; reading goes on after each."""

    file: str
    problems: list[Problem] = field(default_factory=list)

    def add(self, code: str, where: str, message: str, fix: str) -> None:
        """Note one fault that refuses the file."""
        self.problems.append(
            Problem(code=code, severity="E", where=where, message=message, fix=fix)
        )

    def raise_if_any(self) -> None:
        """Raise all faults together, if there are some."""
        if self.problems:
            raise CellRejectedError(self.file, self.problems)

    def numbers(
        self, element: ET.Element, attribute: str, where: str, default: tuple[float, ...]
    ) -> tuple[float, ...]:
        """Return an attribute's numbers, as many as the default has; else note the fault."""
        text = element.get(attribute)
        if text is None:
            return default
        try:
            values = tuple(float(word) for word in text.split())
        except ValueError:
            values = ()
        if len(values) == len(default) and all(math.isfinite(v) for v in values):
            return values
        self.add(
            "R2",
            where,
            f'<{element.tag} {attribute}="{text}"> is not {len(default)} finite number(s).',
            "Write plain numbers in metres, kilograms and radians.",
        )
        return default

    def number(
        self, element: ET.Element, attribute: str, where: str, default: float | None = None
    ) -> float:
        """Return one number; without a default its absence is a fault."""
        if default is None and element.get(attribute) is None:
            self.add(
                "R2",
                where,
                f"<{element.tag}> has no attribute '{attribute}'.",
                f'Write {attribute}="...".',
            )
        return self.numbers(element, attribute, where, (default or 0.0,))[0]

    def vector(
        self, element: ET.Element, attribute: str, where: str, default: Vector = ZERO
    ) -> Vector:
        """Return three numbers."""
        x, y, z = self.numbers(element, attribute, where, default)
        return (x, y, z)

    def origin(self, element: ET.Element, where: str) -> Pose:
        """Return the pose of the element's <origin>; none is the identity."""
        origin = element.find("origin")
        if origin is None:
            return Pose()
        return Pose.from_rpy(self.vector(origin, "xyz", where), self.vector(origin, "rpy", where))


def parse_robot(path: Path) -> ET.Element:
    """Return the <robot> element; what is no URDF at all is a CellRejectedError."""
    try:
        data = path.read_bytes()
        _refuse_doctype(data)
        robot = ET.fromstring(data)  # noqa: S314  # no DOCTYPE, so no entities to expand
    except OSError as error:
        raise _rejected(path, f"the file cannot be read: {error.strerror}.") from error
    except (ET.ParseError, expat.ExpatError, ValueError) as error:
        raise _rejected(path, f"this is not usable XML: {error}.") from error
    if robot.tag != "robot":
        raise _rejected(path, f"the outermost element is <{robot.tag}>, not <robot>.")
    return robot


def _refuse_doctype(data: bytes) -> None:
    def refuse(*_: object) -> None:
        raise ValueError("a DOCTYPE is not allowed, since entities can hide other files in it")

    parser = expat.ParserCreate()
    parser.StartDoctypeDeclHandler = refuse
    parser.Parse(data, True)  # noqa: FBT003


def _rejected(path: Path, message: str) -> CellRejectedError:
    fix = "Give a URDF file (run xacro first if the file ends in .xacro)."
    where = path.name or str(path)
    return CellRejectedError(
        str(path), [Problem(code="R1", severity="E", where=where, message=message, fix=fix)]
    )
