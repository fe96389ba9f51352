"""What pages get: texts in order and complete, of the frames the newest; who is far behind goes."""

from __future__ import annotations

import asyncio
import json

from sitewright.interaction_twin.web.frames import joints_frame, poses_frame
from sitewright.interaction_twin.web.hub import MOST_UNSENT_BYTES, Hub, Listener
from sitewright.interaction_twin.web.twin import News


def frame(sequence: int) -> bytes:
    return joints_frame([0.0], epoch=1, sequence=sequence, t_ms=0.0)


def drained(listener: Listener, count: int) -> list[str | bytes]:
    async def drain() -> list[str | bytes]:
        return [await listener.next() for _ in range(count)]

    return asyncio.run(drain())


def counted(n: int) -> News:
    return lambda language: {"n": n, "language": language}


def test_texts_come_in_order_before_the_newest_frame_of_each_kind() -> None:
    hub, listener = Hub(), Listener()
    hub.join(listener)
    poses = poses_frame([], epoch=1, sequence=9, t_ms=0.0)
    for n in range(3):
        hub.show(frame(n))
        hub.tell(counted(n))
    hub.show(poses)
    found = drained(listener, 5)
    assert [json.loads(t)["n"] for t in found[:3]] == [0, 1, 2]
    assert found[3:] == [frame(2), poses]
    hub.leave(listener)
    hub.tell(counted(9))
    assert not listener.texts
    assert hub.size == 0


def test_a_page_that_is_too_far_behind_is_known_and_does_not_hold_up_the_others() -> None:
    hub, slow, quick = Hub(), Listener(), Listener()
    hub.join(slow)
    hub.join(quick)
    text = "x" * 10_000
    for _ in range(MOST_UNSENT_BYTES // len(text) + 1):
        assert not quick.is_behind
        hub.tell(lambda _: {"text": text})
        drained(quick, 1)
    assert slow.is_behind
    assert not quick.is_behind


def test_each_page_is_told_in_its_own_language() -> None:
    hub, english, german = Hub(), Listener(), Listener(language="de")
    hub.join(english)
    hub.join(german)
    hub.tell(counted(1))
    told = [json.loads(str(drained(page, 1)[0]))["language"] for page in (english, german)]
    assert told == ["en", "de"]
