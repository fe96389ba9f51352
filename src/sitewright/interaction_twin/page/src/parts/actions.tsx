// The bar of decisions. What is sent is bound to the fingerprint that was on the screen when the finger went down.
import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { say, sayCount } from "../words/words";
import { unseen, whyNotApprove } from "../state/arming";
import { decide, hold, holdState, shownSentences, type Decision } from "../state/decisions";
import { isReachable, isResting, link, may, panel, proposal, run, screen, selectStep, selectedStep } from "../state/store";
import { OtherDialog } from "./other-dialog";
import { RejectDialog } from "./reject-dialog";

type Scope = NonNullable<Decision["scope"]>;
const open = signal<"" | "reject" | "other">("");

/** Hold comes first in the order of keys, and is there on every screen. */
export function HoldButton() {
  const state = holdState.value;
  const isHeld = isResting.value;
  const isLost = link.value === "lost"; // a press is still tried, and says that it did not arrive
  return (
    <section class="hold-area" aria-label={say("act.hold")}>
      {isHeld ? (
        <ResumeButton />
      ) : (
        <button type="button" class={isLost ? "hold unreachable" : "hold"} onClick={() => void hold()}>
          <b>{say("act.hold")}</b>
          <small>{say(isLost ? "link.lost" : "act.hold.note")}</small>
        </button>
      )}
      <p class={`note ${state}`} role="status">
        {state === "failed" ? say("act.hold.failed") : state === "sent" && run.value?.phase === "holding" ? say("act.hold.sent") : ""}
      </p>
    </section>
  );
}

function ResumeButton() {
  const press = usePress();
  const isFresh = run.value?.phase === "idle";
  return (
    <button type="button" class="hold resume" disabled={!isReachable.value || !may("resume")} {...press((fingerprint) => void decide({ fingerprint, verb: "resume" }))}>
      <b>{say(isFresh ? "act.start" : "act.resume")}</b>
    </button>
  );
}

export function ActionBar() {
  const plan = proposal.value;
  const isAsked = plan !== null && run.value?.phase === "waiting";
  useEffect(() => {
    if (!isAsked) open.value = ""; // a dialog is about the plan that it was opened for
  }, [isAsked]);
  if (!isAsked) return <div class="acts" />;
  if (screen.value !== "cell" || panel.value !== "plan") return <ShowPlan code={plan.code} />;
  const left = plan.steps.filter((s) => !s.is_done);
  const chosen = selectedStep.value !== null && left.some((s) => s.number === selectedStep.value) ? selectedStep.value : null;
  return (
    <section class="acts" aria-label={say("acts.label", { code: plan.code })}>
      <button type="button" disabled={!isReachable.value || !may("reject")} onClick={() => (open.value = "reject")}>
        {say("act.reject")}
      </button>
      <button type="button" disabled={!isReachable.value || !may("instead")} onClick={() => (open.value = "other")}>
        {say("act.other")}
      </button>
      <ApproveButton scope={{ kind: "step", step: plan.next_step }} until={plan.next_step} words={say("act.step")} note={say("act.step.note", { number: plan.next_step })} />
      <ApproveButton
        scope={chosen === null ? null : { kind: "until", step: chosen }}
        until={chosen ?? 0}
        words={chosen === null ? say("act.until.none") : say("act.until", { number: chosen })}
        note={chosen === null ? say("wait.until") : sayCount("act.all.note", left.filter((s) => s.number <= chosen).length)}
      />
      <ApproveButton scope={{ kind: "plan" }} until={Infinity} words={say("act.all")} note={sayCount("act.all.note", left.length)} isMain />
      {open.value === "reject" && <RejectDialog plan={plan} onClose={() => (open.value = "")} />}
      {open.value === "other" && <OtherDialog plan={plan} onClose={() => (open.value = "")} />}
    </section>
  );
}

/** A plan is decided where it can be read, and nowhere else. */
function ShowPlan({ code }: { code: string }) {
  const show = (): void => {
    screen.value = "cell";
    panel.value = "plan";
  };
  return (
    <section class="acts single" aria-label={say("acts.label", { code })}>
      <button type="button" onClick={show}>
        <b>{say("act.show")}</b>
        <small>{code}</small>
      </button>
    </section>
  );
}

interface ApproveProps {
  scope: Scope | null;
  until: number;
  words: string;
  note: string;
  isMain?: boolean;
}

function ApproveButton({ scope, until, words, note, isMain = false }: ApproveProps) {
  const press = usePress();
  const why = whyNotApprove.value;
  const look = why === "" && scope !== null ? unseen(until) : null;
  const hint = why || (look === null ? note : say("wait.flagged", { number: look }));
  const isOff = why !== "" || scope === null;
  const nextStep = proposal.value?.next_step ?? 0;
  const act = (fingerprint: string): void => {
    if (isOff) return;
    if (look !== null) {
      screen.value = "cell";
      selectStep(look);
    } else {
      void decide({ fingerprint, verb: "approve", next_step: nextStep, scope, shown: shownSentences() });
    }
  };
  return (
    <button type="button" class={isMain ? "approve main" : "approve"} aria-disabled={isOff} data-scope={scope?.kind ?? "none"} {...press(act)}>
      <b>{words}</b>
      <small>{hint}</small>
    </button>
  );
}

/** Remembers the fingerprint that was rendered when a press began, by finger, mouse or key. */
function usePress(): (act: (fingerprint: string) => void) => Record<string, unknown> {
  const held = useRef<string | null>(null);
  const shown = proposal.value?.fingerprint ?? "";
  return (act) => ({
    "data-fingerprint": shown,
    onPointerDown: (event: PointerEvent) => (held.current = read(event)),
    onKeyDown: (event: KeyboardEvent) => !event.repeat && (held.current = read(event)),
    onPointerCancel: () => (held.current = null),
    onClick: () => {
      const fingerprint = held.current ?? shown;
      held.current = null;
      act(fingerprint);
    },
  });
}

const read = (event: Event): string => (event.currentTarget as HTMLElement).dataset["fingerprint"] ?? "";
