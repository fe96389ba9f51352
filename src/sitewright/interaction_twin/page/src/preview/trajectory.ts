// A trajectory from its exact bytes: cubic between knots, as it was certified and as it is executed.

const MICRO = 1e6;

export interface Trajectory {
  robot: string;
  sha256: string;
  times_s: number[];
  rows: Row[];
}

/** Positions, velocities, accelerations and jerks at a knot, by joint. */
interface Row {
  q: number[];
  v: number[];
  a: number[];
  j: number[];
}

/** The bytes are not the trajectory that the proposal names. */
export class WrongTrajectoryError extends Error {}

/** Reads a blob: an ASCII header `<robot>/<knots>x<joints>/`, then rows of little-endian int64. */
export async function readTrajectory(bytes: ArrayBuffer, expected: string): Promise<Trajectory> {
  const sha256 = hex(await crypto.subtle.digest("SHA-256", bytes));
  if (sha256 !== expected) throw new WrongTrajectoryError(`the trajectory has the hash ${sha256}, the plan names ${expected}`);
  const { robot, knots, joints, offset } = header(new Uint8Array(bytes));
  const view = new DataView(bytes, offset);
  const width = 1 + 4 * joints;
  if (view.byteLength !== knots * width * 8) throw new WrongTrajectoryError(`${view.byteLength} bytes are not ${knots} knots of ${joints} joints`);
  const at = (row: number, column: number): number => Number(view.getBigInt64((row * width + column) * 8, true)) / MICRO;
  const block = (row: number, first: number): number[] => Array.from({ length: joints }, (_, k) => at(row, first + k));
  const indices = Array.from({ length: knots }, (_, row) => row);
  return {
    robot,
    sha256,
    times_s: indices.map((row) => at(row, 0)),
    rows: indices.map((row) => ({
      q: block(row, 1),
      v: block(row, 1 + joints),
      a: block(row, 1 + 2 * joints),
      j: block(row, 1 + 3 * joints),
    })),
  };
}

function header(bytes: Uint8Array): { robot: string; knots: number; joints: number; offset: number } {
  const text = new TextDecoder("ascii").decode(bytes.subarray(0, 200));
  const match = /^(.+?)\/(\d+)x(\d+)\//s.exec(text);
  if (match?.[1] === undefined) throw new WrongTrajectoryError("the trajectory has no header");
  return { robot: match[1], knots: Number(match[2]), joints: Number(match[3]), offset: match[0].length };
}

function hex(digest: ArrayBuffer): string {
  return [...new Uint8Array(digest)].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}

/** Returns the joint positions at a time, clamped to the ends. */
export function positionsAt(trajectory: Trajectory, time_s: number): number[] {
  const { times_s, rows } = trajectory;
  const last = times_s.length - 1;
  const k = Math.min(Math.max(lastNotAfter(times_s, time_s), 0), last);
  const row = rows[k];
  if (row === undefined) return [];
  if (k === last || time_s <= 0) return row.q;
  const h = time_s - (times_s[k] ?? 0);
  return row.q.map((q, i) => q + h * ((row.v[i] ?? 0) + h * ((row.a[i] ?? 0) / 2 + (h * (row.j[i] ?? 0)) / 6)));
}

/** Returns the index of the last time that is not after `time_s`; -1 if all are. */
export function lastNotAfter(times_s: readonly number[], time_s: number): number {
  let low = 0;
  let high = times_s.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((times_s[middle] ?? 0) <= time_s) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}
