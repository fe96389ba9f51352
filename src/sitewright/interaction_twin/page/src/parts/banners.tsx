// What must be seen whatever screen is open: no connection, not signed in, a run that broke.
import { useState } from "preact/hooks";
import { ask } from "../state/server";
import { say } from "../words/words";
import { isSignedOut, link, run } from "../state/store";

export function Banners() {
  if (isSignedOut.value) {
    return (
      <div class="banner" role="alert">
        <p>
          <b>{say("signed-out.title")}</b> {say("signed-out.text")}
        </p>
        <SignIn />
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

/** People with a token of their own (`sitewright user`) sign in by name. */
function SignIn() {
  const [user, setUser] = useState("");
  const [token, setToken] = useState("");
  const [trouble, setTrouble] = useState("");
  const send = (event: Event): void => {
    event.preventDefault();
    ask("/api/session", { method: "POST", body: { user, token } }).then(
      () => location.reload(),
      (error: Error) => setTrouble(error.message),
    );
  };
  return (
    <form class="sign-in" onSubmit={send}>
      <p>{say("sign-in.or")}</p>
      <label class="field">
        {say("sign-in.user")}
        <input type="text" name="user" autocomplete="username" required value={user} onInput={(event) => setUser(event.currentTarget.value)} />
      </label>
      <label class="field">
        {say("sign-in.token")}
        <input type="password" name="token" autocomplete="current-password" required value={token} onInput={(event) => setToken(event.currentTarget.value)} />
      </label>
      <button type="submit">{say("sign-in.go")}</button>
      {trouble !== "" && <p role="alert">{trouble}</p>}
    </form>
  );
}
