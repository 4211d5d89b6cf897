/** The engine as the command line uses it. */
import { createEngineHost, type EngineHost } from "../web/engine/engine-host.ts";

/** A command has the machine to itself for a moment, unlike a page: nearly all that a 32-bit module can address. */
const MEMORY_BUDGET_MIB = 3584;

/** An engine without a model; whoever opens it ends it with `dispose`. */
export function openEngine(): EngineHost {
  return createEngineHost({ memoryBudgetMib: MEMORY_BUDGET_MIB });
}
