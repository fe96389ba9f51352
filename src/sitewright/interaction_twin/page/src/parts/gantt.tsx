// Who does what when: the server's picture of the schedule, with the moment as a line.
import { useEffect, useRef, useState } from "preact/hooks";
import { worked } from "../state/schedule";
import { setTime } from "../state/playing";
import { inLanguage } from "../state/server";
import { mode, proposal, replayed, run, selectedStep, selectStep, time_s } from "../state/store";
import { say } from "../words/words";
import { Drawing } from "./drawing";

const WIDTHS_PX = 16;

export function Gantt() {
  const [box, width] = useWidth();
  const { kind, path } = shown();
  const selected = kind === "plan" ? selectedStep.value : null;
  const at_s = kind === "plan" && mode.value === "preview" ? time_s.value : null;
  return (
    <div class="strip" ref={box}>
      <Drawing
        kind="gantt"
        label={say("gantt.label")}
        path={path === null || width === 0 ? null : `${inLanguage(path)}&width=${width}`}
        revision={worked.value}
        items={(picture) => [...picture.querySelectorAll<SVGElement>("[data-step]")].sort(byStart)}
        isSelected={(bar) => stepOf(bar) === selected}
        onPick={(bar) => kind === "plan" && choose(bar)}
        onDrawn={(picture) => drawMoment(picture, at_s)}
      />
    </div>
  );
}

/** The schedule of the plan that is looked at, else of the whole run. */
function shown(): { kind: "plan" | "run"; path: string | null } {
  const plan = replayed.value ?? proposal.value;
  if (plan !== null) return { kind: "plan", path: `/api/proposals/${plan.fingerprint}/schedule.svg` };
  const name = run.value?.run ?? "";
  return { kind: "run", path: name === "" ? null : `/api/runs/${name}/schedule.svg` };
}

const stepOf = (bar: SVGElement): number => Number(bar.dataset["step"]);
const startOf = (bar: SVGElement): number => Number(bar.dataset["startsS"]);
const byStart = (a: SVGElement, b: SVGElement): number => stepOf(a) - stepOf(b) || startOf(a) - startOf(b);

function choose(bar: SVGElement): void {
  selectStep(stepOf(bar));
  if (mode.value === "preview") setTime(startOf(bar));
}

function drawMoment(picture: SVGSVGElement, at_s: number | null): void {
  picture.querySelector(".moment")?.remove();
  const { left, right, endS } = picture.dataset;
  if (at_s === null || left === undefined || right === undefined || endS === undefined) return;
  const x = Number(left) + ((Number(right) - Number(left)) * Math.min(at_s, Number(endS))) / Number(endS);
  const line = document.createElementNS(picture.namespaceURI, "line") as SVGLineElement;
  for (const [name, value] of Object.entries({ class: "moment", x1: x, x2: x, y1: 0, y2: picture.viewBox.baseVal.height - 14 })) line.setAttribute(name, String(value));
  picture.append(line);
}

/** Returns a box, and how wide it is in steps of a few pixels. */
function useWidth() {
  const box = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0);
  useEffect(() => {
    if (box.current === null) return undefined;
    const watcher = new ResizeObserver(([entry]) => setWidth(Math.floor((entry?.contentRect.width ?? 0) / WIDTHS_PX) * WIDTHS_PX));
    watcher.observe(box.current);
    return () => watcher.disconnect();
  }, []);
  return [box, width] as const;
}
