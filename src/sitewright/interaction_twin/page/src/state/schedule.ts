// How often robots have begun or ended something: pictures of schedules are asked for anew then.
import { effect, signal } from "@preact/signals";
import { events } from "./store";

const TOLD = new Set(["skill_outcome", "skill_intent", "run_started"]);
const REST_MS = 250;

export const worked = signal(0);

/** Counts what began or ended; never more often than four times a second. */
export function followSchedule(): () => void {
  let asked = 0;
  const count = (): void => {
    asked = 0;
    worked.value = worked.peek() + 1;
  };
  return effect(() => {
    const last = events.value.at(-1);
    if (last !== undefined && TOLD.has(last.kind) && asked === 0) asked = window.setTimeout(count, REST_MS);
  });
}
