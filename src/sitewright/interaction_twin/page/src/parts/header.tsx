// Who, where, and whether what is shown is true now.
import { inNumbers, say, chooseLanguage, language, LANGUAGES, type Language } from "../words/words";
import { age_s, link, proposal, run, scene, screen, session, type Screen } from "../state/store";

const SCREENS: readonly Screen[] = ["cell", "building", "runs", "audit", "health"];

export function Header() {
  return (
    <header class="top">
      <h1 class="project">
        <img src="/static/icon.svg" alt="" width="28" height="28" />
        <span>{scene.value?.project ?? say("app.name")}</span>
      </h1>
      <Headline />
      <LinkChip />
      <p class="who">
        {session.value !== null && (
          <>
            {session.value.who} <span class="soft">{session.value.role}</span>
          </>
        )}
      </p>
      <label class="language">
        <span class="unseen">{say("language")}</span>
        <select value={language.value} onChange={(event) => chooseLanguage(event.currentTarget.value as Language)}>
          {Object.entries(LANGUAGES).map(([id, name]) => (
            <option key={id} value={id} lang={id}>
              {name}
            </option>
          ))}
        </select>
      </label>
      <nav aria-label={say("nav.label")}>
        {SCREENS.map((name) => (
          <button type="button" key={name} aria-current={screen.value === name ? "page" : undefined} onClick={() => (screen.value = name)}>
            {say(`nav.${name}`)}
          </button>
        ))}
      </nav>
    </header>
  );
}

/** What the run is at, in one line; the words are the server's. */
function Headline() {
  const state = run.value;
  const isLost = link.value === "lost";
  return (
    <p class={`headline ${isLost ? "" : (state?.phase ?? "")}`} role="status">
      {!isLost && state !== null && (
        <>
          <b>{say(`phase.${state.phase}`)}</b>
          <span class="soft">{say("progress", { ...state.progress })}</span>
          {state.phase === "waiting" && proposal.value !== null && <code class="code">{proposal.value.code}</code>}
        </>
      )}
    </p>
  );
}

function LinkChip() {
  const isAbsent = run.value?.cell === "absent" && link.value !== "lost";
  const words = isAbsent ? say("link.absent") : say(`link.${link.value}`, { seconds: inNumbers(age_s.value, 1) });
  return (
    <p class={`chip ${isAbsent ? "stale" : link.value}`} data-link={link.value}>
      <span class="dot" aria-hidden="true" />
      {words}
    </p>
  );
}
