// What the page knows; every part of the page reads it here and nowhere else.
import { computed, signal } from "@preact/signals";
import type { Refused } from "../cell/clash";
import type { Mode } from "../cell/picture";
import type { Rehearsal } from "../preview/rehearsal";
import type { Replay } from "../preview/replay";
import type { NoProposal, Proposal, Refusal, RunEvent, RunState, Scene, Session, StepRecord } from "../wire";

export type Screen = "cell" | "building" | "runs" | "audit" | "health";
export type Link = "connecting" | "live" | "stale" | "lost";

export const session = signal<Session | null>(null);
export const isSignedOut = signal(false);
export const scene = signal<Scene | null>(null);
export const run = signal<RunState | null>(null);
export const asked = signal<Proposal | NoProposal | null>(null);
export const events = signal<readonly RunEvent[]>([]);

export const link = signal<Link>("connecting");
/** Age of the last sensed picture, in tenths of a second once it is old. */
export const age_s = signal(0);
export const joints = signal<Float32Array | null>(null);
export const piecePoses = signal<Float32Array | null>(null);

export const screen = signal<Screen>("cell");
export const panel = signal<"plan" | "tree" | "journal">("plan");
export const mode = signal<Mode>("now");
export const selectedStep = signal<number | null>(null);
export const selectedComponent = signal<string | null>(null);
export const seenSteps = signal<ReadonlySet<number>>(new Set());
export const hiddenIds = signal<ReadonlySet<string>>(new Set());
export const lockedIds = signal<ReadonlySet<string>>(new Set());
export const blockers = signal<readonly string[]>([]);
/** The target whose trouble is looked at in the picture. */
export const shownTrouble = signal<string | null>(null);
export const refused = computed<Refused | null>(() => {
  const trouble = run.value?.trouble.find((t) => t.target === shownTrouble.value);
  return trouble === undefined ? null : { pair: trouble.pair ?? trouble.blockers, posture: trouble.posture };
});

export const rehearsal = signal<Rehearsal | null>(null);
export const rehearsalTrouble = signal("");
export const time_s = signal(0);
export const isPlaying = signal(false);
/** A whole run that is looked at again. */
export const replay = signal<Replay | null>(null);
/** How many components stand on the building screen; null shows all. */
export const standing = signal<number | null>(null);

export type Result =
  | { kind: "recorded"; words: string }
  | { kind: "stale"; refusal: Refusal }
  | { kind: "refused"; words: string }
  | { kind: "unknown"; again: () => Promise<void> };

/** What became of the last answer that was given on this page. */
export const result = signal<Result | null>(null);

export const proposal = computed<Proposal | null>(() => (asked.value === null || asked.value.open === null ? null : asked.value));

export const step = computed<StepRecord | null>(
  () => proposal.value?.steps.find((s) => s.number === selectedStep.value) ?? null,
);

/** Whether answers can be given: nothing is queued while there is no connection. */
export const isReachable = computed(() => link.value === "live" || link.value === "stale");

/** Phases in which nothing starts before somebody says so. */
const RESTING: ReadonlySet<string> = new Set(["held", "idle", "needs-help", "broken"]);
export const isResting = computed(() => RESTING.has(run.value?.phase ?? ""));

export function may(verb: string): boolean {
  return session.value?.can.includes(verb) ?? false;
}

export function robotNumber(id: string): number {
  return scene.value?.robots.find((robot) => robot.id === id)?.number ?? 0;
}

export function labelOf(id: string): string {
  const known = scene.value;
  const own = id.split("/")[0] ?? id;
  const all = known === null ? [] : [...known.components, ...known.robots, ...known.end_effectors, ...known.fixtures, ...known.zones];
  return all.find((record) => record.id === own)?.name ?? own;
}

/** Selects a step everywhere at once: list, picture, schedule. */
export function selectStep(number: number | null): void {
  selectedStep.value = number;
  if (number === null) return;
  seenSteps.value = new Set([...seenSteps.value, number]);
  const found = proposal.value?.steps.find((s) => s.number === number);
  if (found !== undefined) time_s.value = found.starts_s;
}
