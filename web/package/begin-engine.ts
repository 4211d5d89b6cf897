/** An engine for the package's entries. A file of its own: `texelcast/three` must not load the whole of `texelcast/core` for it. */
import { between, checkFields, checkValue, maybe, OBJECT } from "../engine/check-value.ts";
import type { Engine } from "../engine/engine-api.ts";
import { createEngineClient, type EngineClientOptions } from "../engine/engine-client.ts";
import { refused } from "../engine/refused-worker.ts";

const OPTIONS = {
  memoryBudgetMib: maybe(between(1, 65_536)),
  createWorker: maybe({ must: "a function", holds: (value) => typeof value === "function" }),
};

/** @throws TexelcastError "bad-argument", and "unsupported" where the page lets no worker begin, with what to set. */
export function beginEngine(options: EngineClientOptions): Engine {
  checkValue(options, OBJECT, "options");
  checkFields(options, OPTIONS, "");
  try {
    return createEngineClient(options);
  } catch (thrown) {
    throw refused(thrown);
  }
}
