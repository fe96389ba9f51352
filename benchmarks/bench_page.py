"""What a picture of the page costs: JavaScript per frame and draw calls, as Chromium measures them.

.venv/bin/python benchmarks/bench_page.py [COMPONENTS ...]

The scene is that of examples/four_arms and of the wooden frame, filled up with pieces of its own
shapes to a wanted number; everything else is the real page before a real server. Software WebGL:
read the script's time, not the picture's.
"""

from __future__ import annotations

import statistics
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))
sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))  # its server and browser

from builders_page import READY, Seen, ServedProject, browser, filled_up, look
from sitewright.app.project import new_project

FRAMES = 60
_TURN = """frames => new Promise((done) => {
  __m.costs.length = 0;
  const canvas = document.querySelector('canvas');
  const box = canvas.getBoundingClientRect();
  canvas.setPointerCapture = canvas.releasePointerCapture = () => undefined;
  const send = (kind, x) => canvas.dispatchEvent(new PointerEvent(kind, {
    clientX: box.x + x, clientY: box.y + 200, pointerId: 1, button: 0, buttons: 1,
    pointerType: 'mouse', bubbles: true }));
  send('pointerdown', 200);
  let n = 0;
  const turn = () => {
    n += 1;
    send(n > frames ? 'pointerup' : 'pointermove', 200 + n);
    if (n > frames) done();
    else requestAnimationFrame(turn);
  };
  turn();
})"""


def main(counts: list[int]) -> None:
    """Print one line per example and number of components."""
    with tempfile.TemporaryDirectory() as folder, browser() as chromium:
        for example in ("wooden_frame", "four_arms"):
            project = new_project(Path(folder) / example, example=example)
            with ServedProject(project) as served:
                seen = look(chromium, served)
                seen.open()
                for count in counts:
                    print(f"{example}: {_costs(seen, count)}")


def _costs(seen: Seen, count: int) -> str:
    page = seen.page

    page.unroute("**/api/scene")
    page.route("**/api/scene", filled_up(count))
    page.goto(f"{seen.served.origin}/?dpr=1")
    page.wait_for_function(READY, timeout=60_000)
    page.evaluate(_TURN, FRAMES)
    costs = page.evaluate("() => __m.costs")
    calls = page.evaluate("() => __m.cost.calls")
    robots = len(seen.json("/api/scene")["robots"])
    middle, worst = statistics.median(costs), sorted(costs)[int(len(costs) * 0.95) - 1]
    return (
        f"{robots} robots, {count} components: JavaScript {middle:.1f} ms a picture "
        f"(95 % below {worst:.1f} ms), {calls} draw calls, {len(costs)} pictures"
    )


if __name__ == "__main__":
    main([int(a) for a in sys.argv[1:]] or [100, 1000])
