// What really ran of the open plan, beside what was planned, on the cell's clock.
import { computed } from "@preact/signals";
import type { GanttBar } from "../parts/gantt";
import type { RunEvent, StepRecord } from "../wire";
import { events, proposal, robotNumber } from "./store";

interface Intent {
  command_id: string;
  fingerprint: string;
  step: number;
}

interface Outcome {
  command_id: string;
  report: { is_done: boolean; duration_s: number };
}

/** Bars of the steps that have ended since this page was opened, one after the other as they were started. */
export const actual = computed<readonly GanttBar[]>(() => {
  const plan = proposal.value;
  if (plan === null) return [];
  const stepByCommand = new Map<string, StepRecord>();
  const bars: GanttBar[] = [];
  let now_s = 0;
  for (const event of events.value) {
    const begun = begunStep(event, plan.fingerprint, plan.steps);
    if (begun !== null) {
      stepByCommand.set(...begun);
      if (bars.length === 0) now_s = begun[1].starts_s;
    }
    if (event.kind !== "skill_outcome") continue;
    const outcome = event.body as Outcome;
    const step = stepByCommand.get(outcome.command_id);
    if (step === undefined) continue;
    bars.push(barOf(step, event.n, now_s, outcome));
    now_s += outcome.report.duration_s;
  }
  return bars;
});

function begunStep(event: RunEvent, fingerprint: string, steps: readonly StepRecord[]): [string, StepRecord] | null {
  if (event.kind !== "skill_intent") return null;
  const intent = event.body as Intent;
  const step = steps.find((s) => s.number === intent.step);
  return intent.fingerprint === fingerprint && step !== undefined ? [intent.command_id, step] : null;
}

function barOf(step: StepRecord, n: number, starts_s: number, { report }: Outcome): GanttBar {
  return {
    key: `a${n}`,
    robot: step.robot,
    robotNumber: robotNumber(step.robot),
    starts_s,
    duration_s: report.duration_s,
    words: `${step.number}. ${step.robot_name} ${step.words}`,
    step: step.number,
    isActual: true,
    isDone: report.is_done,
  };
}
