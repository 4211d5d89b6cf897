/**
 * Which tab has a project open. Where the browser has no Web Locks (a page by plain http), every tab is told yes: the store
 * itself still refuses a save over one that the tab has not seen.
 */

/** A page that is being reloaded lets go of its locks a moment after the new one has begun: it is given that moment. */
const TRIES = 5;
const BETWEEN_TRIES = 150;

const nameOf = (id: string): string => `texelcast-project-${id}`;

export class ProjectLock {
  #held: string | null = null;
  #release: (() => void) | null = null;

  /** Lets go of the project before and takes this one; false where another tab has it. */
  async take(id: string): Promise<boolean> {
    if (this.#held === id) return true;
    this.letGo();
    this.#held = id;
    for (let tries = 1; this.#held === id; tries++) {
      if (await this.#request(id)) return true;
      if (tries === TRIES) {
        if (this.#held === id) this.#held = null;
        return false;
      }
      await new Promise((resolve) => setTimeout(resolve, BETWEEN_TRIES));
    }
    // Another one was taken meanwhile.
    return false;
  }

  /** Asks once, and is told at once. */
  #request(id: string): Promise<boolean> {
    const { locks } = navigator;
    if (!locks) return Promise.resolve(true);
    return new Promise((resolve) => {
      const keep = (lock: Lock | null): Promise<void> | undefined => {
        resolve(lock !== null);
        if (lock === null || this.#held !== id) return;
        return new Promise((release) => {
          this.#release = release;
        });
      };
      // A browser that refuses locks (a sandboxed frame) has nobody to share with.
      locks.request(nameOf(id), { ifAvailable: true }, keep).catch(() => resolve(true));
    });
  }

  letGo(): void {
    this.#release?.();
    this.#release = null;
    this.#held = null;
  }

  /** Ids of the projects that other tabs have open, as far as the browser tells. */
  async elsewhere(): Promise<ReadonlySet<string>> {
    const held = (await navigator.locks?.query().catch(() => undefined))?.held ?? [];
    const ids = held.map(({ name }) => name?.slice(nameOf("").length) ?? "");
    return new Set(ids.filter((id) => id !== this.#held));
  }
}
