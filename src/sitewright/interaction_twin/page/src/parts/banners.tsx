// What must be seen whatever screen is open: no connection, not signed in, a run that broke.
import { say } from "../words/words";
import { isSignedOut, link, run } from "../state/store";

export function Banners() {
  if (isSignedOut.value) {
    return (
      <div class="banner" role="alert">
        <b>{say("signed-out.title")}</b> {say("signed-out.text")}
      </div>
    );
  }
  if (link.value === "lost") {
    return (
      <div class="banner lost" role="alert">
        <p>
          <b>{say("lost.title")}</b> {say("lost.text")}
        </p>
        <label>
          {say("lost.note")}
          <input type="text" />
        </label>
      </div>
    );
  }
  if (run.value?.phase === "broken") {
    return (
      <div class="banner" role="alert">
        <b>{say("broken")}</b> {run.value.words}
      </div>
    );
  }
  return null;
}
