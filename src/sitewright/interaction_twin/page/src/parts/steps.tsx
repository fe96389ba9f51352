// The steps as a list; selecting one selects it in the picture and in the schedule too.
import { useEffect, useRef, useState } from "preact/hooks";
import { robotColour } from "../cell/looks";
import { decide } from "../state/decisions";
import { showPreview } from "../state/playing";
import { ask, inLanguage } from "../state/server";
import { isReachable, may, robotNumber, run, seenSteps, selectedStep, selectStep } from "../state/store";
import type { Proposal, StepRecord } from "../wire";
import { inMillimetres, inSeconds, say, sayWord } from "../words/words";

export function StepList({ plan }: { plan: Proposal }) {
  return (
    <ol class="steps" aria-label={say("plan.list")}>
      {plan.steps.map((step) => (
        <Step key={`${plan.fingerprint} ${step.number}`} step={step} plan={plan} />
      ))}
    </ol>
  );
}

function Step({ step, plan }: { step: StepRecord; plan: Proposal }) {
  const isSelected = selectedStep.value === step.number;
  const row = useRef<HTMLLIElement>(null);
  const isRunning = run.value?.running?.step === step.number && run.value.running.fingerprint === plan.fingerprint;
  useEffect(() => {
    if (isSelected || isRunning) row.current?.scrollIntoView({ block: "nearest" });
  }, [isSelected, isRunning]);
  const status = isRunning ? "running" : step.is_done ? "done" : step.status;
  const needsLook = step.flags.length > 0 && !step.is_done;
  return (
    <li ref={row} class={`step ${status.replace(" ", "-")} ${isSelected ? "selected" : ""} ${needsLook ? "flagged" : ""}`} data-step={step.number}>
      <button type="button" class="row" aria-expanded={isSelected} onClick={() => selectStep(isSelected ? null : step.number)}>
        <span class="number">{step.number}</span>
        <RobotBadge robot={step.robot} />
        <span class="words">
          {step.robot_name} {step.words}
          {step.why !== "" && <small>{step.why}</small>}
          {needsLook && (
            <small class="flag">
              ⚠ {step.flags.join(" ")} {seenSteps.value.has(step.number) ? say("step.seen") : say("step.look")}
            </small>
          )}
        </span>
        <span class="figures">
          {status === "open" ? inSeconds(step.duration_s) : sayWord("step", status)}
          {step.closest_distance_m !== null && <small>{say("step.distance", { distance: inMillimetres(step.closest_distance_m) })}</small>}
        </span>
      </button>
      {isSelected && <Details step={step} plan={plan} />}
    </li>
  );
}

export function RobotBadge({ robot }: { robot: string }) {
  const number = robotNumber(robot);
  return (
    <span class="robot" style={{ background: robotColour(number - 1) }} title={robot}>
      <span class="unseen">{say("step.robot", { number })}</span>
      <span aria-hidden="true">{number}</span>
    </span>
  );
}

function Details({ step, plan }: { step: StepRecord; plan: Proposal }) {
  const [why, setWhy] = useState<string[] | null>(null);
  const explain = async (): Promise<void> => {
    const path = inLanguage(`/api/proposals/${plan.fingerprint}/steps/${step.number}/why`);
    const answer = await ask<{ lines: string[] }>(path).catch((error: Error) => ({ lines: [say("failed", { reason: error.message })] }));
    setWhy(answer.lines);
  };
  const [first, second] = step.closest_names;
  const canMove = step.motions.length > 0 && !step.is_done && may("new-motion");
  return (
    <div class="details">
      <p class="soft">
        {step.motions.length === 0 || step.closest_distance_m === null || first === undefined || second === undefined
          ? say("step.still")
          : say("step.closest", { distance: inMillimetres(step.closest_distance_m), first, second })}
      </p>
      <div class="buttons">
        <button type="button" onClick={() => showPreview(step.starts_s)}>
          {say("step.play")}
        </button>
        <button type="button" onClick={() => void explain()}>
          {say("step.why")}
        </button>
        {canMove && run.value?.phase === "waiting" && (
          <button type="button" disabled={!isReachable.value} onClick={() => void decide({ fingerprint: plan.fingerprint, verb: "new-motion", step: step.number })}>
            {say("step.motion")}
          </button>
        )}
      </div>
      {why !== null && (
        <div class="because" role="status">
          {why.map((line, index) => (
            <p key={index} class={line.startsWith(" ") ? "inner" : ""}>
              {line.trim()}
            </p>
          ))}
        </div>
      )}
    </div>
  );
}
