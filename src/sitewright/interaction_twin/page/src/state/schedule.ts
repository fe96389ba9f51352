// What really ran of the open plan, on the plan's own clock.
import { computed } from "@preact/signals";
import type { GanttBar } from "../parts/gantt";
import { events, proposal, robotNumber, run } from "./store";

interface Started {
  step: number;
  robot: string;
  at_ms: number;
}

/** Bars of the steps that were started since the page knows of them. */
export const actual = computed<readonly GanttBar[]>(() => {
  const plan = proposal.value;
  if (plan === null) return [];
  const started = new Map<string, Started>();
  const bars: GanttBar[] = [];
  let zero_ms = 0;
  for (const event of events.value) {
    const body = (event.body ?? {}) as Record<string, unknown>;
    const command = String(body["command_id"] ?? "");
    if (event.kind === "skill_intent" && body["fingerprint"] === plan.fingerprint) {
      const number = Number(body["step"]);
      const known = plan.steps.find((s) => s.number === number);
      if (known === undefined) continue;
      if (zero_ms === 0) zero_ms = event.at_ms - known.starts_s * 1000;
      started.set(command, { step: number, robot: known.robot, at_ms: event.at_ms });
    } else if (event.kind === "skill_outcome" && started.has(command)) {
      const begun = started.get(command);
      started.delete(command);
      if (begun !== undefined) bars.push(bar(begun, (event.at_ms - begun.at_ms) / 1000, zero_ms, body["is_done"] !== false));
    }
  }
  const now_ms = events.value.at(-1)?.at_ms ?? 0;
  for (const begun of started.values()) {
    if (run.value?.running?.step === begun.step) bars.push(bar(begun, Math.max((now_ms - begun.at_ms) / 1000, 0.2), zero_ms, true));
  }
  return bars;
});

function bar(begun: Started, duration_s: number, zero_ms: number, isDone: boolean): GanttBar {
  return {
    key: `a${begun.step} ${begun.at_ms}`,
    robot: begun.robot,
    robotNumber: robotNumber(begun.robot),
    starts_s: Math.max((begun.at_ms - zero_ms) / 1000, 0),
    duration_s,
    words: `${begun.step}`,
    step: begun.step,
    isActual: true,
    isDone,
  };
}
