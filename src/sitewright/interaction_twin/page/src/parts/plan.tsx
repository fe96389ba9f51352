// The open plan in plain words: what it is, what changed, and its steps.
import { useEffect, useRef } from "preact/hooks";
import { noteDifferencesShown } from "../state/arming";
import { asked, proposal, result, run } from "../state/store";
import type { Proposal } from "../wire";
import { inMillimetres, inSeconds, say, sayCount } from "../words/words";
import { NeedsHelp } from "./needs-help";
import { ResultBox } from "./result-box";
import { StepList } from "./steps";

export function PlanPanel() {
  const plan = proposal.value;
  return (
    <div class="plan">
      <NeedsHelp />
      <ResultBox />
      {plan !== null ? <Plan plan={plan} /> : isTrouble() ? null : <NoPlan />}
    </div>
  );
}

const isTrouble = (): boolean => run.value?.question != null || (run.value?.trouble ?? []).length > 0;

function Plan({ plan }: { plan: Proposal }) {
  return (
    <>
      <header class="plan-head">
        <div>
          <h2>{plan.title}</h2>
          {plan.why !== "" && <p class="why">{plan.why}</p>}
        </div>
        <dl>
          <Fact name={say("plan.code")} value={<code class="code">{plan.code}</code>} />
          <Fact name={say("plan.duration")} value={inSeconds(plan.duration_s)} />
          {plan.closest_distance_m !== null && <Fact name={say("plan.closest")} value={`${inMillimetres(plan.closest_distance_m)} mm`} />}
        </dl>
      </header>
      <Differences plan={plan} />
      <Summary plan={plan} />
      <StepList plan={plan} />
    </>
  );
}

function Fact({ name, value }: { name: string; value: preact.ComponentChildren }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </div>
  );
}

const SIGN = { target: "→", removed: "−", added: "+", motion: "~" } as const;

/** What is different from the plan that was seen before; Approve waits until this was on the screen. */
function Differences({ plan }: { plan: Proposal }) {
  const box = useRef<HTMLElement>(null);
  const isStale = result.value?.kind === "stale";
  useEffect(() => {
    const element = box.current;
    if (element === null) return undefined;
    if (isStale) element.focus();
    const watcher = new IntersectionObserver((seen) => {
      if (seen.some((entry) => entry.isIntersecting)) noteDifferencesShown(plan.fingerprint);
    }, { threshold: 0.25 });
    watcher.observe(element);
    return () => watcher.disconnect();
  }, [plan.fingerprint, isStale, plan.differences.length]);
  const { previous_code: since } = plan;
  if (plan.differences.length === 0) return null;
  const other = plan.differences.filter((difference) => difference.kind === "target");
  const differences = other.length > 0 ? other : plan.differences; // of another component every step is new
  return (
    <section class="differences" ref={box} tabIndex={-1} aria-label={say("plan.changed.none")}>
      <h3>{since === "" ? say("plan.changed.none") : say("plan.changed", { code: since })}</h3>
      <ul tabIndex={0}>
        {differences.map((difference, index) => (
          <li key={index} class={difference.kind}>
            <span aria-hidden="true">{SIGN[difference.kind]}</span> {difference.step !== undefined && `${difference.step}. `}
            {difference.words}
          </li>
        ))}
      </ul>
    </section>
  );
}

function Summary({ plan }: { plan: Proposal }) {
  return (
    <details class="summary">
      <summary>
        {say("plan.short")} <span class="soft">{sayCount("plan.steps", plan.steps.length)}</span>
      </summary>
      <ul>
        {plan.summary.map((line) => (
          <li key={line}>{line}</li>
        ))}
      </ul>
      {plan.notes.length > 0 && (
        <>
          <h3>{say("plan.notes")}</h3>
          <ul class="soft">
            {plan.notes.map((line) => (
              <li key={line}>{line}</li>
            ))}
          </ul>
        </>
      )}
    </details>
  );
}

function NoPlan() {
  const phase = run.value?.phase ?? "other";
  const known = ["idle", "planning", "running", "held", "finished"].includes(phase) ? phase : "other";
  const reason = asked.value?.open === null ? asked.value.reason : "";
  return (
    <div class="empty">
      <h2>{say(`phase.${run.value?.phase ?? "idle"}`)}</h2>
      <p>{say(`plan.none.${known}` as "plan.none.other")}</p>
      {(run.value?.held?.reason ?? reason) !== "" && <p class="soft">{run.value?.held?.reason ?? reason}</p>}
      {phase === "finished" && run.value !== null && (
        <p>
          <a class="button" href={`/api/runs/${run.value.run}/report`} target="_blank" rel="noreferrer">
            {say("runs.report")}
          </a>
        </p>
      )}
    </div>
  );
}
