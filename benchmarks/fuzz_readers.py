"""Seeded mutations of real design files through every reader: what is refused, accepted, unhandled.

SITEWRIGHT_DATA=DATA .venv/bin/python benchmarks/fuzz_readers.py [SHARE] [SEED] [READER ...]

SHARE scales the number of inputs (1 = about 3,000). What is accepted must also be checked, be
written as building.json and be read back. Unhandled inputs are kept in ./fuzz_unhandled.
"""

from __future__ import annotations

import json
import os
import random
import re
import resource
import shutil
import sys
import tempfile
import traceback
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))  # its builders of files

from builders_foreign import ASSEMBLY, BARS, BTLX, NATIVE, OBJ
from sitewright.app import importing
from sitewright.app.checking import check
from sitewright.app.importing import ImportOptions
from sitewright.building_model.formats import foreign_files
from sitewright.building_model.formats.detect import FileKind, kind_of, refused
from sitewright.building_model.formats.native import read_as_written, write_building
from sitewright.building_model.formats.neutral import NeutralFile
from sitewright.building_model.formats.neutral_records import BadRecordsError, neutral_of
from sitewright.errors import ModelRejectedError
from sitewright.interaction_twin.problem_lines import problem_lines

CPU_S, MEMORY_BYTES = 60, 4 * 1024**3
KEPT = Path("fuzz_unhandled")
REFUSED, ACCEPTED, OTHER = 0, 1, 2
EXAMPLE = Path(__file__).parents[1] / "examples"
IN_CHILD = (FileKind.RHINO, FileKind.IFC)
"""Read as the command line does it; the other readers run in a fork that has them loaded."""
WITHOUT_UNIT = (FileKind.OBJ, FileKind.COMPAS_ASSEMBLY, FileKind.COMPAS_TIMBER)
COUNTS = {
    FileKind.BTLX: 500,
    FileKind.OBJ: 500,
    FileKind.COMPAS_ASSEMBLY: 400,
    FileKind.BAR_FRAME: 450,
    FileKind.NATIVE: 450,
    FileKind.COMPAS_TIMBER: 250,
    FileKind.RHINO: 250,
    FileKind.IFC: 250,
}
EXTREMES = (
    *(b"0", b"-0", b"-1", b"1e-320", b"1e30", b"-1e30", b"1e308", b"1e400", b"NaN", b"Infinity"),
    *(b"2147483647", b"2147483648", b"-2147483649", b"4294967296", b"18446744073709551616"),
    *(b"9" * 400, b"0.1e", b"1_000", b"0x10", b"\xd9\xa3", b"1,5", b""),
)
NASTY = (
    b"\x00",
    b"\xff\xfe",
    b"\xed\xa0\x80",
    b"\x1b[2J",
    b"\xe2\x80\xae",
    b"]]>",
    b'"',
    b"{",
    b"<!DOCTYPE x>",
)
_ENDS, _FEW = 0.3, 3
TOKEN = re.compile(rb"[A-Za-z_][\w.]*|-?\d[\d.eE+-]*|[^\w\s]")
NUMBER = re.compile(rb"-?\d[\d.eE+-]*")


@dataclass(slots=True)
class Figures:
    """What became of the inputs of one reader."""

    inputs: int = 0
    outcomes: list[int] = field(default_factory=lambda: [0, 0, 0])
    worst_s: float = 0.0
    worst_mb: float = 0.0


def main() -> int:
    """Print a line per reader and return 0 if nothing was unhandled."""
    share = float(sys.argv[1]) if len(sys.argv) > 1 else 1.0
    seed = int(sys.argv[2]) if sys.argv[2:] else 1
    wanted = sys.argv[3:] or [str(kind) for kind in COUNTS]
    print("| reader | inputs | refused | accepted | unhandled | worst CPU, s | worst memory, MB |")
    print("|---|--:|--:|--:|--:|--:|--:|")
    unhandled = 0
    with tempfile.TemporaryDirectory() as name:
        for kind, seeds in seeds_of(Path(name)).items():
            if kind not in wanted:
                continue
            figures = fuzzed(kind, seeds, int(COUNTS[kind] * share), seed, Path(name))
            unhandled += figures.outcomes[OTHER]
            told = " | ".join(str(n) for n in figures.outcomes)
            print(
                f"| {kind} | {figures.inputs} | {told} | {figures.worst_s:.1f} | "
                f"{figures.worst_mb:.0f} |",
                flush=True,
            )
    return 1 if unhandled else 0


