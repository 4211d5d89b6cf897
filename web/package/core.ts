/**
 * `texelcast/core`: the engine alone, in a worker of its own. Give it a model, pictures and layers; it gives back changed
 * texels, PNG and GLB. Importing it has no side effects; the worker starts with `createEngine`.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Engine } from "../engine/engine-api.ts";
import type { EngineClientOptions } from "../engine/engine-client.ts";
import { beginEngine } from "./begin-engine.ts";

export { TexelcastError, type TexelcastErrorDetails, type TexelcastErrorJson } from "../core/texelcast-error.ts";
export type { CoreSource } from "../core/wasm-module.ts";
export type { Design, DesignAsset, DesignLayer } from "../editor/document/design.ts";
export { parseDesign } from "../editor/document/parse-design.ts";
export { resolveLayers } from "../editor/document/resolve-layers.ts";
export { parseZones } from "../editor/document/zones.ts";
export type * from "../engine/engine-api.ts";
// What its methods take and give.
export type * from "../engine/print-report.ts";
export type { PrintZone, PrintZones } from "../engine/print-zones.ts";

export type EngineOptions = EngineClientOptions;

/**
 * Starts an engine. What is wrong with its WebAssembly or its worker shows at the first call, which rejects with a
 * TexelcastError ("missing-file", "unsupported", "engine-crashed").
 *
 * @throws TexelcastError "bad-argument" for options that are none; "unsupported" where there are no workers, on a server, or the page
 * lets none begin: one in an iframe whose sandbox has no allow-same-origin, or with Trusted Types and no policy for it.
 */
export function createEngine(options: EngineOptions = {}): Engine {
  if (typeof Worker === "undefined" && !options.createWorker) {
    throw new TexelcastError("unsupported", "The engine runs in a worker, and there are none here.", {
      hint: "On a server, create it by texelcast/node.",
    });
  }
  return beginEngine(options);
}
