"""Import, check and inference of walls of many members, as the command line does them: medians.

.venv/bin/python benchmarks/bench_import.py [RUNS]

The IFC files are written by ifcopenshell (extra [ifc]), the BTLx files by hand.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))  # its builders of files

SITEWRIGHT = str(Path(sys.executable).with_name("sitewright"))
STUDS_PER_PANEL = 15
_STUD_MM = (2400.0, 95.0, 45.0)
_SPACING_MM = 622.5
_PANEL_MM = _SPACING_MM * (STUDS_PER_PANEL - 1) + _STUD_MM[2]
_GAP_MM = 500.0
_ROW = 20
Point = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Member:
    """A sawn piece of a panel: its end, the way it runs, and how long it is, in millimetres."""

    name: str
    start: Point
    along: Point
    length: float


def main() -> int:
    """Print the figures and return 0 if they keep the aims."""
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    kept = True
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for total, commands, aim_s in (
            (425, ("import", "check", "infer"), 5.0),
            (5000, ("import",), 25.0),
        ):
            for kind, write in (("ifc", write_ifc), ("btlx", write_btlx)):
                file = folder / f"{total}.{kind}"
                write(list(members(total)), file)
                kept &= measured(file, total, commands, aim_s, runs)
    return 0 if kept else 1


def measured(file: Path, total: int, commands: tuple[str, ...], aim_s: float, runs: int) -> bool:
    """Print the medians of some commands after each other, and whether they keep the aim."""
    times: dict[str, list[float]] = {c: [] for c in commands}
    peak_mb = 0.0
    for number in range(runs):
        project = file.with_name(f"{file.name}-{number}")
        for command in commands:
            arguments = [str(file), "-o", str(project)] if command == "import" else [str(project)]
            seconds, memory_mb = timed([SITEWRIGHT, command, *arguments])
            times[command].append(seconds)
            peak_mb = max(peak_mb, memory_mb)
    in_all = statistics.median(sum(t) for t in zip(*times.values(), strict=True))
    each = ", ".join(f"{c} {statistics.median(t):.2f}" for c, t in times.items())
    print(
        f"{total} members, {file.suffix}: {in_all:.2f} s (aim {aim_s:g}): {each}; {peak_mb:.0f} MB",
        flush=True,
    )
    return in_all <= aim_s


def timed(command: list[str]) -> tuple[float, float]:
    """Return the wall seconds and the most memory (MB) of one process of a command."""
    begun = time.perf_counter()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
        assert process.stderr is not None  # noqa: S101
        said = process.stderr.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.perf_counter() - begun
    if process.returncode not in {0, 3}:  # 3: a check that finds something
        raise SystemExit(f"{' '.join(command)}: {process.returncode}\n{said.decode()[-2000:]}")
    return seconds, used.ru_maxrss / 1000.0


def members(total: int) -> Iterator[Member]:
    """Yield the members of panels in rows, the last panel perhaps with fewer studs."""
    made = 0
    while made < total:
        panel, made = made // (STUDS_PER_PANEL + 2), made + STUDS_PER_PANEL + 2
        x = (panel % _ROW) * (_PANEL_MM + _GAP_MM)
        y = (panel // _ROW) * 3000.0
        plate = _STUD_MM[2]
        studs = min(STUDS_PER_PANEL, total - made + STUDS_PER_PANEL)
        yield Member(f"bottom {panel}", (x, y, plate / 2), (1.0, 0.0, 0.0), _PANEL_MM)
        for k in range(studs):
            place = (x + plate / 2 + k * _SPACING_MM, y, plate)
            yield Member(f"stud {panel}-{k}", place, (0.0, 0.0, 1.0), _STUD_MM[0])
        top = plate * 1.5 + _STUD_MM[0]
        yield Member(f"top {panel}", (x, y, top), (1.0, 0.0, 0.0), _PANEL_MM)


def write_ifc(pieces: list[Member], file: Path) -> None:
    """Write members as extruded rectangles with property sets, one assembly for all."""
    from builders_ifc import IfcDraft

    draft = IfcDraft(seed="bench")
    made = [draft.member(m.name, m.start, m.along, m.length, PredefinedType="STUD") for m in pieces]
    draft.whole("IfcElementAssembly", "house", made)
    draft.material("C24", made)
    for element in made:
        draft.properties(element, "Pset_MemberCommon", {"Reference": "S1", "IsExternal": True})
    draft.write(file)


def write_btlx(pieces: list[Member], file: Path) -> None:
    """Write members as blanks with a square cut at both ends."""
    parts = "".join(_part(number, m) for number, m in enumerate(pieces, 1))
    head = '<?xml version="1.0" encoding="UTF-8"?>'
    space = 'xmlns="https://www.design2machine.com" Version="2.0.0"'
    file.write_text(f"{head}<BTLx {space}><Project><Parts>{parts}</Parts></Project></BTLx>")


def _part(number: int, member: Member) -> str:
    height, width = _STUD_MM[1:]
    x, y, z = member.start
    if member.along[2]:
        corner, across = (x + width / 2, y - height / 2, z), (0.0, 1.0, 0.0)
    else:
        corner, across = (x, y + height / 2, z + width / 2), (0.0, -1.0, 0.0)
    size = f'Length="{member.length}" Height="{height}" Width="{width}"'
    place = _xyz("ReferencePoint", corner) + _xyz("XVector", member.along) + _xyz("YVector", across)
    cuts = _cut("start", 0.0) + _cut("end", member.length)
    return (
        f'<Part SingleMemberNumber="{number}" Designation="{member.name}" Annotation="stud" '
        f'Material="C24" Count="1" {size}><Transformations><Transformation '
        f'GUID="{{m-{number}}}"><Position>{place}</Position></Transformation></Transformations>'
        f"<Processings>{cuts}</Processings></Part>"
    )


def _cut(end: str, x: float) -> str:
    return (
        f'<JackRafterCut ReferencePlaneID="1"><Orientation>{end}</Orientation><StartX>{x}</StartX>'
        "<Angle>90</Angle><Inclination>90</Inclination></JackRafterCut>"
    )


def _xyz(tag: str, at: Point) -> str:
    return f'<{tag} X="{at[0]}" Y="{at[1]}" Z="{at[2]}"/>'


if __name__ == "__main__":
    sys.exit(main())
