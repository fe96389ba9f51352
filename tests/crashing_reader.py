"""A reader that misbehaves as its file's name says; run by the import tests as a child."""

from __future__ import annotations

import os
import signal
import sys
import time
from pathlib import Path

from sitewright.building_model.formats.import_process import limit_own_resources


def main(limits: str, path: str) -> None:
    limit_own_resources(limits)
    match Path(path).stem:
        case "crash":
            os.kill(os.getpid(), signal.SIGSEGV)
        case "hang":
            time.sleep(600)
        case "memory":
            sys.stdout.write(str(len(bytearray(8 * 1024**3))))
        case "cpu":
            while True:
                pass
        case "disk":
            Path(path).with_suffix(".out").write_bytes(b"x" * 4 * 1024**2)
        case "half":
            sys.stdout.write('{"parts": [')
        case _:
            sys.stdout.write('{"answer": 42}')


if __name__ == "__main__":
    main(*sys.argv[1:])
