"""The process beside the server's event loop."""

from __future__ import annotations

import asyncio
import os
import signal

from sitewright.app.serving.side_work import SideWork


def test_a_ctrl_c_of_the_terminal_does_not_reach_it() -> None:
    async def interrupted() -> tuple[int, int]:
        side = SideWork()
        try:
            first = await side.do(os.getpid)
            await side.do(signal.raise_signal, signal.SIGINT)
            return first, await side.do(os.getpid)
        finally:
            side.close()

    first, second = asyncio.run(interrupted())
    assert first == second != os.getpid()
