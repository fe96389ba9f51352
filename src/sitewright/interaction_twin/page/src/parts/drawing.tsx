// A picture that the server drew, as the report has it; what is live on it is added here.
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { askText } from "../state/server";

const SPACE = "http://www.w3.org/2000/svg";
const ELEMENTS = new Set(["svg", "g", "rect", "line", "circle", "path", "text", "title"]);
const ATTRIBUTES = new Set([
  ...["viewBox", "width", "height", "x", "y", "x1", "x2", "y1", "y2", "cx", "cy", "r", "rx", "d", "class", "role"],
  ...["fill", "fill-opacity", "opacity", "stroke", "stroke-width", "font-family", "font-size", "font-weight", "text-anchor"],
]);

/** Builds a picture anew from what is known to be harmless in it; anything else is an error. */
export function readPicture(text: string): SVGSVGElement {
  const found = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  return copied(found) as SVGSVGElement;
}

function copied(node: Element): SVGElement {
  if (node.namespaceURI !== SPACE || !ELEMENTS.has(node.localName)) throw new Error(`a picture has no <${node.localName}>`);
  const made = document.createElementNS(SPACE, node.localName) as SVGElement;
  for (const { name, value } of node.attributes) {
    if (name === "xmlns") continue;
    if (!ATTRIBUTES.has(name) && !name.startsWith("data-")) throw new Error(`a picture has no attribute ${name}`);
    made.setAttribute(name, value);
  }
  for (const child of node.childNodes) made.append(child instanceof Element ? copied(child) : document.createTextNode(child.textContent ?? ""));
  return made;
}

interface DrawingProps {
  /** Where the picture is; null shows none. */
  path: string | null;
  /** Another number asks for the picture again. */
  revision?: number;
  /** What can be selected, by tap and by the keys left and right in this order. */
  items: (picture: SVGSVGElement) => readonly SVGElement[];
  isSelected: (item: SVGElement) => boolean;
  onPick: (item: SVGElement) => void;
  /** Adds what is live; called after each change. */
  onDrawn?: (picture: SVGSVGElement) => void;
  kind: string;
  label: string;
}

export function Drawing({ path, revision = 0, items, isSelected, onPick, onDrawn, kind, label }: DrawingProps) {
  const frame = useRef<HTMLDivElement>(null);
  const [picture, setPicture] = useState<SVGSVGElement | null>(null);
  useLayoutEffect(() => {
    let isWanted = path !== null;
    if (path !== null) {
      askText(path).then(
        (text) => void (isWanted && setPicture(readPicture(text))),
        () => undefined, // the one before stays; that the server is lost is told elsewhere
      );
    }
    return () => {
      isWanted = false;
    };
  }, [path, revision]);
  useLayoutEffect(() => {
    frame.current?.replaceChildren(...(picture === null || path === null ? [] : [picture]));
  }, [picture, path === null]);
  useLayoutEffect(() => {
    if (picture === null) return;
    for (const item of items(picture)) {
      item.classList.add("pick");
      item.classList.toggle("selected", isSelected(item));
    }
    onDrawn?.(picture);
  });
  const choose = (item: SVGElement | undefined): void => void (item !== undefined && onPick(item));
  const tapped = (event: Event): void => choose((event.target as Element).closest<SVGElement>(".pick") ?? undefined);
  const walk = (event: KeyboardEvent): void => {
    const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    const all = picture === null ? [] : items(picture);
    if (by === 0 || all.length === 0) return;
    event.preventDefault();
    const at = by > 0 ? all.map(isSelected).lastIndexOf(true) : all.findIndex(isSelected);
    const next = all[Math.min(Math.max(at + by, 0), all.length - 1)];
    next?.scrollIntoView({ block: "nearest", inline: "nearest" });
    choose(next);
  };
  return <div class={kind} ref={frame} role="group" aria-label={label} tabIndex={0} onClick={tapped} onKeyDown={walk} />;
}
