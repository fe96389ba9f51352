// Who decides at a shared tablet: a name, and the PIN that goes with it; nothing of it is kept. Hold stays in reach.
import { useState } from "preact/hooks";
import { signatureWanted } from "../state/decisions";
import { isReachable, session } from "../state/store";
import { say } from "../words/words";
import { Dialog } from "./dialog";

export function PinDialog() {
  const wanted = signatureWanted.value;
  return wanted === null ? null : <Ask give={wanted.give} />;
}

function Ask({ give }: { give: NonNullable<typeof signatureWanted.value>["give"] }) {
  const [by, setBy] = useState("");
  const [pin, setPin] = useState("");
  const send = (event: Event): void => {
    event.preventDefault();
    give({ by, pin });
  };
  return (
    <Dialog title={say("pin.title")} onClose={() => give(null)} isBeside>
      <form onSubmit={send}>
        <label class="field">
          {say("sign-in.user")}
          <select required value={by} onChange={(event) => setBy(event.currentTarget.value)}>
            <option value="" />
            {session.value?.people?.map((name) => (
              <option key={name}>{name}</option>
            ))}
          </select>
        </label>
        <label class="field">
          {say("pin.pin")}
          <input type="password" inputMode="numeric" pattern="[0-9]{4,12}" autocomplete="off" required value={pin} onInput={(event) => setPin(event.currentTarget.value)} />
        </label>
        <footer>
          <button type="button" onClick={() => give(null)}>
            {say("act.cancel")}
          </button>
          <button type="submit" disabled={!isReachable.value}>
            {say("act.send")}
          </button>
        </footer>
      </form>
    </Dialog>
  );
}
