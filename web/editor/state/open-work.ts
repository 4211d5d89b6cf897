/** Work that goes on after the call that began it, and that others wait for. */
export class OpenWork {
  readonly #begun = new Set<Promise<unknown>>();

  /** Counts work as under way until it is done or has failed. */
  add(work: Promise<unknown>): void {
    this.#begun.add(work);
    const ended = (): void => void this.#begun.delete(work);
    work.then(ended, ended);
  }

  get underWay(): boolean {
    return this.#begun.size > 0;
  }

  /**
   * Resolves when none is left, that which was begun in the meantime included. A list: what a page puts in the place of the
   * browser's own (zone.js, in its file for script tags) sees nothing in a set, and this would never let go of the thread.
   */
  async settled(): Promise<void> {
    while (this.#begun.size > 0) await Promise.allSettled([...this.#begun]);
  }
}
