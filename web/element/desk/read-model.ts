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
  /** Of what has more bytes than these, no more is waited for than shows it: an answer may have no end. */
  readonly most?: number;
}

/** Fetches a model. Rejects with "missing-file" or "cancelled". */
export async function fetchModel(address: string, base: string, fetching: Fetching): Promise<ModelSource> {
  const url = addressOf(address, base, fetching.words);
  const bytes = await fetchBytes(url, fetching);
  // Behind an archive's address, which of its models is meant.
  const name = nameOf(url, url.hash);
  const isText = [0x7b, 0x20, 0x0a, 0xef].includes(bytes[0] ?? 0);
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

/**
 * The whole of what lies at an address. Rejects with "missing-file", its reason "http-404" (or whichever status) or
 * "not-answered" (no network, or a server that does not let the page read it: browsers do not say which), and where it is called
 * off with the signal's own reason or "cancelled".
 */
export async function fetchBytes(url: URL, { words, signal, progress, most }: Fetching): Promise<Uint8Array> {
  let refusal = "";
  try {
    const response = await fetch(url, { signal });
    const { body, headers } = response;
    if (!response.ok) {
      refusal = String(response.status);
      throw new Error(refusal);
    }
    // Of a compressed answer the length is not that of what comes.
    const length = headers.has("content-encoding") ? 0 : Number(headers.get("content-length"));
    let got = 0;
    const told = new TransformStream<Uint8Array<ArrayBuffer>, Uint8Array>({
      transform(part, rest) {
        got += part.length;
        if (length > 0) progress?.(Math.min(1, got / length));
        rest.enqueue(part);
        if (got > (most ?? got)) rest.terminate();
      },
    });
    return new Uint8Array(await new Response(body?.pipeThrough(told)).arrayBuffer());
  } catch (cause) {
    if (signal.aborted) throw TexelcastError.wrap(signal.reason, "cancelled", words.errors.notReady);
    throw unreachable(url.href, words, cause, refusal);
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

/** @param status That the server answered with, "" where it did not. */
const unreachable = (address: string, { errors }: Words, cause?: unknown, status = ""): TexelcastError =>
  new ToldError("missing-file", errors.unreachable(address), {
    subject: address,
    hint: errors.unreachableHint + (status && ` (HTTP ${status})`),
    reason: status ? `http-${status}` : "not-answered",
    cause,
  });
