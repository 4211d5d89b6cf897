import type { CoreSource } from "../core/wasm-module.ts";

/** The worker's own address is another one than the page's, so a relative address must be made whole here. */
export function sendable(wasm: CoreSource): Exclude<CoreSource, URL> {
  if (typeof wasm !== "string" && !(wasm instanceof URL)) return wasm;
  return typeof location === "undefined" ? String(wasm) : new URL(wasm, location.href).href;
}
