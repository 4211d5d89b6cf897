/**
 * Projects that were left before their newest step was kept, as another model was opened. One that the browser has refused is
 * told once, by its name, and waits for its next try without holding up what is open.
 */
import type { ProjectContent } from "./project.ts";

/** Takes a notice back. */
export type Withdraw = () => void;

interface Refusal {
  /** When it was tried last, as `performance.now()`. */
  readonly tried: number;
  readonly withdraw: Withdraw;
}

export class LeftProjects<Project extends object> {
  readonly #contents = new Map<Project, ProjectContent>();
  readonly #refusals = new Map<Project, Refusal>();
  readonly #retry: number;

  /** @param retry milliseconds between two tries of one that was refused */
  constructor(retry: number) {
    this.#retry = retry;
  }

  get isEmpty(): boolean {
    return this.#contents.size === 0;
  }

  put(project: Project, content: ProjectContent): void {
    this.#contents.set(project, content);
  }

  /** It is kept now, or open again. Returns whether it had been told that it was not. */
  drop(project: Project): boolean {
    this.#contents.delete(project);
    const refusal = this.#refusals.get(project);
    this.#refusals.delete(project);
    refusal?.withdraw();
    return refusal !== undefined;
  }

  /** It is in a file: nothing of it is lost any more. */
  dropModel(model: ProjectContent["model"]): void {
    for (const [project, content] of this.#contents) if (content.model === model) this.drop(project);
  }

  /** Those whose turn it is. */
  due(now: number): readonly (readonly [Project, ProjectContent])[] {
    return [...this.#contents].filter(([project]) => this.#at(project, now) <= now);
  }

  all(): readonly (readonly [Project, ProjectContent])[] {
    return [...this.#contents];
  }

  /** When the next one's turn is; `soon` for those that were not refused. */
  nextAt(soon: number): number {
    return Math.min(...[...this.#contents.keys()].map((project) => this.#at(project, soon)));
  }

  /** The browser would not keep it; `tell` is called the first time. */
  refused(project: Project, tried: number, tell: () => Withdraw): void {
    const withdraw = this.#refusals.get(project)?.withdraw ?? tell();
    this.#refusals.set(project, { tried, withdraw });
  }

  #at(project: Project, soon: number): number {
    const refusal = this.#refusals.get(project);
    return refusal ? refusal.tried + this.#retry : soon;
  }
}
