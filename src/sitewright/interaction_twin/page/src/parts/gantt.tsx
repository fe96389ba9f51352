// Who does what when: the server's picture of the schedule, with the moment as a line.
import { useEffect, useRef, useState } from "preact/hooks";
import { worked } from "../state/schedule";
import { setTime } from "../state/playing";
import { inLanguage } from "../state/server";
import { mode, proposal, replay, run, selectedStep, selectStep, time_s } from "../state/store";
import { say } from "../words/words";
import { Drawing } from "./drawing";

const WIDTHS_PX = 16;

export function Gantt() {
  const [box, width] = useWidth();
  const { path, at_s, kinds, isSelected, choose } = shown();
  return (
    <div class="strip" ref={box}>
      <Drawing
        kind="gantt"
        label={say("gantt.label")}
        path={path === null || width === 0 ? null : `${inLanguage(path)}&width=${width}`}
        revision={worked.value}
        items={(picture) => [...picture.querySelectorAll<SVGElement>(kinds)].sort((a, b) => startOf(a) - startOf(b) || stepOf(a) - stepOf(b))}
        isSelected={isSelected}
        onPick={choose}
        onDrawn={(picture) => drawMoment(picture, at_s)}
      />
    </div>
  );
}

interface Shown {
  path: string | null;
  /** Where the line of the moment is; null without one. */
  at_s: number | null;
  /** Which bars can be selected. */
  kinds: ".actual" | "[data-step]";
  isSelected: (bar: SVGElement) => boolean;
  choose: (bar: SVGElement) => void;
}

/** The schedule of the run that is looked at again, of the open plan, else of the whole run. */
function shown(): Shown {
  const then = replay.value;
  const at_s = mode.value === "preview" || then !== null ? time_s.value : null;
  if (then !== null) {
    const begun = new Set(then.skillsAt(time_s.value).map((skill) => skill.starts_s.toFixed(3)));
    return { path: `/api/runs/${then.record.run}/schedule.svg`, at_s, kinds: ".actual", isSelected: (bar) => begun.has(bar.dataset["startsS"] ?? ""), choose: (bar) => setTime(startOf(bar)) };
  }
  const plan = proposal.value;
  if (plan !== null) {
    const selected = selectedStep.value;
    return { path: `/api/proposals/${plan.fingerprint}/schedule.svg`, at_s, kinds: "[data-step]", isSelected: (bar) => stepOf(bar) === selected, choose };
  }
  const name = run.value?.run ?? "";
  return { path: name === "" ? null : `/api/runs/${name}/schedule.svg`, at_s: null, kinds: ".actual", isSelected: () => false, choose: () => undefined };
}

const stepOf = (bar: SVGElement): number => Number(bar.dataset["step"]);
const startOf = (bar: SVGElement): number => Number(bar.dataset["startsS"]);

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
