"""Makes the environments of the other planners in a cache folder; the project's locks know nothing.

    python -m benchmarks.motion.environments

OMPL goes to a folder of its own that is added to the path; mplib needs another numpy, and gets a
virtual environment. The folder is $SITEWRIGHT_BENCH_CACHE, else ~/.cache/sitewright-bench.
"""

from __future__ import annotations

import os
import subprocess
import sys
import venv
from pathlib import Path

OMPL = "ompl==2.0.1"
MPLIB = ("mplib==0.2.1", "numpy==1.26.4", "scipy")


def cache_folder() -> Path:
    """Return where the environments are."""
    return Path(
        os.environ.get("SITEWRIGHT_BENCH_CACHE", Path.home() / ".cache" / "sitewright-bench")
    )


def ompl_folder() -> Path:
    """Return the folder to add to the path for OMPL."""
    return cache_folder() / "ompl"


def mplib_python() -> Path:
    """Return the Python that has mplib."""
    return cache_folder() / "mplib" / "bin" / "python"


def main() -> int:
    """Make what is missing."""
    if not ompl_folder().is_dir():
        _pip(Path(sys.executable), "--no-deps", "--target", str(ompl_folder()), OMPL)
    if not mplib_python().exists():
        venv.create(cache_folder() / "mplib", with_pip=True)
        _pip(mplib_python(), *MPLIB)
    print(f"ready in {cache_folder()}")
    return 0


def _pip(python: Path, *arguments: str) -> None:
    subprocess.run([str(python), "-m", "pip", "install", "--quiet", *arguments], check=True)


if __name__ == "__main__":
    sys.exit(main())
