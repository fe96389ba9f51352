// Rejecting a plan with a reason that the planner can use.
import { useState } from "preact/hooks";
import { decide } from "../state/decisions";
import { say } from "../words/words";
import { isReachable, selectedStep } from "../state/store";
import type { Proposal } from "../wire";
import { Dialog } from "./dialog";

const REASONS = ["wrong-component", "wrong-robot", "path-unsafe", "site-differs", "later", "other"] as const;

export function RejectDialog({ plan, onClose }: { plan: Proposal; onClose: () => void }) {
  const [fingerprint] = useState(plan.fingerprint);
  const [reason, setReason] = useState<string>("");
  const [step, setStep] = useState(0);
  const [detail, setDetail] = useState("");
  const send = async (event: Event): Promise<void> => {
    event.preventDefault();
    onClose();
    await decide({ fingerprint, verb: "reject", reason, step, detail });
  };
  return (
    <Dialog title={say("reject.title")} onClose={onClose}>
      <form onSubmit={(event) => void send(event)}>
        <fieldset class="choices">
          <legend>{say("reject.why")}</legend>
          {REASONS.map((name) => (
            <label key={name}>
              <input type="radio" name="reason" value={name} checked={reason === name} onChange={() => setReason(name)} />
              {say(`reason.${name}`)}
            </label>
          ))}
        </fieldset>
        <label class="field">
          {say("reject.step")}
          <select value={step} onChange={(event) => setStep(Number(event.currentTarget.value))}>
            <option value={0}>{say("reject.whole")}</option>
            {selectedStep.value !== null && <option value={selectedStep.value}>{say("reject.one", { number: selectedStep.value })}</option>}
          </select>
        </label>
        <label class="field">
          {say("reject.detail")}
          <input type="text" value={detail} maxLength={300} onInput={(event) => setDetail(event.currentTarget.value)} />
        </label>
        <footer>
          <button type="button" onClick={onClose}>
            {say("act.cancel")}
          </button>
          <button type="submit" class="warn" disabled={reason === "" || !isReachable.value}>
            {say("act.reject")}
          </button>
        </footer>
      </form>
    </Dialog>
  );
}
