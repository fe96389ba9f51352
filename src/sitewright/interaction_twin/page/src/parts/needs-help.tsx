// Trouble in words, with what can be done; the picture lights what is in the way.
import { useEffect, useState } from "preact/hooks";
import { decide } from "../state/decisions";
import { ask, inLanguage } from "../state/server";
import { blockers, isReachable, may, mode, proposal, run, shownTrouble } from "../state/store";
import type { ByHand, Effect, Option, Question, Tried, Trouble } from "../wire";
import { inNumbers, say, sayWord } from "../words/words";
import { Dialog } from "./dialog";
import { isDrawingZone } from "./zone-dialog";

export function NeedsHelp() {
  const state = run.value;
  const trouble = state?.trouble ?? [];
  const ids = trouble.flatMap((t) => [...(t.pair ?? []), ...t.blockers]).map((id) => id.split("/")[0] ?? id);
  useEffect(() => {
    blockers.value = [...new Set(ids)];
  }, [ids.join(" ")]);
  if (state === null || (state.question === null && trouble.length === 0)) return null;
  return (
    <section class="help" aria-label={say("help.title")}>
      {state.question !== null && <Ask question={state.question} />}
      {trouble.map((t) => (
        <Stuck key={t.target} trouble={t} />
      ))}
    </section>
  );
}

function Ask({ question }: { question: Question }) {
  return (
    <div class="trouble">
      <h2>{say("question.title")}</h2>
      <p>{question.text}</p>
      <div class="buttons">
        {question.answers.map((answer) => (
          <button
            type="button"
            key={answer}
            disabled={!isReachable.value || !may("answer")}
            onClick={() => void decide({ fingerprint: "", verb: "answer", question_id: question.question_id, answer })}
          >
            {sayWord("answer", answer)}
          </button>
        ))}
      </div>
    </div>
  );
}

function Stuck({ trouble }: { trouble: Trouble }) {
  const [isManual, setManual] = useState(false);
  const [first, second] = trouble.pair_names;
  return (
    <div class="trouble">
      <h2>
        {say("help.title")}: {trouble.name}
      </h2>
      <p>{trouble.reason}</p>
      {trouble.rejected.map((words) => (
        <p key={words}>{words}</p>
      ))}
      {trouble.verdict !== "" && (
        <p class="verdict">
          <b>{trouble.verdict}</b> {sayWord("verdict", trouble.verdict_kind)}
        </p>
      )}
      {first !== undefined && second !== undefined && <p class="pair">{say("help.pair", { first, second })}</p>}
      {trouble.counter_proposals.length > 0 && <WhatWorks tried={trouble.counter_proposals} />}
      <div class="buttons">
        {(trouble.pair ?? trouble.blockers).length > 0 && (
          <button type="button" class="show" aria-pressed={shownTrouble.value === trouble.target} onClick={() => show(trouble)}>
            {say("help.show")}
          </button>
        )}
        {trouble.options.map((option) => (
          <OptionButton key={option.id} option={option} onManual={() => setManual(true)} />
        ))}
      </div>
      {trouble.options.length === 0 && <p class="soft">{say("help.none")}</p>}
      {isManual && <ManualDialog target={trouble.target} name={trouble.name} onClose={() => setManual(false)} />}
    </div>
  );
}

/** What was planned through on a copy of the site, and so would do. */
function WhatWorks({ tried }: { tried: Tried[] }) {
  return (
    <>
      <p class="soft">{say("help.tried")}</p>
      <ul class="tried">
        {tried.map(({ words, steps, duration_s }) => (
          <li key={words}>{say("help.tried-one", { words, steps, seconds: inNumbers(duration_s) })}</li>
        ))}
      </ul>
    </>
  );
}

/** Shows who is in the way, in the posture in which it was seen if that is known; once more puts it away. */
function show(trouble: Trouble): void {
  mode.value = "now";
  shownTrouble.value = shownTrouble.value === trouble.target ? null : trouble.target;
  document.querySelector(".picture")?.scrollIntoView({ block: "nearest" });
}

function OptionButton({ option, onManual }: { option: Option; onManual: () => void }) {
  const fingerprint = proposal.value?.fingerprint ?? "";
  const { verb, zone } = option;
  const act = (): void => {
    if (verb === "manual") onManual();
    else if (verb === "zone" && zone === undefined) isDrawingZone.value = true;
    else void decide({ fingerprint, verb, ...(zone && { zone }) });
  };
  return (
    <button type="button" disabled={!isReachable.value || !may(verb)} onClick={act}>
      {option.words}
    </button>
  );
}

/** A checklist of what is true now, by the words of the server. */
function ManualDialog({ target, name, onClose }: { target: string; name: string; onClose: () => void }) {
  const [effects, setEffects] = useState<Effect[]>([]);
  const [ticked, setTicked] = useState<ReadonlySet<string>>(new Set());
  const [trouble, setTrouble] = useState("");
  useEffect(() => {
    ask<ByHand>(inLanguage(`/api/manual/${target}`)).then((answer) => setEffects(answer.effects), (error: Error) => setTrouble(error.message));
  }, [target]);
  const toggle = (fact: string): void => {
    const next = new Set(ticked);
    if (!next.delete(fact)) next.add(fact);
    setTicked(next);
  };
  const send = (event: Event): void => {
    event.preventDefault();
    onClose();
    void decide({ fingerprint: proposal.value?.fingerprint ?? "", verb: "manual", target, effects: [...ticked] });
  };
  return (
    <Dialog title={say("manual.title", { name })} onClose={onClose}>
      <form onSubmit={send}>
        <p>{say("manual.text")}</p>
        {trouble !== "" && <p role="alert">{say("failed", { reason: trouble })}</p>}
        <fieldset class="choices">
          {effects.map((effect) => (
            <label key={effect.fact}>
              <input type="checkbox" checked={ticked.has(effect.fact)} onChange={() => toggle(effect.fact)} />
              {effect.words}
            </label>
          ))}
        </fieldset>
        <footer>
          <button type="button" onClick={onClose}>
            {say("act.cancel")}
          </button>
          <button type="submit" class="warn" disabled={ticked.size === 0 || !isReachable.value}>
            {say("act.send")}
          </button>
        </footer>
      </form>
    </Dialog>
  );
}