def seeds_of(folder: Path) -> dict[FileKind, list[bytes]]:
    """Return real files of each kind, and small ones in which a mutation hits what matters."""
    data = Path(os.environ["SITEWRIGHT_DATA"])
    found: dict[FileKind, list[bytes]] = {kind: [] for kind in COUNTS}
    files = [
        *(data / "timber").glob("frame_house.*"),
        *(data / "masonry").glob("*.*"),
        *(data / "bars").glob("*.json"),
        *EXAMPLE.glob("*/building.json"),
    ]
    for content in [*(f.read_bytes() for f in files), BTLX, OBJ, ASSEMBLY, BARS, NATIVE]:
        found[kind_of(content)].append(content)
    found[FileKind.RHINO] = [_drawing(folder / "seed.3dm"), *_drawn(data)]
    found[FileKind.IFC] = _ifc(folder / "seed.ifc")
    return found


def _drawing(path: Path) -> bytes:
    import builders_rhino

    drawing = builders_rhino.Drawing()
    corners = [(0.0, 0.0, 0.0), (90.0, 0.0, 0.0), (90.0, 45.0, 0.0), (0.0, 45.0, 0.0)]
    block = drawing.block("stud", builders_rhino.extrusion(corners, 1000.0))
    for n in range(3):
        drawing.add(builders_rhino.instance(block, builders_rhino.moved(0, 200.0 * n, 0)))
    box = builders_rhino.brep_box((0.0, 0.0, 0.0), (900.0, 90.0, 45.0))
    drawing.add(box, name="plate", text={"sitewright.order": "1"}, group="wall")
    return drawing.write(path).read_bytes()


def _drawn(data: Path) -> list[bytes]:
    return [(data / "rhino" / "layer_template.3dm").read_bytes()]


def _ifc(path: Path) -> list[bytes]:
    from builders_ifc import framed_walls, lying_frame, wall_panel

    return [d.write(path).read_bytes() for d in (wall_panel(), framed_walls(), lying_frame())]


def fuzzed(kind: FileKind, seeds: list[bytes], count: int, seed: int, folder: Path) -> Figures:
    """Return the figures of some mutants of a kind."""
    chance = random.Random(f"{seed} {kind}")  # noqa: S311 - repeatable, no secret
    if kind is FileKind.COMPAS_TIMBER:
        import compas_timber.model  # noqa: F401 - once, not in each fork
    figures = Figures()
    for number in range(count):
        content = mutated(chance.choice(seeds), chance)
        file = folder / f"{number}.{kind}"
        file.write_bytes(content)
        outcome, seconds, memory_mb = in_fork(file, kind)
        figures.inputs += 1
        figures.outcomes[outcome] += 1
        figures.worst_s = max(figures.worst_s, seconds)
        figures.worst_mb = max(figures.worst_mb, memory_mb)
        if outcome == OTHER:
            KEPT.mkdir(exist_ok=True)
            file.rename(KEPT / file.name)
        else:
            file.unlink()
    return figures


def mutated(content: bytes, chance: random.Random) -> bytes:
    """Return the content after one to four mutations."""
    for _ in range(chance.choice((1, 1, 1, 2, 4))):
        content = chance.choice(MUTATIONS)(content, chance)
    return content


def _flipped(content: bytes, chance: random.Random) -> bytes:
    changed = bytearray(content)
    for _ in range(chance.choice((1, 2, 8, 64))):
        if changed:
            changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def _cut(content: bytes, chance: random.Random) -> bytes:
    low, high = sorted((chance.randrange(len(content) + 1), chance.randrange(len(content) + 1)))
    if chance.random() < _ENDS:
        return content[:high]
    return content[:low] + content[min(high, low + chance.choice((1, 4, 40, 4000))) :]


def _swapped(content: bytes, chance: random.Random) -> bytes:
    tokens = list(TOKEN.finditer(content))
    if not tokens:
        return content
    one, two = sorted(chance.choices(range(len(tokens)), k=2))
    a, b = tokens[one], tokens[two]
    if one == two:
        return content
    return content[: a.start()] + b[0] + content[a.end() : b.start()] + a[0] + content[b.end() :]


