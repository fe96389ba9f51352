// A dialog that the browser keeps the focus in; as the page behind it is out of reach, it has a Hold of its own.
import type { ComponentChildren } from "preact";
import { useEffect, useId, useRef } from "preact/hooks";
import { hold } from "../state/decisions";
import { isResting } from "../state/store";
import { say } from "../words/words";

interface Props {
  title: string;
  onClose: () => void;
  children: ComponentChildren;
  /** Leaves the page behind it in use, e.g. to tap the picture. */
  isBeside?: boolean;
}

export function Dialog({ title, onClose, children, isBeside = false }: Props) {
  const box = useRef<HTMLDialogElement>(null);
  const heading = useId();
  useEffect(() => {
    if (isBeside) box.current?.show();
    else box.current?.showModal();
  }, [isBeside]);
  return (
    <dialog ref={box} aria-labelledby={heading} class={isBeside ? "beside" : ""} onClose={onClose}>
      <header>
        <h2 id={heading}>{title}</h2>
        <button type="button" class="quiet" onClick={() => box.current?.close()}>
          {say("act.close")}
        </button>
        {!isBeside && !isResting.value && (
          <button type="button" class="hold-here" onClick={() => void hold()}>
            {say("act.hold")}
          </button>
        )}
      </header>
      {children}
    </dialog>
  );
}
