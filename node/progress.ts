/** A line on the terminal while something takes long; silent in scripts. */
import { formatShare } from "./terminal-text.ts";

const REDRAW_MILLISECONDS = 100;
const ERASE_LINE = "\r\u001b[K";

/**
 * What is under way is shown from its beginning, because the engine's longer steps leave no moment to show it later;
 * what is over at once is gone before an eye could read it.
 */
export class Progress {
  readonly #isShown = process.stderr.isTTY === true;
  #task = "";
  #drawn = 0;

  /** @param share 0 to 1, where it is known. */
  report(task: string, share?: number): void {
    if (!this.#isShown) return;
    const now = performance.now();
    if (task === this.#task && now - this.#drawn < REDRAW_MILLISECONDS) return;
    this.#task = task;
    this.#drawn = now;
    process.stderr.write(`${ERASE_LINE}${task}${share === undefined ? " …" : ` ${formatShare(share)}`}`);
  }

  /** Takes the line away, before anything else is written. */
  end(): void {
    if (this.#task !== "") process.stderr.write(ERASE_LINE);
    this.#task = "";
  }
}
