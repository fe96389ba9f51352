// What became of the last answer.
import { result } from "../state/store";
import { say } from "../words/words";

export function ResultBox() {
  const last = result.value;
  if (last === null) return null;
  if (last.kind === "recorded") return <p class="result good" role="status">{last.words}</p>;
  if (last.kind === "refused") return <p class="result bad" role="alert">{last.words}</p>;
  if (last.kind === "unknown") {
    return (
      <div class="result bad" role="alert">
        <p>{say("done.unknown")}</p>
        <button type="button" onClick={() => void last.again()}>
          {say("act.again")}
        </button>
      </div>
    );
  }
  const { refusal } = last;
  return (
    <div class="result bad" role="alert">
      <p>
        <b>{say("stale.title")}.</b> {refusal.message}
      </p>
      <p>{refusal.open == null ? say("stale.none") : say("stale.open", { code: refusal.open.code })}</p>
      {(refusal.changed ?? []).length > 0 && (
        <ul>
          {refusal.changed?.map((difference, index) => (
            <li key={index}>{difference.words}</li>
          ))}
        </ul>
      )}
    </div>
  );
}
