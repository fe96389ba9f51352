// What really ran of the open plan, beside what was planned; both from the server, on one clock.
import { computed, effect, signal } from "@preact/signals";
import type { GanttBar } from "../parts/gantt";
import type { Bar, Proposal } from "../wire";
import { ask, inLanguage } from "./server";
import { events, proposal, robotNumber } from "./store";

const bars = signal<readonly Bar[]>([]);
const TOLD = new Set(["skill_outcome", "skill_intent", "run_started"]);
const REST_MS = 250;

/** Asks for the schedule when something began or ended; never more often than four times a second. */
export function followSchedule(): () => void {
  let asked = 0;
  const load = (): void => {
    asked = 0;
    ask<{ actual: Bar[] }>(inLanguage("/api/schedule")).then(
      (answer) => (bars.value = answer.actual),
      () => (bars.value = []),
    );
  };
  load();
  return effect(() => {
    const last = events.value.at(-1);
    if (last !== undefined && TOLD.has(last.kind) && asked === 0) asked = window.setTimeout(load, REST_MS);
  });
}

/** Bars of the open plan's steps that ran, shifted to the plan's own start. */
export const actual = computed<readonly GanttBar[]>(() => {
  const plan = proposal.value;
  return plan === null ? [] : barsOf(plan, bars.value);
});

export function barsOf(plan: Proposal, all: readonly Bar[]): GanttBar[] {
  const own = all.filter((bar) => bar.fingerprint === plan.fingerprint);
  const first = own[0];
  const planned = plan.steps.find((s) => s.number === first?.step);
  const shift_s = first === undefined || planned === undefined ? 0 : first.starts_s - planned.starts_s;
  return own.map((bar, index) => ({
    key: `a${index}`,
    robot: bar.robot,
    robotNumber: robotNumber(bar.robot),
    starts_s: Math.max(bar.starts_s - shift_s, 0),
    duration_s: bar.duration_s,
    words: `${bar.step}. ${bar.words}`,
    step: bar.step,
    isActual: true,
    isDone: bar.is_done,
  }));
}
