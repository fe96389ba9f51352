// What became of the last answer; a no is brought into view wherever the list stands.
import { useEffect, useRef } from "preact/hooks";
import { result, type Result } from "../state/store";
import { say } from "../words/words";

export function ResultBox() {
  const box = useRef<HTMLDivElement>(null);
  const last = result.value;
  useEffect(() => {
    if (last !== null && last.kind !== "recorded") box.current?.scrollIntoView({ block: "nearest" });
  }, [last]);
  return last === null ? null : (
    <div ref={box} class={last.kind === "refused" ? "stays" : ""}>
      <Answer last={last} />
    </div>
  );
}

function Answer({ last }: { last: Result }) {
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
