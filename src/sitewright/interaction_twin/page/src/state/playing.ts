// Loads the exact trajectories of the open plan and plays them.
import { effect, untracked } from "@preact/signals";
import type { CellPicture } from "../cell/picture";
import { documentedStart, Rehearsal, type StartOfPlan } from "../preview/rehearsal";
import type { Replay } from "../preview/replay";
import { readTrajectory, type Trajectory } from "../preview/trajectory";
import type { Proposal, Scene } from "../wire";
import { askBytes } from "./server";
import { isPlaying, mode, proposal, rehearsal, rehearsalTrouble, replay, scene, selectedStep, time_s } from "./store";

const KEPT = new Map<string, Promise<Trajectory>>();

export function trajectory(sha256: string): Promise<Trajectory> {
  let found = KEPT.get(sha256);
  if (found === undefined) {
    found = askBytes(`/api/blobs/${sha256}`).then((bytes) => readTrajectory(bytes, sha256));
    found.catch(() => KEPT.delete(sha256));
    KEPT.set(sha256, found);
  }
  return found;
}

/** Makes a rehearsal of a plan from the bytes that its fingerprint names. */
export async function rehearse(plan: Proposal, picture: CellPicture): Promise<Rehearsal> {
  const hashes = [...new Set(plan.steps.flatMap((s) => s.motions.map((m) => m.trajectory_sha256)))];
  const found = new Map(await Promise.all(hashes.map(async (hash) => [hash, await trajectory(hash)] as const)));
  const { team } = picture;
  if (scene.value === null || team === null) throw new Error("there is no scene yet");
  return new Rehearsal(plan, found, scene.value, startOf(plan, scene.value, picture), team);
}

let kept: { fingerprint: string; start: StartOfPlan } | null = null;

/** Returns how things were when the plan was first seen; while it runs they are elsewhere already. */
function startOf(plan: Proposal, known: Scene, picture: CellPicture): StartOfPlan {
  if (kept?.fingerprint !== plan.fingerprint) {
    kept = { fingerprint: plan.fingerprint, start: { ...documentedStart(known), poses: picture.sensedPoses, done: plan.status === "done" ? Infinity : plan.next_step - 1 } };
  }
  return kept.start;
}

/** Keeps the rehearsal that of the open plan. */
export function followPlan(picture: CellPicture): () => void {
  let shown = "";
  return effect(() => {
    const plan = proposal.value;
    const name = `${plan?.fingerprint} ${scene.value?.hash}`;
    if (name === shown) return;
    shown = name;
    rehearsal.value = null;
    rehearsalTrouble.value = "";
    if (plan === null || scene.value === null) return;
    rehearse(plan, picture).then(
      (made) => {
        if (shown === name) rehearsal.value = made;
      },
      (error: unknown) => {
        rehearsalTrouble.value = error instanceof Error ? error.message : String(error);
      },
    );
  });
}

/** Moves the time while it plays, and selects the step that it is in. */
export function playClock(): () => void {
  let before = 0;
  let asked = 0;
  const tick = (now: number): void => {
    const end = played()?.duration_s ?? 0;
    const next = time_s.value + Math.min((now - before) / 1000, 0.1);
    before = now;
    setTime(Math.min(next, end));
    if (next >= end) isPlaying.value = false;
    if (isPlaying.value) asked = requestAnimationFrame(tick);
  };
  return effect(() => {
    cancelAnimationFrame(asked);
    if (!isPlaying.value) return;
    untracked(() => {
      before = performance.now();
      asked = requestAnimationFrame(tick);
    });
  });
}

/** What the time is one of: a run that is looked at again, or the rehearsal of the open plan. */
export const played = (): Replay | Rehearsal | null => replay.value ?? rehearsal.value;

export function setTime(value: number): void {
  time_s.value = value;
  if (replay.peek() !== null) return;
  const steps = rehearsal.peek()?.proposal.steps ?? [];
  const inside = steps.filter((s) => s.starts_s <= value + 1e-6).at(-1);
  if (inside !== undefined && inside.number !== selectedStep.peek()) selectedStep.value = inside.number;
}

/** Goes one step back or on. */
export function jump(by: 1 | -1): void {
  const stops = played()?.stops ?? [];
  const now = time_s.value;
  const goal = by > 0 ? stops.find((s) => s > now + 1e-6) : stops.filter((s) => s < now - 1e-6).at(-1);
  if (goal !== undefined) setTime(goal);
}

export function showPreview(from_s: number): void {
  mode.value = "preview";
  setTime(from_s);
}

