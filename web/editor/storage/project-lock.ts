/**
 * Which tab has a project open. Where the browser has no Web Locks (a page by plain http), every tab is told yes: the store
 * itself still refuses a save over one that the tab has not seen.
 */

/** A page that is being reloaded lets go of its locks a moment after the new one has begun. */
const PATIENCE = 500;

const nameOf = (id: string): string => `texelcast-project-${id}`;

export class ProjectLock {
  #held: string | null = null;
  #release: (() => void) | null = null;

  /** Lets go of the project before and takes this one; false where another tab has it. */
  async take(id: string): Promise<boolean> {
    if (this.#held === id) return true;
    this.letGo();
    this.#held = id;
    const { locks } = navigator;
    if (!locks) return true;
    const taken = await new Promise<boolean>((resolve) => {
      const keep = (): Promise<void> => {
        resolve(true);
        // Another one may have been taken while this one was waited for.
        if (this.#held !== id) return Promise.resolve();
        return new Promise((release) => {
          this.#release = release;
        });
      };
      const wait = { signal: AbortSignal.timeout(PATIENCE) };
      locks.request(nameOf(id), wait, keep).catch(() => resolve(false));
    });
    if (!taken && this.#held === id) this.#held = null;
    return taken;
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
