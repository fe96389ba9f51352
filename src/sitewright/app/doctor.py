"""Looks at the machine: what Sitewright needs, what is there, and how to get what is not."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path

from sitewright.errors import BackendError
from sitewright.robot_team.models.catalogue import BUILTIN_ROBOTS, builtin_robot

_MIN_PYTHON = (3, 11)
_MIN_FREE_BYTES = 1_000_000_000
_PLAN_FOUND = "Solution found"
_TASK = """begin_version
3
end_version
begin_metric
0
end_metric
1
begin_variable
var0
-1
2
Atom done()
NegatedAtom done()
end_variable
0
begin_state
1
end_state
begin_goal
1
0 0
end_goal
1
begin_operator
do
0
1
0 0 1 0
1
end_operator
0
"""
_FALLING_BODY = (
    "<mujoco><worldbody><body pos='0 0 1'><freejoint/><geom size='.1'/></body></worldbody></mujoco>"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Check:
    """One thing that was looked at.

    Attributes:
        is_needed: False for extras: Sitewright works without them.
        detail: What was found.
        fix: What to do if it is not in order.
    """

    name: str
    is_ok: bool
    detail: str
    is_needed: bool = True
    fix: str = ""


def diagnose(folder: Path | None = None) -> list[Check]:
    """Return all checks of this machine.

    Args:
        folder: Where projects are; its disk must have room. The working folder by default.
    """
    checks = [_python(), *_packages()]
    probes: list[tuple[str, Callable[[], str]]] = [
        ("Fast Downward finds a plan", _fast_downward),
        ("MuJoCo simulates", _mujoco),
        ("collision engine measures", _coal),
        *((f"arm {name}", partial(_arm, name)) for name in BUILTIN_ROBOTS),
    ]
    checks += [_probed(name, probe) for name, probe in probes]
    return [*checks, _disk(folder or Path.cwd()), _extra("compas_timber", "timber")]


def _python() -> Check:
    found = ".".join(str(n) for n in sys.version_info[:3])
    wanted = ".".join(str(n) for n in _MIN_PYTHON)
    return Check(
        name="Python",
        is_ok=sys.version_info[:2] >= _MIN_PYTHON,
        detail=found,
        fix=f"Install Python {wanted} or newer.",
    )


def _packages() -> list[Check]:
    """Return one check per package that the base installation requires."""
    names = [r.split(";")[0].strip() for r in requires("sitewright") or () if "extra ==" not in r]
    return [_package(_name_of(requirement), requirement) for requirement in names]


def _name_of(requirement: str) -> str:
    cut = min((requirement.find(c) for c in "<>=!~[ " if c in requirement), default=None)
    return requirement if cut is None else requirement[:cut]


def _package(name: str, requirement: str) -> Check:
    fix = f"pip install '{requirement}'"
    try:
        return Check(name=name, is_ok=True, detail=version(name))
    except PackageNotFoundError:
        return Check(name=name, is_ok=False, detail="not installed", fix=fix)


def _probed(name: str, probe: Callable[[], str]) -> Check:
    try:
        return Check(name=name, is_ok=True, detail=probe())
    except (ImportError, OSError, ValueError, BackendError, subprocess.TimeoutExpired) as error:
        fix = "Reinstall Sitewright's packages: pip install --force-reinstall sitewright"
        return Check(name=name, is_ok=False, detail=str(error), fix=fix)


def _fast_downward() -> str:
    from sitewright.symbolic_planning.planners.fast_downward import installation, search_binary

    binary = search_binary(installation())
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(  # noqa: S603 -- our own binary, fixed arguments
            [str(binary), "--search", "astar(blind())"],
            input=_TASK,
            capture_output=True,
            text=True,
            cwd=folder,
            timeout=20,
            check=False,
        )
    if run.returncode != 0 or _PLAN_FOUND not in run.stdout:
        raise BackendError(f"it ended with code {run.returncode}: {run.stderr[-200:]}")
    return str(binary)


def _mujoco() -> str:
    import mujoco

    model = mujoco.MjModel.from_xml_string(_FALLING_BODY)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 100)
    if not data.qpos[2] < 1.0:
        raise BackendError("a body in free fall did not fall")
    return str(mujoco.__version__)


def _coal() -> str:
    import coal
    import numpy as np

    box = coal.Box(1.0, 1.0, 1.0)
    there = coal.Transform3s(np.eye(3), np.array([3.0, 0.0, 0.0]))
    request, result = coal.DistanceRequest(), coal.DistanceResult()
    measured = coal.distance(box, coal.Transform3s(), box, there, request, result)
    if abs(measured - 2.0) > 1e-6:  # noqa: PLR2004 -- two unit boxes, centres 3 m apart
        raise BackendError(f"two boxes 2 m apart were measured as {measured} m")
    return str(coal.__version__)


def _arm(name: str) -> str:
    from sitewright.app.arms import described
    from sitewright.planning_twin.backends.judged_arm import judged
    from sitewright.planning_twin.motion import InverseKind
    from sitewright.robot_team.formats.urdf import read_urdf

    _, verdict = judged(read_urdf(builtin_robot(name)))
    if verdict.kind is InverseKind.ITERATIONS:
        raise BackendError(described(verdict))
    return described(verdict)


def _disk(folder: Path) -> Check:
    free = shutil.disk_usage(folder).free
    return Check(
        name="free disk space",
        is_ok=free >= _MIN_FREE_BYTES,
        detail=f"{free / 1e9:.1f} GB at {folder}",
        fix="Free at least 1 GB; no skill is started with less than 0.5 GB.",
    )


def _extra(package: str, extra: str) -> Check:
    name = f"{package} (extra [{extra}])"
    fix = f"pip install 'sitewright[{extra}]'"
    try:
        return Check(name=name, is_ok=True, is_needed=False, detail=version(package))
    except PackageNotFoundError:
        return Check(name=name, is_ok=False, is_needed=False, detail="not installed", fix=fix)
