/** How every piece of work is timed, in Node and in the page. */
import type { Run } from "./engines/engine.ts";

export const WARM_UPS = 2;

/** Of the rounds that count; milliseconds. */
export interface Figures {
  /** Written (bake) or painted (project). */
  readonly texels: number;
  readonly median: number;
  readonly min: number;
  readonly max: number;
  /** Median, where a GPU takes part: from the start until a pixel of the result has been read, in the next frame. */
  readonly untilRead?: number;
}

/** Takes turns between the contestants, so that a slower moment of the machine meets all of them. */
export async function takeTurns<Contestant>(
  contestants: readonly Contestant[],
  rounds: number,
  run: (contestant: Contestant, round: number) => Promise<Run>,
): Promise<{ readonly contestant: Contestant; readonly figures: Figures }[]> {
  const runs = new Map<Contestant, Run[]>(contestants.map((contestant) => [contestant, []]));
  for (let round = 0; round < WARM_UPS + rounds; round++) {
    for (const contestant of contestants) {
      const result = await run(contestant, round);
      if (round >= WARM_UPS) runs.get(contestant)?.push(result);
    }
  }
  return contestants.map((contestant) => ({ contestant, figures: figuresOf(runs.get(contestant) ?? []) }));
}

function figuresOf(runs: readonly Run[]): Figures {
  const times = runs.map(({ milliseconds }) => milliseconds);
  const reads = runs.flatMap(({ untilRead }) => untilRead ?? []);
  return {
    ...{ texels: runs[0].texels, median: median(times), min: Math.min(...times), max: Math.max(...times) },
    ...(reads.length > 0 && { untilRead: median(reads) }),
  };
}

export function median(numbers: readonly number[]): number {
  const sorted = [...numbers].sort((a, b) => a - b);
  const middle = Math.floor(sorted.length / 2);
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}
