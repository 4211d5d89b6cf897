/** Parts that ask for one another, each maybe many times: what all of it comes to. */

/** The whole: what nobody asks for. */
export const WHOLE = "";

/**
 * All parts, each after every one that asks for it. Those of a ring, and what only they ask for, are left out: what asks for
 * itself is not drawn.
 */
export function askersFirst(asks: ReadonlyMap<string, ReadonlyMap<string, unknown>>): string[] {
  const waits = new Map<string, number>();
  for (const part of asks.keys()) waits.set(part, 0);
  for (const asked of asks.values()) for (const part of asked.keys()) waits.set(part, (waits.get(part) ?? 0) + 1);
  const ready = [...waits].filter(([, count]) => count === 0).map(([part]) => part);
  for (let next = 0; next < ready.length; next++) {
    for (const part of asks.get(ready[next] as string)?.keys() ?? []) {
      const left = (waits.get(part) ?? 0) - 1;
      waits.set(part, left);
      if (left === 0) ready.push(part);
    }
  }
  return ready;
}

/** Parts with a size of their own. */
export class AskedParts {
  readonly #own = new Map<string, number>();
  readonly #asks = new Map<string, Map<string, number>>([[WHOLE, new Map()]]);

  grow(part: string, by: number): void {
    this.#own.set(part, (this.#own.get(part) ?? 0) + by);
  }

  ask(asker: string, asked: string, count: number): void {
    const all = this.#asks.get(asker) ?? new Map<string, number>();
    all.set(asked, (all.get(asked) ?? 0) + count);
    this.#asks.set(asker, all);
  }

  /** The size of the whole, where each part counts as often as it is asked for. */
  total(): number {
    const times = new Map<string, number>([[WHOLE, 1]]);
    let total = 0;
    for (const asker of askersFirst(this.#asks)) {
      const often = times.get(asker) ?? 0;
      if (often === 0) continue;
      total += often * (this.#own.get(asker) ?? 0);
      for (const [asked, count] of this.#asks.get(asker) ?? []) {
        times.set(asked, (times.get(asked) ?? 0) + often * count);
      }
    }
    return total;
  }
}