def _extreme(content: bytes, chance: random.Random) -> bytes:
    numbers = list(NUMBER.finditer(content))
    if not numbers:
        return content
    hit = chance.choice(numbers)
    return content[: hit.start()] + chance.choice(EXTREMES) + content[hit.end() :]


def _doubled(content: bytes, chance: random.Random) -> bytes:
    lines = content.splitlines(keepends=True)
    if len(lines) < _FEW:
        lines = re.split(rb"(?<=[,>])", content)
    at = chance.randrange(len(lines))
    span = lines[at : at + chance.choice((1, 1, 3))]
    times = chance.choice((1, 2, 200))
    return b"".join(lines[:at] + span * times + lines[at:])[:3_000_000]


def _nasty(content: bytes, chance: random.Random) -> bytes:
    at = chance.randrange(len(content) + 1)
    return content[:at] + chance.choice(NASTY) + content[at:]


def _int32(content: bytes, chance: random.Random) -> bytes:
    """Put an extreme binary count, as .3dm holds them."""
    at = chance.randrange(len(content) + 1)
    word = chance.choice((0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0, 0x40000000)).to_bytes(4, "little")
    return content[:at] + word + content[at + 4 :]


MUTATIONS: tuple[Callable[[bytes, random.Random], bytes], ...] = (
    *(_flipped, _cut, _swapped, _swapped, _extreme, _extreme, _doubled, _nasty, _int32),
)


def in_fork(file: Path, kind: FileKind) -> tuple[int, float, float]:
    """Return the outcome of one input, its processor seconds and its most memory in MB."""
    pid = os.fork()
    if pid == 0:
        os._exit(_outcome(file, kind))
    _, status, used = os.wait4(pid, 0)
    code = os.waitstatus_to_exitcode(status)
    seconds = used.ru_utime + used.ru_stime
    if code not in (REFUSED, ACCEPTED, OTHER):
        print(f"unhandled: {file.name} ended with {code}", file=sys.stderr)
        code = OTHER
    return code, seconds, used.ru_maxrss / 1000.0


def _outcome(file: Path, kind: FileKind) -> int:
    if kind not in IN_CHILD:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
        resource.setrlimit(resource.RLIMIT_CPU, (CPU_S, CPU_S))
        setattr(importing, "read_foreign", _read_here)  # noqa: B010 - it is private there
    try:
        _survive(file)
    except ModelRejectedError as error:
        problems = error.problems
        is_clear = problems and all(p.code and p.where and p.message for p in problems)
        is_left = (file.parent / "project").exists()
        return REFUSED if is_clear and not is_left else OTHER
    except BaseException:  # noqa: BLE001 - what it looks for
        print(f"unhandled: {file.name}", file=sys.stderr)
        traceback.print_exc()
        return OTHER
    finally:
        shutil.rmtree(file.parent / "project", ignore_errors=True)
    return ACCEPTED


def _survive(file: Path) -> None:
    """Import, check, write and read again.

    Raises:
        ModelRejectedError: The import refuses it.
    """
    project = file.parent / "project"
    has_no_unit = kind_of(file.read_bytes()) in WITHOUT_UNIT
    importing.import_file(file, project, ImportOptions(unit="mm" if has_no_unit else None))
    written = project / "building.json"
    try:
        model, _ = read_as_written(written)
        problems = check(project)
    except ModelRejectedError as error:
        raise RuntimeError(f"what was written cannot be read: {error}") from error
    if lines := [line for line in problem_lines(problems) if not line.isprintable()]:
        raise RuntimeError(f"a line steers the terminal: {lines[0]!r}")
    first = written.read_bytes()
    write_building(model, written)
    if written.read_bytes() != first:
        raise RuntimeError("what was written is not what was read")


def _read_here(path: Path, kind: FileKind, **_: object) -> NeutralFile:
    """Read as `foreign_files.read_foreign` does, in this process."""
    told = json.dumps(foreign_files.answer(str(kind), str(path)), allow_nan=False)
    try:
        return neutral_of(json.loads(told))
    except BadRecordsError as error:
        raise refused(path, "E2", f"{error}.", "Repair it.") from None


if __name__ == "__main__":
    sys.exit(main())
