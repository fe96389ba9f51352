// Where the nodes of the relationship graph stand: each one row above the highest thing it rests on.
import type { ComponentRecord } from "../wire";

export interface Place {
  column: number;
  row: number;
}

export interface Rows {
  places: ReadonlyMap<string, Place>;
  columns: number;
  rows: number;
}

export function rowsOf(components: readonly ComponentRecord[]): Rows {
  const known = new Map(components.map((c) => [c.id, c]));
  const rows = new Map<string, number>();
  const rowOf = (id: string): number => {
    const found = rows.get(id);
    if (found !== undefined) return found;
    rows.set(id, 1); // a cycle would be refused by the model's check; it must not hang the page
    const below = (known.get(id)?.parents ?? []).filter((parent) => known.has(parent));
    const row = 1 + Math.max(0, ...below.map(rowOf));
    rows.set(id, row);
    return row;
  };
  components.forEach((c) => rowOf(c.id));
  const members = new Map<number, string[]>();
  for (const [id, row] of rows) members.set(row, [...(members.get(row) ?? []), id]);
  const columns = Math.max(1, ...[...members.values()].map((row) => row.length));
  const places = new Map<string, Place>();
  for (const [row, ids] of members) {
    const shift = (columns - ids.length) / 2;
    ids.sort((a, b) => a.localeCompare(b, "en", { numeric: true })).forEach((id, index) => places.set(id, { row, column: shift + index }));
  }
  return { places, columns, rows: Math.max(0, ...rows.values()) };
}
