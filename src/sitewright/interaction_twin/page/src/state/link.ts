// The connection to the server and what is true about it: live, old, or lost.
import { Matrix4 } from "three";
import { age_s, events, joints, link, piecePoses, run } from "./store";
import { ask } from "./server";
import type { CaughtUp, RunEvent, RunState, Ticket } from "../wire";
import { language } from "../words/words";

const STALE_MS = 500;
const QUIET_MS = 450;
const PROBE_MS = 400;
const RETRY_MS = 400;
const HEADER_BYTES = 16;
const KEPT_EVENTS = 400;

interface Ends {
  onState(state: RunState): void;
  onSceneEpoch(epoch: number): void;
  onConnected(): void;
}

/** Keeps a socket open, and says within a second when that is not so any more. */
export class ServerLink {
  private socket: WebSocket | null = null;
  private heard_ms = performance.now();
  private sensed_ms = performance.now();
  private lastSensed = 0;
  private last: { run: string; n: number } | null = null;
  private isProbing = false;

  constructor(private readonly ends: Ends) {}

  start(): void {
    void this.connect();
    language.subscribe(() => this.askAgain());
    setInterval(() => this.watch(), 100);
  }

  private async connect(): Promise<void> {
    try {
      const { ticket } = await ask<Ticket>("/api/ws-ticket", { method: "POST", wait_ms: 1000 });
      this.open(ticket);
    } catch {
      this.lose();
    }
  }

  private open(ticket: string): void {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/ws`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => socket.send(JSON.stringify({ ticket, after: this.last, lang: language.value }));
    socket.onmessage = (message: MessageEvent<string | ArrayBuffer>) => this.hear(message.data);
    socket.onclose = () => this.lose();
    this.socket = socket;
  }

  /** Asks for state and events anew, in the language that was just chosen. */
  private askAgain(): void {
    if (this.socket?.readyState !== WebSocket.OPEN) return;
    const first = events.value[0];
    events.value = [];
    this.socket.send(JSON.stringify({ lang: language.value, after: first === undefined ? this.last : { run: first.run, n: first.n - 1 } }));
  }

  private lose(): void {
    if (this.socket !== null) {
      this.socket.onclose = this.socket.onmessage = null;
      this.socket.close();
      this.socket = null;
    }
    link.value = "lost";
    setTimeout(() => void this.connect(), RETRY_MS);
  }

  private hear(data: string | ArrayBuffer): void {
    this.heard_ms = performance.now();
    if (typeof data !== "string") {
      this.hearBinary(data);
      return;
    }
    const message = JSON.parse(data) as RunState | RunEvent | CaughtUp;
    if (message.type === "event") {
      this.last = { run: message.run, n: message.n };
      events.value = [...events.value.slice(-KEPT_EVENTS), message];
    } else if (message.type === "state") {
      this.back();
      run.value = message;
      this.ends.onState(message);
      this.ends.onSceneEpoch(message.scene_epoch);
    }
  }

  private back(): void {
    if (link.value !== "lost" && link.value !== "connecting") return;
    link.value = "stale";
    this.ends.onConnected();
  }

  private hearBinary(data: ArrayBuffer): void {
    const view = new DataView(data);
    const kind = view.getUint8(0);
    this.ends.onSceneEpoch(view.getUint16(2, true));
    const sensed = view.getFloat64(8, true);
    const values = new Float32Array(data.slice(HEADER_BYTES));
    if (kind === 2) {
      piecePoses.value = values;
      return;
    }
    joints.value = values;
    if (sensed > this.lastSensed) {
      this.lastSensed = sensed;
      this.sensed_ms = performance.now();
      if (link.value === "stale") link.value = "live";
      age_s.value = 0;
    }
  }

  private watch(): void {
    const now = performance.now();
    const old_ms = now - this.sensed_ms;
    if (old_ms > STALE_MS) {
      age_s.value = Math.floor(old_ms / 500) / 2;
      if (link.value === "live") link.value = "stale";
    }
    if (now - this.heard_ms > QUIET_MS && this.socket?.readyState === WebSocket.OPEN && !this.isProbing) void this.probe();
  }

  /** Asks over plain HTTP whether the server is there: a socket whose other end froze says nothing. */
  private async probe(): Promise<void> {
    this.isProbing = true;
    try {
      await ask("/api/state", { wait_ms: PROBE_MS });
      this.heard_ms = performance.now();
    } catch {
      this.lose();
    } finally {
      this.isProbing = false;
    }
  }
}

const FLOATS_PER_PIECE = 8;

/** Returns poses by component index from a frame of pieces: index (u16), 0 (u16), x y z, w x y z. */
export function posesIn(frame: Float32Array): Map<number, Matrix4> {
  const words = new DataView(frame.buffer, frame.byteOffset, frame.byteLength);
  const found = new Map<number, Matrix4>();
  for (let at = 0; at + FLOATS_PER_PIECE <= frame.length; at += FLOATS_PER_PIECE) {
    const [x, y, z, qw, qx, qy, qz] = frame.subarray(at + 1, at + FLOATS_PER_PIECE) as unknown as number[];
    found.set(words.getUint16(at * 4, true), fromQuaternion([x, y, z] as number[], [qw, qx, qy, qz] as number[]));
  }
  return found;
}

function fromQuaternion(place: number[], q_wxyz: number[]): Matrix4 {
  const [w = 1, x = 0, y = 0, z = 0] = q_wxyz;
  const turn = new Matrix4().set(
    1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), place[0] ?? 0,
    2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), place[1] ?? 0,
    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), place[2] ?? 0,
    0, 0, 0, 1,
  );
  return turn;
}
