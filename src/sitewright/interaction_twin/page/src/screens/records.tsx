// Audit and health: tables of what the server says.
import { useEffect, useState } from "preact/hooks";
import { ask, inLanguage } from "../state/server";
import { checkCode } from "../state/check-code";
import type { Audit, AuditEntry, Health } from "../wire";
import { atTime, inNumbers, inSeconds, say, sayCount, sayWord } from "../words/words";

/** What the page reads of an event's content. */
interface Detail {
  fingerprint?: string;
  approval?: { fingerprint: string; scope: { kind: "plan" | "until" | "step"; step: number } };
}

/** Returns what was decided; in the page's own words where the journal has none for people. */
function decided(entry: AuditEntry): string {
  const scope = (entry.detail as Detail).approval?.scope;
  const what = entry.words === "" ? sayWord("verb", entry.verb) : entry.words;
  return scope === undefined ? what : `${what}: ${say(`scope.${scope.kind}`, { step: scope.step })}`;
}

function codeOf(entry: AuditEntry): string {
  const detail = entry.detail as Detail;
  const fingerprint = detail.fingerprint ?? detail.approval?.fingerprint ?? "";
  return fingerprint === "" ? "" : checkCode(fingerprint);
}

function useAnswer<T>(path: string): [T | null, string] {
  const [answer, setAnswer] = useState<T | null>(null);
  const [trouble, setTrouble] = useState("");
  useEffect(() => {
    const load = (): Promise<void> => ask<T>(path).then((found) => (setAnswer(found), setTrouble("")), (error: Error) => setTrouble(error.message));
    void load();
    const timer = setInterval(() => void load(), 2000);
    return () => clearInterval(timer);
  }, [path]);
  return [answer, trouble];
}

export function AuditScreen() {
  const [answer, trouble] = useAnswer<Audit>(inLanguage("/api/audit"));
  return (
    <div class="sheet scroll" tabIndex={0} role="region" aria-label={say("nav.audit")}>
      <h2>{say("audit.title")}</h2>
      {trouble !== "" && <p role="alert">{say("failed", { reason: trouble })}</p>}
      {answer?.entries.length === 0 && <p>{say("audit.none")}</p>}
      {answer !== null && answer.entries.length > 0 && (
        <table>
          <thead>
            <tr>
              <th scope="col">{say("audit.when")}</th>
              <th scope="col">{say("audit.who")}</th>
              <th scope="col">{say("audit.what")}</th>
              <th scope="col">{say("audit.code")}</th>
            </tr>
          </thead>
          <tbody>
            {answer.entries.map((entry) => (
              <tr key={`${entry.run} ${entry.n}`}>
                <td>
                  <time>{atTime(entry.at_ms)}</time>
                </td>
                <td>
                  {entry.who} <span class="soft">{entry.role}</span>
                </td>
                <td>
                  {decided(entry)}
                  {(entry.shown ?? []).length > 0 && (
                    <details>
                      <summary>{say("audit.seen")}</summary>
                      <ol class="seen">
                        {entry.shown.map((line, index) => (
                          <li key={index}>{line}</li>
                        ))}
                      </ol>
                    </details>
                  )}
                </td>
                <td>
                  <code>{codeOf(entry)}</code>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </div>
  );
}

export function HealthScreen() {
  const [health, trouble] = useAnswer<Health>("/api/health");
  return (
    <div class="sheet scroll" tabIndex={0} role="region" aria-label={say("nav.health")}>
      <h2>{say("health.title")}</h2>
      {trouble !== "" && <p role="alert">{say("failed", { reason: trouble })}</p>}
      {health !== null && trouble === "" && (
        <dl class="health">
          <Line name={say("health.server")} isGood words={`${health.server.version}, ${say("health.uptime", { seconds: inNumbers(health.server.uptime_s) })}, ${sayCount("health.clients", health.server.clients)}`} />
          <Line name={say("health.run")} isGood={health.run.is_alive} words={`${sayWord("phase", health.run.phase)}, ${health.run.is_alive ? say("health.alive") : say("health.dead")}`} />
          <Line name={say("health.cell")} isGood={health.cell.state === "live"} words={cellWords(health.cell)} />
          <Line name={say("health.journal")} isGood={health.journal.is_whole !== false} words={journalWords(health.journal)} />
          <Line name={say("health.disk")} isGood={health.disk_free_bytes > 1e9} words={`${inNumbers(health.disk_free_bytes / 1e9, 1)} GB`} />
          <Line name={say("health.page")} isGood words={say("health.frame", { ms: inNumbers(window.__m.cost.js_ms, 1), calls: window.__m.cost.calls })} />
        </dl>
      )}
    </div>
  );
}

function cellWords({ state, age_ms }: Health["cell"]): string {
  if (age_ms === null || state === "absent") return say("link.absent");
  return state === "live" ? `${say("link.live")}, ${inSeconds(age_ms / 1000)}` : say("link.stale", { seconds: inNumbers(age_ms / 1000) });
}

function journalWords({ run, n, is_whole }: Health["journal"]): string {
  const place = `${run} #${n}`;
  return is_whole === undefined ? place : `${place}, ${is_whole ? say("health.whole") : say("health.not-whole")}`;
}

function Line({ name, words, isGood }: { name: string; words: string; isGood: boolean }) {
  return (
    <div class={isGood ? "good" : "bad"}>
      <dt>{name}</dt>
      <dd>
        <span aria-hidden="true">{isGood ? "✓" : "!"}</span> {words}
      </dd>
    </div>
  );
}
