// Who does what when: planned as outlines, actual as solid bars, the moment as a line.
import type { JSX } from "preact";
import { robotColour } from "../cell/looks";
import { setTime } from "../state/playing";
import { mode, selectedStep, selectStep, time_s } from "../state/store";
import { say } from "../words/words";

export interface GanttBar {
  key: string;
  robot: string;
  robotNumber: number;
  starts_s: number;
  duration_s: number;
  words: string;
  step: number | null;
  isActual: boolean;
  isDone: boolean;
}

const LANE = 15;
const GAP = 8;
const WIDTH = 1000;

export function Gantt({ bars, robots, end_s }: { bars: readonly GanttBar[]; robots: readonly { id: string; number: number }[]; end_s: number }) {
  const span = Math.max(end_s, 1);
  const x = (seconds: number): number => ((WIDTH - 3) * seconds) / span;
  const top = (robot: string): number => 4 + robots.findIndex((r) => r.id === robot) * (2 * LANE + GAP);
  const height = 4 + robots.length * (2 * LANE + GAP) + 18;
  return (
    <div class="gantt" role="group" aria-label={say("gantt.label")} tabIndex={0} onKeyDown={(event) => walk(event, bars)}>
      <svg viewBox={`0 0 ${WIDTH} ${height}`} preserveAspectRatio="none" height={height} aria-hidden="true">
        {robots.map((robot) => (
          <rect key={robot.id} x={0} y={top(robot.id)} width={WIDTH} height={2 * LANE} class="lane" rx="3" />
        ))}
        {ticks(span).map((tick) => (
          <line key={tick} x1={x(tick)} x2={x(tick)} y1={0} y2={height - 16} class="tick" />
        ))}
        {bars.map((bar) => (
          <Box key={bar.key} bar={bar} x={x(bar.starts_s)} width={Math.max(x(bar.starts_s + bar.duration_s) - x(bar.starts_s), 2)} y={top(bar.robot) + (bar.isActual ? LANE : 0)} />
        ))}
        {mode.value === "preview" && <line x1={x(time_s.value)} x2={x(time_s.value)} y1={0} y2={height - 14} class="moment" />}
      </svg>
      {robots.map((robot, index) => (
        <span key={robot.id} class="lane-name" style={{ top: `${4 + index * (2 * LANE + GAP) + LANE - 11}px`, background: robotColour(robot.number - 1) }}>
          {robot.number}
        </span>
      ))}
      {ticks(span).map((tick) => (
        <span key={tick} class="tick-name" style={{ left: `calc(32px + (100% - 44px) * ${x(tick) / WIDTH})` }}>
          {tick} s
        </span>
      ))}
    </div>
  );
}

/** Left and right go from step to step. */
function walk(event: KeyboardEvent, bars: readonly GanttBar[]): void {
  const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
  const steps = bars.filter((bar) => bar.step !== null && !bar.isActual);
  if (by === 0 || steps.length === 0) return;
  event.preventDefault();
  const at = steps.findIndex((bar) => bar.step === selectedStep.value);
  choose(steps[Math.min(Math.max(at + by, 0), steps.length - 1)]);
}

function choose(bar: GanttBar | undefined): void {
  if (bar?.step == null) return;
  selectStep(bar.step);
  if (mode.value === "preview") setTime(bar.starts_s);
}

function Box({ bar, x, y, width }: { bar: GanttBar; x: number; y: number; width: number }): JSX.Element {
  const colour = robotColour(bar.robotNumber - 1);
  const isSelected = bar.step !== null && bar.step === selectedStep.value;
  return (
    <rect
      x={x + 0.5}
      y={y + 1.5}
      width={Math.max(width - 1, 1)}
      height={LANE - 3}
      rx="2"
      fill={bar.isActual ? (bar.isDone ? colour : "#b3261e") : isSelected ? colour : "#ffffff"}
      fill-opacity={bar.isActual ? 1 : isSelected ? 0.35 : 0.9}
      stroke={isSelected ? "#0f3b4a" : colour}
      stroke-width={isSelected ? 2.2 : 1.3}
      vector-effect="non-scaling-stroke"
      class={bar.step === null ? "" : "pick"}
      data-bar={bar.step ?? undefined}
      onClick={() => choose(bar)}
    >
      <title>{bar.words}</title>
    </rect>
  );
}

function ticks(end_s: number): number[] {
  const step = [1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1800, 3600].find((s) => end_s / s <= 8) ?? 7200;
  return Array.from({ length: Math.floor(end_s / step) + 1 }, (_, index) => index * step);
}
