// Playing a plan or a run: scrub, rewind, step by step, over the exact trajectories.
import { jump, played, setTime } from "../state/playing";
import { isPlaying, proposal, rehearsalTrouble, time_s } from "../state/store";
import { inNumbers, say } from "../words/words";

export function Transport() {
  const shown = played();
  const end_s = shown?.duration_s ?? 0;
  if (shown === null) {
    const words = rehearsalTrouble.value !== "" ? say("preview.failed", { reason: rehearsalTrouble.value }) : proposal.value === null ? say("preview.none") : say("preview.loading");
    return (
      <p class="transport" role="status">
        {words}
      </p>
    );
  }
  const toggle = (): void => {
    if (!isPlaying.value && time_s.value >= end_s - 1e-3) setTime(0);
    isPlaying.value = !isPlaying.value;
  };
  return (
    <div class="transport">
      <button type="button" aria-label={say("preview.start")} title={say("preview.start")} onClick={() => setTime(0)}>
        <Sign path="M6 5v14M19 5 9 12l10 7Z" />
      </button>
      <button type="button" aria-label={say("preview.back")} title={say("preview.back")} onClick={() => jump(-1)}>
        <Sign path="M16 5 6 12l10 7Z" />
      </button>
      <button type="button" class="play" aria-label={isPlaying.value ? say("preview.pause") : say("preview.play")} onClick={toggle}>
        <Sign path={isPlaying.value ? "M8 5v14M16 5v14" : "M7 4l13 8-13 8Z"} />
      </button>
      <button type="button" aria-label={say("preview.next")} title={say("preview.next")} onClick={() => jump(1)}>
        <Sign path="M8 5l10 7-10 7Z" />
      </button>
      <input
        type="range"
        min={0}
        max={end_s}
        step={0.01}
        value={time_s.value}
        aria-label={say("preview.time")}
        aria-valuetext={`${inNumbers(time_s.value, 1)} s`}
        onInput={(event) => {
          isPlaying.value = false;
          setTime(event.currentTarget.valueAsNumber);
        }}
      />
      <output>
        {inNumbers(time_s.value, 1)} / {inNumbers(end_s, 1)} s
      </output>
    </div>
  );
}

function Sign({ path }: { path: string }) {
  return (
    <svg viewBox="0 0 24 24" width="22" height="22" fill="currentColor" stroke="currentColor" stroke-width="2" stroke-linejoin="round" aria-hidden="true">
      <path d={path} />
    </svg>
  );
}
