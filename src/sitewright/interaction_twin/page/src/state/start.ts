// Brings the page up: signs in, loads what is drawn, and follows what the server says.
import { effect } from "@preact/signals";
import { isFrozen } from "../marks";
import { language } from "../words/words";
import type { NoProposal, Proposal, RunState, Scene, Session } from "../wire";
import { ServerLink } from "./link";
import { followSchedule } from "./schedule";
import { ask, inLanguage, NoAnswerError, RefusedError } from "./server";
import { asked, isSignedOut, proposal, result, run, scene, seenSteps, selectedStep, session } from "./store";

let epoch = -1;

export async function startPage(): Promise<void> {
  session.value = await signIn();
  if (session.value === null) return;
  await Promise.all([loadScene(), loadProposal(), loadState()]);
  effect(() => {
    void language.value;
    void loadProposal();
  });
  followSchedule();
  if (isFrozen) return; // what comes over the line would move the picture
  new ServerLink({ onState: follow, onSceneEpoch: (seen) => void (seen !== epoch && loadScene(seen)), onConnected: refresh }).start();
}

/** Exchanges the token of the link for a cookie, or goes on with the cookie that is there. */
async function signIn(): Promise<Session | null> {
  const token = new URLSearchParams(location.hash.slice(1)).get("token");
  if (token !== null) history.replaceState(null, "", location.pathname + location.search);
  try {
    if (token !== null) await ask("/api/session", { method: "POST", body: { token } });
    return await ask<Session>("/api/session");
  } catch (error) {
    if (token !== null && error instanceof RefusedError) {
      const kept = await ask<Session>("/api/session").catch(() => null);
      if (kept !== null) return kept;
    }
    if (error instanceof NoAnswerError) throw error;
    isSignedOut.value = true;
    return null;
  }
}

function refresh(): void {
  void loadProposal();
  void loadScene();
}

function follow(state: RunState): void {
  const open = state.open?.fingerprint ?? null;
  const known = proposal.value?.fingerprint ?? null;
  const isOld = open !== known || proposal.value?.next_step !== state.open?.next_step || state.phase !== shownPhase;
  shownPhase = state.phase;
  if (isOld) void loadProposal();
}

let shownPhase = "";
let loading: Promise<void> | null = null;
let isLoadingAgain = false;

/** Loads the open proposal; a request that comes meanwhile is answered by one more load. */
export function loadProposal(): Promise<void> {
  if (loading !== null) {
    isLoadingAgain = true;
    return loading;
  }
  loading = readProposal().finally(() => {
    loading = null;
    if (isLoadingAgain) {
      isLoadingAgain = false;
      void loadProposal();
    }
  });
  return loading;
}

async function readProposal(): Promise<void> {
  const found = await ask<Proposal | NoProposal>(inLanguage("/api/proposals/open")).catch(() => null);
  if (found === null) return;
  const before = proposal.value?.fingerprint;
  asked.value = found;
  if (found.open !== null && found.fingerprint !== before) {
    selectedStep.value = null;
    if (result.value?.kind === "recorded") result.value = null;
    seenSteps.value = new Set();
  }
}

async function loadScene(seen?: number): Promise<void> {
  if (seen !== undefined) epoch = seen;
  const found = await ask<Scene>("/api/scene").catch(() => null);
  if (found === null || found.hash === scene.value?.hash) return;
  epoch = found.epoch;
  scene.value = found;
}

async function loadState(): Promise<void> {
  run.value = await ask<RunState>("/api/state").catch(() => null);
}
