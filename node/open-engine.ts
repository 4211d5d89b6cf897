/** The engine as the command line uses it. */
import { existsSync } from "node:fs";
import { createEngineHost, type EngineHost } from "../web/engine/engine-host.ts";

/** A command has the machine to itself for a moment, unlike a page: nearly all that a 32-bit module can address. */
const MEMORY_BUDGET_MIB = 3584;

/** Where the module lies, seen from the bundle (build/node) and from the source (node). */
const WASM_PLACES = ["../wasm/texelcast.wasm", "../build/wasm/texelcast.wasm"];

export function openEngine(): EngineHost {
  const candidates = WASM_PLACES.map((place) => new URL(place, import.meta.url));
  const wasm = candidates.find((candidate) => existsSync(candidate));
  if (wasm === undefined) {
    throw new Error(`texelcast.wasm is in none of its places: ${candidates.map(String).join(", ")}`);
  }
  return createEngineHost({ wasm, memoryBudgetMib: MEMORY_BUDGET_MIB });
}
