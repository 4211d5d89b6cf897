/** An engine for the package's entries. A file of its own: `texelcast/three` must not load the whole of `texelcast/core` for it. */
import type { Engine } from "../engine/engine-api.ts";
import { createEngineClient, type EngineClientOptions } from "../engine/engine-client.ts";
import { refused } from "../engine/refused-worker.ts";

/** @throws TexelcastError "unsupported" where the page lets no worker begin, with what to set. */
export function beginEngine(options: EngineClientOptions): Engine {
  try {
    return createEngineClient(options);
  } catch (thrown) {
    throw refused(thrown);
  }
}
