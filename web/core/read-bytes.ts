import { TexelcastError } from "./texelcast-error.ts";

/** Whether this is Node (or alike), where `fetch` does not read files. */
export const inNode: boolean = typeof process !== "undefined" && typeof process.versions?.node === "string";

/**
 * The bytes at an address: http(s), data, blob, and in Node also file. Rejects with "missing-file" naming `what`
 * and the address.
 */
export async function readBytes(address: URL | string, what: string): Promise<Uint8Array<ArrayBuffer>> {
  try {
    const text = String(address);
    const isFileAddress = text.startsWith("file:");
    if (inNode && (isFileAddress || !/^[a-z][a-z0-9+.-]+:/i.test(text))) {
      // Not a literal, so that a bundler for the browser does not try to follow it.
      const fileModule = "node:fs/promises";
      const files = (await import(/* @vite-ignore */ fileModule)) as typeof import("node:fs/promises");
      return new Uint8Array(await files.readFile(isFileAddress ? new URL(text) : text));
    }
    const response = await fetch(address);
    if (!response.ok) throw new Error(`the server answered ${response.status} ${response.statusText}`);
    return new Uint8Array(await response.arrayBuffer());
  } catch (cause) {
    // Node's own "fetch failed" says why in its cause alone.
    const { message } = ((cause as Error).cause ?? cause) as Error;
    throw new TexelcastError("missing-file", `${what} could not be read from ${address}: ${message}.`, {
      subject: String(address),
      reason: "not-loaded",
      hint: "Check its address.",
      cause,
    });
  }
}
