// Older runs: what happened, and a replay of what was approved and ran.
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { setTime } from "../state/playing";
import { ask, inLanguage } from "../state/server";
import { mode, replayed } from "../state/store";
import type { Proposal, RunEvent } from "../wire";
import { atTime, say, sayWord } from "../words/words";

interface RunLine {
  id: string;
  started_at_ms: number;
  ended: string;
  installed: number;
  targets: number;
}

const lines = signal<readonly RunLine[] | null>(null);
const chosen = signal<{ id: string; events: readonly RunEvent[] } | null>(null);
const moment = signal(0);
const trouble = signal("");

export function RunsPanel() {
  useEffect(() => {
    ask<{ runs: RunLine[] }>("/api/runs").then((answer) => (lines.value = answer.runs), fail);
    return () => {
      replayed.value = null;
      mode.value = "now";
    };
  }, []);
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={say("runs.title")}>
      <section class="block">
        <h2>{say("runs.title")}</h2>
        {trouble.value !== "" && <p role="alert">{say("failed", { reason: trouble.value })}</p>}
        {lines.value?.length === 0 && <p>{say("runs.none")}</p>}
        <ul class="run-list">
          {lines.value?.map((line) => (
            <li key={line.id} class={chosen.value?.id === line.id ? "selected" : ""}>
              <button type="button" onClick={() => void open(line.id)}>
                <b>{line.id}</b> {sayWord("runs", line.ended)}
                <small>
                  {atTime(line.started_at_ms)} · {say("runs.installed", { installed: line.installed, targets: line.targets })}
                </small>
              </button>
              {line.ended !== "open" && (
                <a class="button" href={`/api/runs/${line.id}/report`} target="_blank" rel="noreferrer">
                  {say("runs.report")}
                </a>
              )}
            </li>
          ))}
        </ul>
      </section>
      {chosen.value === null ? <p class="block soft">{say("runs.choose")}</p> : <Happened events={chosen.value.events} />}
    </div>
  );
}

function Happened({ events }: { events: readonly RunEvent[] }) {
  const at = Math.min(moment.value, events.length - 1);
  return (
    <section class="block">
      <h2>{say("runs.events")}</h2>
      <input type="range" min={0} max={Math.max(events.length - 1, 0)} value={at} aria-label={say("runs.moment")} onInput={(event) => void show(events, event.currentTarget.valueAsNumber)} />
      <ol class="journal">
        {events.map((event, index) => event.words !== "" && (
          <li key={event.n} class={index === at ? "selected" : ""}>
            <button type="button" aria-current={index === at ? "true" : undefined} onClick={() => void show(events, index)}>
              <time>{atTime(event.at_ms)}</time>
              {event.words}
            </button>
          </li>
        ))}
      </ol>
    </section>
  );
}

async function open(id: string): Promise<void> {
  await ask<{ events: RunEvent[] }>(inLanguage(`/api/runs/${id}`)).then((answer) => {
    chosen.value = { id, events: answer.events };
    void show(answer.events, 0);
  }, fail);
}

/** Shows a moment of a run: the plan that it belongs to, at the step that was started last. */
async function show(events: readonly RunEvent[], index: number): Promise<void> {
  moment.value = index;
  const begun = events.slice(0, index + 1).filter((event) => event.kind === "skill_intent").at(-1);
  const body = (begun?.body ?? null) as { fingerprint?: string; step?: number } | null;
  if (body?.fingerprint === undefined) return;
  if (replayed.value?.fingerprint !== body.fingerprint) {
    const plan = await ask<Proposal>(inLanguage(`/api/proposals/${body.fingerprint}`)).catch(() => null);
    if (plan === null) return;
    replayed.value = plan;
    mode.value = "preview";
  }
  const step = replayed.value.steps.find((s) => s.number === body.step);
  const isOver = events[index]?.kind === "skill_outcome";
  if (step !== undefined) setTime(step.starts_s + (isOver ? step.duration_s : 0));
}

function fail(error: Error): void {
  trouble.value = error.message;
}
