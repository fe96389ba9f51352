// Other feasible actions with their price, and why the rest cannot be done.
import { useEffect, useState } from "preact/hooks";
import { decide } from "../state/decisions";
import { ask, inLanguage } from "../state/server";
import { isReachable, may, selectedStep } from "../state/store";
import { inNumbers, inSeconds, say } from "../words/words";
import type { OtherWay, OtherWays, Proposal } from "../wire";
import { Dialog } from "./dialog";
import { isDrawingZone } from "./zone-dialog";

export function OtherDialog({ plan, onClose }: { plan: Proposal; onClose: () => void }) {
  const [fingerprint] = useState(plan.fingerprint);
  const [ways, setWays] = useState<OtherWays | null>(null);
  const [trouble, setTrouble] = useState("");
  useEffect(() => {
    ask<OtherWays>(inLanguage(`/api/proposals/${fingerprint}/alternatives`), { wait_ms: 60000 }).then(setWays, (error: Error) => setTrouble(error.message));
  }, [fingerprint]);
  const choose = (way: OtherWay): void => {
    onClose();
    void decide({ fingerprint, verb: "instead", call: { skill: way.skill, robot: way.robot, arguments: way.arguments } });
  };
  const step = selectedStep.value;
  return (
    <Dialog title={say("other.title")} onClose={onClose}>
      <p class="soft">{say("other.note")}</p>
      <h3>{say("other.feasible")}</h3>
      {ways === null && trouble === "" && <p role="status">{say("other.loading")}</p>}
      {trouble !== "" && <p role="alert">{say("failed", { reason: trouble })}</p>}
      {ways?.feasible.length === 0 && <p>{say("other.none")}</p>}
      <ul class="ways">
        {ways?.feasible.map((way) => (
          <li key={way.words}>
            <div>
              {way.words}
              <small>
                {inSeconds(way.duration_s)}
                {way.price_s !== null && ` · ${price(way.price_s)}`}
                {way.note !== "" && ` · ${way.note}`}
              </small>
            </div>
            <button type="button" disabled={!isReachable.value} onClick={() => choose(way)}>
              {say("act.choose")}
            </button>
          </li>
        ))}
      </ul>
      {ways !== null && ways.infeasible.length > 0 && (
        <details>
          <summary>{say("other.infeasible")}</summary>
          <ul class="ways">
            {ways.infeasible.map((way) => (
              <li key={way.words}>
                <div>
                  {way.words}
                  <small>{way.why_not}</small>
                </div>
              </li>
            ))}
          </ul>
        </details>
      )}
      <footer>
        {may("zone") && (
          <button
            type="button"
            onClick={() => {
              onClose();
              isDrawingZone.value = true;
            }}
          >
            {say("other.zone")}
          </button>
        )}
        {step !== null && may("new-motion") && (
          <button
            type="button"
            onClick={() => {
              onClose();
              void decide({ fingerprint, verb: "new-motion", step });
            }}
          >
            {say("other.motion", { number: step })}
          </button>
        )}
      </footer>
    </Dialog>
  );
}

function price(seconds: number): string {
  const sign = seconds > 0 ? "+" : seconds < 0 ? "−" : "±";
  return say("other.price", { seconds: `${sign}${inNumbers(Math.abs(seconds))}` });
}
