// The run that is looked at again: its record, and what of its plans and motions has come.
import { effect, signal } from "@preact/signals";
import { Replay } from "../preview/replay";
import type { Trajectory } from "../preview/trajectory";
import type { Proposal, ReplayRecord } from "../wire";
import { trajectory } from "./playing";
import { ask, inLanguage } from "./server";
import { replay, scene, time_s } from "./store";

/** Counts what has come: the picture of the same time is another one then. */
export const arrived = signal(0);

const plans = new Map<string, Proposal>();
const trajectories = new Map<string, Trajectory>();
const underWay = new Set<string>();
const record = signal<ReplayRecord | null>(null);

export function chooseReplay(chosen: ReplayRecord | null): void {
  record.value = chosen;
}

/** Keeps the replay that of the chosen run in the present scene, and fetches what it needs. */
export function followReplay(): () => void {
  const ends = [
    effect(() => {
      const known = scene.value;
      replay.value = record.value === null || known === null ? null : new Replay(record.value, known, { plans, trajectories });
    }),
    effect(() => {
      const shown = replay.value;
      if (shown === null) return;
      for (const { fingerprint } of shown.skillsAt(time_s.value)) void fetchPlan(fingerprint);
    }),
  ];
  return () => ends.forEach((end) => end());
}

async function fetchPlan(fingerprint: string): Promise<void> {
  if (underWay.has(fingerprint)) return;
  underWay.add(fingerprint);
  try {
    const plan = await ask<Proposal>(inLanguage(`/api/proposals/${fingerprint}`));
    const hashes = [...new Set(plan.steps.flatMap((step) => step.motions.map((motion) => motion.trajectory_sha256)))];
    await Promise.all(hashes.map(async (hash) => void trajectories.set(hash, await trajectory(hash))));
    plans.set(fingerprint, plan);
    arrived.value += 1;
  } catch {
    underWay.delete(fingerprint); // sensed moments are shown without it; asked again when it is needed again
  }
}
