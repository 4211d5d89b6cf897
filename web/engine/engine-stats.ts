/** A session's figures as the engine's interface has them. */
import type { Session } from "../core/session.ts";
import type { EngineStats } from "./engine-api.ts";

/** The core counts memory in KiB; here it is bytes. */
export function engineStats(session: Session): EngineStats {
  const stats = session.stats();
  return {
    bakeCount: stats.bakeCount,
    projectionCount: stats.projectionCount,
    memoryUsedBytes: stats.memoryUsedKib * 1024,
    memoryPeakBytes: stats.memoryPeakKib * 1024,
    memoryBudgetBytes: stats.memoryBudgetKib * 1024,
  };
}
