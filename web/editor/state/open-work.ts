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

  /** Resolves when none is left, that which was begun in the meantime included. */
  async settled(): Promise<void> {
    while (this.#begun.size > 0) await Promise.allSettled(this.#begun);
  }
}
