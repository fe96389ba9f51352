// When Approve may be pressed: not while the plan under the finger is another one than was read.
import { computed, effect, signal } from "@preact/signals";
import { say } from "../words/words";
import { isSending } from "./decisions";
import { isReachable, may, proposal, run, seenSteps, session } from "./store";

const REST_MS = 1000;

const restsUntil = signal(0);
const clock = signal(0);
const differencesShown = signal("");

/** Starts a second of rest whenever what Approve means changes: the plan, or the step that is next. */
export function watchPlan(now: () => number): void {
  let shown = "";
  effect(() => {
    const plan = proposal.value;
    const meant = plan === null ? "" : `${plan.fingerprint} ${plan.next_step}`;
    if (meant === shown) return;
    shown = meant;
    restsUntil.value = now() + REST_MS;
    clock.value = now();
    setTimeout(() => {
      clock.value = now();
    }, REST_MS + 10);
  });
}

/** Says that the differences of a plan were on the screen. */
export function noteDifferencesShown(fingerprint: string): void {
  differencesShown.value = fingerprint;
}

/** Why a plan cannot be approved right now, in words; empty if it can. */
export const whyNotApprove = computed<string>(() => {
  const plan = proposal.value;
  if (!isReachable.value) return say("link.lost");
  if (plan === null || run.value?.phase !== "waiting") return say("plan.none.other");
  if (!may("approve")) return say("role.lacks", { role: session.value?.role ?? "" });
  if (isSending.value) return say("wait.busy");
  if (clock.value < restsUntil.value) return say("wait.changed");
  if (plan.differences.length > 0 && differencesShown.value !== plan.fingerprint) return say("wait.differences");
  return "";
});

/** Returns the first step up to `until` that demands a look and has had none. */
export function unseen(until: number): number | null {
  const plan = proposal.value;
  const flagged = plan?.steps.filter((s) => s.flags.length > 0 && !s.is_done && s.number <= until) ?? [];
  return flagged.find((s) => !seenSteps.value.has(s.number))?.number ?? null;
}
