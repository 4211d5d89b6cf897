/**
 * `texelcast/node`: for servers. Print files and print reports of designs, byte for byte as the element makes them, and the
 * engine in this thread.
 */
import { createEngineHost, type EngineHost, type EngineHostOptions } from "../web/engine/engine-host.ts";
import { checkEngineOptions } from "./print-arguments.ts";

export { TexelcastError, type TexelcastErrorDetails, type TexelcastErrorJson } from "../web/core/texelcast-error.ts";
export type { CoreSource } from "../web/core/wasm-module.ts";
export type { Design, DesignAsset, DesignLayer } from "../web/editor/document/design.ts";
export { parseDesign } from "../web/editor/document/parse-design.ts";
export { resolveLayers } from "../web/editor/document/resolve-layers.ts";
export { parseZones } from "../web/editor/document/zones.ts";
export type * from "../web/engine/engine-api.ts";
export type { EngineHost } from "../web/engine/engine-host.ts";
export type * from "../web/engine/print-report.ts";
export type { PrintZone, PrintZones } from "../web/engine/print-zones.ts";
export * from "./print.ts";

export type EngineOptions = EngineHostOptions;

/**
 * Starts an engine in this thread. What is wrong with its WebAssembly shows at the first call.
 *
 * @throws TexelcastError "bad-argument"
 */
export function createEngine(options: EngineOptions = {}): EngineHost {
  checkEngineOptions(options);
  return createEngineHost(options);
}
