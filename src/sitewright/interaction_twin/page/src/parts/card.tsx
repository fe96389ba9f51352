// What is known of the selected component.
import { useState } from "preact/hooks";
import { decide } from "../state/decisions";
import { isReachable, labelOf, may, proposal, scene, selectedComponent } from "../state/store";
import { say, sayWord } from "../words/words";
import { Dialog } from "./dialog";

export function Card() {
  const id = selectedComponent.value;
  const component = scene.value?.components.find((c) => c.id === id);
  const [isAsking, setAsking] = useState(false);
  if (component === undefined) return null;
  const done = component.operations.filter((o) => o.done).length;
  const rows: [string, string][] = [
    [say("card.layer"), say(`layer.${component.layer}`)],
    [say("card.state"), sayWord("state", component.status)],
    [say("card.type"), component.type],
    [say("card.material"), component.material],
    [say("card.parents"), component.parents.map(nameOf).join(", ")],
    [say("card.waits"), component.waits_for.map(nameOf).join(", ")],
    [say("card.made"), component.made_of === null ? "" : nameOf(component.made_of)],
    [say("card.place"), component.stack ?? ""],
    [say("card.operations"), component.operations.length === 0 ? "" : say("card.operations.done", { done, count: component.operations.length })],
  ];
  return (
    <section class="card" aria-label={say("card.label")}>
      <header>
        <h2>{component.name}</h2>
        <button type="button" class="quiet" aria-label={say("card.close")} onClick={() => (selectedComponent.value = null)}>
          ✕
        </button>
      </header>
      <dl>
        {rows
          .filter(([, value]) => value !== "")
          .map(([name, value]) => (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{value}</dd>
            </div>
          ))}
      </dl>
      {component.note !== "" && <p class="soft">{component.note}</p>}
      {component.deviation !== null && <p class="soft">{component.deviation.words}</p>}
      {may("mismatch") && (
        <button type="button" disabled={!isReachable.value} onClick={() => setAsking(true)}>
          {say("card.mismatch")}
        </button>
      )}
      {isAsking && <MismatchDialog id={component.id} name={component.name} onClose={() => setAsking(false)} />}
    </section>
  );
}

const nameOf = (id: string): string => (id === "jobsite" ? say("building.jobsite") : labelOf(id));

function MismatchDialog({ id, name, onClose }: { id: string; name: string; onClose: () => void }) {
  const [detail, setDetail] = useState("");
  const [fingerprint] = useState(proposal.value?.fingerprint ?? "");
  const send = (event: Event): void => {
    event.preventDefault();
    onClose();
    void decide({ fingerprint, verb: "mismatch", component: id, detail });
  };
  return (
    <Dialog title={say("mismatch.title", { name })} onClose={onClose}>
      <form onSubmit={send}>
        <p>{say("mismatch.text")}</p>
        <label class="field">
          {say("mismatch.detail")}
          <input type="text" value={detail} maxLength={300} onInput={(event) => setDetail(event.currentTarget.value)} />
        </label>
        <footer>
          <button type="button" onClick={onClose}>
            {say("act.cancel")}
          </button>
          <button type="submit" class="warn" disabled={!isReachable.value}>
            {say("card.mismatch")}
          </button>
        </footer>
      </form>
    </Dialog>
  );
}
