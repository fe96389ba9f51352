"""The server as a process: signals end it in order."""

from __future__ import annotations

import os
import signal

import pytest
import uvicorn

from sitewright.app.serving.server import EndingServer


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_is_the_wish_to_end_and_not_raised_again(number: signal.Signals) -> None:
    server = EndingServer(uvicorn.Config(app="none:none"), lambda: None)
    before = signal.getsignal(number)
    with server.capture_signals():
        os.kill(os.getpid(), number)
        assert server.should_exit
    assert signal.getsignal(number) is before
