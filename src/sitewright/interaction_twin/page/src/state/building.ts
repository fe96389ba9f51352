// The order in which a building grows, for the slider of the building screen.
import type { ComponentRecord } from "../wire";

/** Returns what is to be built in an order in which everything stands on what was there before. */
export function buildingOrder(components: readonly ComponentRecord[]): ComponentRecord[] {
  const wanted = components.filter((c) => c.layer === "target" || c.layer === "as_built");
  const left = new Map(wanted.map((c) => [c.id, c]));
  const ordered: ComponentRecord[] = [];
  while (left.size > 0) {
    const ready = [...left.values()].filter((c) => ![...c.parents, ...c.waits_for].some((id) => left.has(id)));
    const next = (ready.length > 0 ? ready : [...left.values()]).sort(byTurn)[0];
    if (next === undefined) break;
    ordered.push(next);
    left.delete(next.id);
  }
  return ordered;
}

function byTurn(a: ComponentRecord, b: ComponentRecord): number {
  const built = Number(b.layer === "as_built") - Number(a.layer === "as_built");
  return built || (a.order ?? Infinity) - (b.order ?? Infinity) || a.id.localeCompare(b.id, "en", { numeric: true });
}

export function standingIds(components: readonly ComponentRecord[], count: number): ReadonlySet<string> {
  return new Set(buildingOrder(components).slice(0, count).map((c) => c.id));
}
