/** Changes of layers that wait for something slow, a text's font or the room that its words take up, to be recorded then. */

export interface WaitingChange<Patch extends object> {
  readonly id: string;
  /** What is left of it: empty when later changes have taken the place of all. */
  patch: Patch;
}

export class WaitingChanges<Patch extends object> {
  readonly #waiting = new Set<WaitingChange<Patch>>();

  /** What waits for the layer gives up the fields that it was now asked for anew: each ends as it was asked for last. */
  supersede(id: string, patch: Patch): void {
    for (const older of this.#waiting) {
      if (older.id !== id) continue;
      const fields = Object.entries(older.patch);
      const left = fields.filter(([name]) => !Object.hasOwn(patch, name));
      if (left.length < fields.length) older.patch = Object.fromEntries(left) as Patch;
    }
  }

  /** Lets a change wait until `work`, which is given it, is done or has failed. */
  add<T>(change: WaitingChange<Patch>, work: (change: WaitingChange<Patch>) => Promise<T>): Promise<T> {
    this.#waiting.add(change);
    return work(change).finally(() => this.#waiting.delete(change));
  }

  /** The one that waits; undefined for none, and for several. */
  get only(): WaitingChange<Patch> | undefined {
    const [first, ...more] = this.#waiting;
    return more.length > 0 ? undefined : first;
  }
}
