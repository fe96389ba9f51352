// What tests and benchmarks look at: how far the page is, and what a picture costs.
import type { FrameCost } from "./cell/stage";

const wishes = new URLSearchParams(location.search);

/** With `?freeze=1` nothing moves by itself: the picture is that of the scene document. */
export const isFrozen = wishes.get("freeze") === "1";
export const pixelRatio = Number(wishes.get("dpr") ?? Math.min(devicePixelRatio, 2));

interface Marks {
  marks: Record<string, number>;
  cost: FrameCost;
  costs: number[];
}

declare global {
  interface Window {
    __m: Marks;
  }
}

const KEPT = 240;
window.__m = { marks: {}, cost: { js_ms: 0, calls: 0 }, costs: [] };

export function mark(name: string): void {
  window.__m.marks[name] ??= performance.now();
}

export function measured(cost: FrameCost): void {
  window.__m.cost = { ...cost };
  window.__m.costs.push(cost.js_ms);
  if (window.__m.costs.length > KEPT) window.__m.costs.shift();
}
