/**
 * What the shop's page and the editor's page in its iframe say to each other. First two messages between the windows, each
 * with an exact origin: the editor's hello, and the shop's answer with one end of a MessageChannel; all else goes through that
 * channel, which no third window can reach.
 */
import type { TexelcastErrorJson } from "../core/texelcast-error.ts";

/** Raised when a side of an older version would misunderstand. */
export const EMBED_VERSION = 1;

/** Where the editor's page finds the origin of the shop that framed it. */
export const SHOP_PARAMETER = "shop";

/** A shop's moderation may ask a service, or a person. */
export const ACCEPTANCE_PATIENCE_MS = 120_000;

/** Through the channel, either way. */
export type ChannelMessage =
  | { readonly kind: "request"; readonly id: number; readonly method: string; readonly args: readonly unknown[] }
  | { readonly kind: "result"; readonly id: number; readonly value: unknown }
  | { readonly kind: "failure"; readonly id: number; readonly error: TexelcastErrorJson }
  | { readonly kind: "event"; readonly name: string; readonly detail: unknown };

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/**
 * A hello (the editor's page runs, and waits for a channel) or the shop's answer "connect", with which the channel's port comes;
 * of whatever version. The nonce is used once: the answer that repeats it belongs to this load of the page. Null: something else.
 */
export function readGreeting<Kind extends "hello" | "connect">(
  data: unknown,
  kind: Kind,
): { readonly version: number; readonly nonce: string } | null {
  if (!isRecord(data) || data.texelcast !== kind) return null;
  const { version, nonce } = data;
  if (typeof version !== "number" || typeof nonce !== "string" || !/^[0-9a-f]{32}$/.test(nonce)) return null;
  return { version, nonce };
}

/** A message of the channel; null: it is malformed. */
export function readChannelMessage(data: unknown): ChannelMessage | null {
  if (!isRecord(data)) return null;
  const { kind, id, method, args, name, error } = data;
  if (kind === "event") return typeof name === "string" ? { kind, name, detail: data.detail } : null;
  if (typeof id !== "number" || !Number.isSafeInteger(id)) return null;
  if (kind === "request") {
    return typeof method === "string" && Array.isArray(args) ? { kind, id, method, args } : null;
  }
  if (kind === "result") return { kind, id, value: data.value };
  if (kind !== "failure" || !isRecord(error)) return null;
  return typeof error.code === "string" && typeof error.message === "string"
    ? { kind, id, error: error as unknown as TexelcastErrorJson }
    : null;
}

/** 128 random bits, as 32 hex digits. */
export function makeNonce(): string {
  return [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
