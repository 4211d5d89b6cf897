/** A model from the web: its bytes, and the files that a .gltf names. */
import { parseUrl } from "../../core/parse-url.ts";
import { TexelcastError } from "../../core/texelcast-error.ts";
import { ToldError } from "../../editor/strings/told-error.ts";
import type { ModelSource } from "../../engine/engine-api.ts";
import type { Words } from "../words/words.ts";

export interface Fetching {
  readonly words: Words;
  readonly signal: AbortSignal;
  /** 0 to 1; not called where the server does not say how much there is. */
  readonly progress?: (share: number) => void;
}

/** Fetches a model. Rejects with "missing-file" or "cancelled". */
export async function fetchModel(address: string, base: string, fetching: Fetching): Promise<ModelSource> {
  const url = addressOf(address, base, fetching.words);
  const bytes = await fetchBytes(url, fetching);
  // Behind an archive's address, which of its models is meant.
  const name = nameOf(url, url.hash);
  const isText = bytes[0] === 0x7b || bytes[0] === 0x20 || bytes[0] === 0x0a || bytes[0] === 0xef;
  return isText ? { name, bytes, resources: await fetchSideFiles({ name, bytes }, url, fetching) } : { name, bytes };
}

async function fetchSideFiles(
  model: ModelSource,
  url: URL,
  { words, signal }: Fetching,
): Promise<ReadonlyMap<string, Uint8Array>> {
  const { listSideFiles } = await import("../../engine/gltf-container.ts");
  const addresses = listSideFiles(model).filter((address) => addressOf(address, url.href, words).origin === url.origin);
  const files = await Promise.all(
    addresses.map(async (address) => {
      const bytes = await fetchBytes(addressOf(address, url.href, words), { words, signal });
      return [address, bytes] as const;
    }),
  );
  return new Map(files);
}

/** The whole of what lies at an address. Rejects with "missing-file", and where it is called off with the signal's own reason or "cancelled". */
export async function fetchBytes(url: URL, { words, signal, progress }: Fetching): Promise<Uint8Array> {
  try {
    const response = await fetch(url, { signal });
    if (!response.ok || response.body === null) throw new Error(`status ${response.status}`);
    // Of a compressed answer the length is not that of what comes.
    const length = response.headers.has("content-encoding") ? 0 : Number(response.headers.get("content-length"));
    if (!progress || !(length > 0)) return new Uint8Array(await response.arrayBuffer());
    const parts: Uint8Array[] = [];
    let got = 0;
    const reader = response.body.getReader();
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      parts.push(part.value);
      got += part.value.length;
      progress(Math.min(1, got / length));
    }
    const whole = new Uint8Array(got);
    let at = 0;
    for (const part of parts) {
      whole.set(part, at);
      at += part.length;
    }
    return whole;
  } catch (cause) {
    if (signal.aborted) throw TexelcastError.wrap(signal.reason, "cancelled", `${url.href} is not wanted any more.`);
    throw unreachable(url.href, words, cause);
  }
}

export function addressOf(address: string, base: string, words: Words): URL {
  const url = parseUrl(address, base);
  if (url === null) throw unreachable(address, words);
  return url;
}

/** The last part of an address, as people would call the file, and what comes `behind` it. */
export function nameOf(url: URL, behind = ""): string {
  const last = url.pathname.slice(url.pathname.lastIndexOf("/") + 1) + behind;
  try {
    return decodeURIComponent(last) || url.host;
  } catch {
    return last;
  }
}

const unreachable = (address: string, { errors }: Words, cause?: unknown): TexelcastError =>
  new ToldError("missing-file", errors.unreachable(address), {
    subject: address,
    hint: errors.unreachableHint,
    cause,
  });
