// Asks the server; every answer that is no success is a refusal with words.
import { language } from "../words/words";
import type { Refusal } from "../wire";

/** The server said no; `refusal` says why. */
export class RefusedError extends Error {
  constructor(
    readonly status: number,
    readonly refusal: Refusal,
  ) {
    super(refusal.message);
  }
}

/** No answer came: nobody knows what the server made of it. */
export class NoAnswerError extends Error {}

interface Ask {
  method?: "GET" | "POST";
  body?: unknown;
  wait_ms?: number;
}

export async function ask<T>(path: string, { method = "GET", body, wait_ms = 8000 }: Ask = {}): Promise<T> {
  const response = await fetched(path, method, body, wait_ms);
  const answer: unknown = await response.json().catch(() => null);
  if (response.ok) return answer as T;
  throw new RefusedError(response.status, (answer as Refusal | null) ?? { error: "unreadable", message: `${response.status} ${response.statusText}` });
}

export async function askBytes(path: string): Promise<ArrayBuffer> {
  return (await answered(path)).arrayBuffer();
}

export async function askText(path: string): Promise<string> {
  return (await answered(path)).text();
}

async function answered(path: string): Promise<Response> {
  const response = await fetched(path, "GET", undefined, 20000);
  if (!response.ok) throw new RefusedError(response.status, { error: "unreadable", message: `${path}: ${response.status}` });
  return response;
}

/** Returns a path with the language in which sentences shall come back. */
export function inLanguage(path: string): string {
  return `${path}${path.includes("?") ? "&" : "?"}lang=${language.value}`;
}

async function fetched(path: string, method: string, body: unknown, wait_ms: number): Promise<Response> {
  const isPost = method === "POST";
  try {
    return await fetch(path, {
      method,
      headers: isPost ? { "content-type": "application/json" } : {},
      body: isPost ? JSON.stringify(body ?? {}) : null,
      credentials: "same-origin",
      signal: AbortSignal.timeout(wait_ms),
    });
  } catch (error) {
    throw new NoAnswerError(error instanceof Error ? error.message : String(error));
  }
}
