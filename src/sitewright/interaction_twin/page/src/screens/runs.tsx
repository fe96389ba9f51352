// Older runs: what happened, and all of it to be looked at again.
import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { setTime } from "../state/playing";
import { ask, inLanguage } from "../state/server";
import { chooseReplay } from "../state/replaying";
import { isPlaying, mode, replay, time_s } from "../state/store";
import type { ReplayRecord, RunEvent, RunLine, RunRecord, Runs } from "../wire";
import { atTime, say, sayWord } from "../words/words";

const lines = signal<readonly RunLine[] | null>(null);
const chosen = signal<{ id: string; events: readonly RunEvent[] } | null>(null);
/** An event that was chosen; of those at one time only one can be. */
const picked = signal(0);
const trouble = signal("");

export function RunsPanel() {
  useEffect(() => {
    ask<Runs>("/api/runs").then((answer) => (lines.value = answer.runs), fail);
    return () => {
      isPlaying.value = false;
      chooseReplay(null);
      chosen.value = null;
      mode.value = "now";
      setTime(0);
    };
  }, []);
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={say("runs.title")}>
      <section class="block">
        <h2>{say("runs.title")}</h2>
        {trouble.value !== "" && <p role="alert">{say("failed", { reason: trouble.value })}</p>}
        {lines.value === null && trouble.value === "" && <p role="status">{say("loading")}</p>}
        {lines.value?.length === 0 && <p>{say("runs.none")}</p>}
        <ul class="run-list">
          {lines.value?.map((line) => (
            <li key={line.id} class={chosen.value?.id === line.id ? "selected" : ""}>
              <button type="button" onClick={() => void open(line.id).catch(fail)}>
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
  const at = present();
  const list = useRef<HTMLOListElement>(null);
  useEffect(() => list.current?.querySelector(".selected")?.scrollIntoView({ block: "nearest" }), [at]);
  return (
    <section class="block">
      <h2>{say("runs.events")}</h2>
      <ol class="journal" ref={list}>
        {events.map((event) => event.words !== "" && (
          <li key={event.n} data-event={event.n} class={event.n === at ? "selected" : ""}>
            <button type="button" aria-current={event.n === at ? "true" : undefined} onClick={() => show(event)}>
              <time>{atTime(event.at_ms)}</time>
              {event.words}
            </button>
          </li>
        ))}
      </ol>
    </section>
  );
}

/** Returns the number of the event that was the last one at the time that is shown. */
function present(): number {
  const stamps = replay.value?.record.events ?? [];
  const told = new Set(chosen.value?.events.filter((event) => event.words !== "").map((event) => event.n));
  const before = stamps.filter((stamp) => stamp.at_s <= time_s.value + 1e-6 && told.has(stamp.n));
  const last = before.at(-1);
  const wished = before.find((stamp) => stamp.n === picked.value);
  return (wished?.at_s === last?.at_s ? wished?.n : last?.n) ?? 0;
}

async function open(id: string): Promise<void> {
  const [run, record] = await Promise.all([ask<RunRecord>(inLanguage(`/api/runs/${id}`)), ask<ReplayRecord>(`/api/runs/${id}/replay`)]);
  chosen.value = { id, events: run.events };
  chooseReplay(record);
  mode.value = "replay";
  setTime(0);
}

/** Shows how everything was when something happened. */
function show(event: RunEvent): void {
  isPlaying.value = false;
  picked.value = event.n;
  setTime(replay.value?.record.events.find((stamp) => stamp.n === event.n)?.at_s ?? 0);
}

function fail(error: Error): void {
  trouble.value = error.message;
}
