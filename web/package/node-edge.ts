/**
 * `texelcast/node` at an edge, where neither Node nor a page runs it: documents are read there as anywhere. The engine is refused, since
 * such runtimes compile no WebAssembly that they meet at run time.
 */
import { TexelcastError } from "./core.ts";

export { parseDesign, parseZones, resolveLayers, TexelcastError } from "./core.ts";

function refusal(): TexelcastError {
  return new TexelcastError("unsupported", "texelcast/node runs in Node, Bun and Deno, and this is none of them.", {
    hint: "Print on a server with one of them, and ask it from here.",
  });
}

/** Throws: an engine is started by a server of Node's kind. */
export function createEngine(): never {
  throw refusal();
}

/** Rejects, as `createEngine` throws. */
export async function renderPrint(): Promise<never> {
  throw refusal();
}

/** Rejects, as `createEngine` throws. */
export async function checkPrint(): Promise<never> {
  throw refusal();
}
