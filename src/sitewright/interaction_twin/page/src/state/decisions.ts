// Answers of people: bound to what was on the screen, sent once, never queued.
import { signal } from "@preact/signals";
import { language, say } from "../words/words";
import type { HoldAnswer, Recorded } from "../wire";
import { ask, NoAnswerError, RefusedError } from "./server";
import { loadProposal } from "./start";
import { isReachable, proposal, result, session, type Result } from "./store";

export interface Decision {
  fingerprint: string;
  verb: string;
  next_step?: number;
  scope?: { kind: "plan" | "until" | "step"; step?: number };
  reason?: string;
  detail?: string;
  step?: number;
  call?: { skill: string; robot: string; arguments: string[] };
  question_id?: string;
  answer?: string;
  component?: string;
  zone?: unknown;
  target?: string;
  effects?: string[];
  comment?: string;
  shown?: string[];
}

/** Who decides at a shared tablet. */
export interface Signature {
  by: string;
  pin: string;
}

type Sent = Decision & Partial<Signature> & { key: string; lang: string };

/** Somebody must say who decides; `give` gets it, or null if nobody does. */
export const signatureWanted = signal<{ give: (signature: Signature | null) => void } | null>(null);

export const isSending = signal(false);

/** Sends a decision; the key is made here, once per press. */
export async function decide(decision: Decision): Promise<boolean> {
  if (!isReachable.value || isSending.value || signatureWanted.value !== null) return false;
  const signature = session.value?.asks_pin === true ? await signed() : {};
  if (signature === null || !isReachable.value) return false;
  return send({ ...decision, ...signature, key: crypto.randomUUID(), lang: language.value });
}

function signed(): Promise<Signature | null> {
  return new Promise((resolve) => {
    signatureWanted.value = {
      give: (signature) => {
        signatureWanted.value = null;
        resolve(signature);
      },
    };
  });
}

async function send(body: Sent): Promise<boolean> {
  isSending.value = true;
  result.value = null;
  try {
    const answer = await ask<Recorded>("/api/decisions", { method: "POST", body });
    result.value = { kind: "recorded", words: recorded(body.verb, answer) };
    return true;
  } catch (error) {
    result.value = failed(error, body);
    return false;
  } finally {
    isSending.value = false;
    void loadProposal();
  }
}

function recorded(verb: string, answer: Recorded): string {
  if (!answer.ok) return say("done.second");
  const who = answer.who ?? "";
  if (verb === "approve") return say("done.approved", { who });
  return verb === "reject" ? say("done.rejected", { who }) : say("done.other", { who });
}

function failed(error: unknown, body: Sent): Result {
  if (error instanceof RefusedError) {
    const { refusal } = error;
    return refusal.error === "stale" ? { kind: "stale", refusal } : { kind: "refused", words: refusal.message };
  }
  if (error instanceof NoAnswerError) {
    return { kind: "unknown", again: async () => void (await send(body)) };
  }
  throw error;
}

/** Returns the sentences of the plan as they are on the screen, for the record of who saw what. */
export function shownSentences(): string[] {
  const plan = proposal.value;
  if (plan === null) return [];
  return [plan.title, ...plan.steps.map((s) => `${s.number}. ${s.robot_name} ${s.words}`)];
}

export const holdState = signal<"" | "sent" | "failed">("");

/** Asks for a hold: no fingerprint, no role, no queue. */
export async function hold(): Promise<void> {
  try {
    const answer = await ask<HoldAnswer>("/api/hold", {
      method: "POST",
      body: { reason: "", key: crypto.randomUUID() },
      wait_ms: 1500,
    });
    holdState.value = answer.told_cell ? "sent" : "failed";
  } catch {
    holdState.value = "failed";
  }
}
