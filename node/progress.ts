/** A line on the terminal while something takes long; silent in scripts. */
import { formatShare } from "./terminal-text.ts";

/** What is done in less is not worth a line that flickers by. */
const SHOW_AFTER_MILLISECONDS = 1000;
const REDRAW_MILLISECONDS = 100;
const ERASE_LINE = "\r\u001b[K";

export class Progress {
  readonly #isShown = process.stderr.isTTY === true;
  readonly #begin = performance.now();
  #drawn = 0;

  /** @param share 0 to 1, where it is known. */
  report(task: string, share?: number): void {
    if (!this.#isShown) return;
    const now = performance.now();
    if (now - this.#begin < SHOW_AFTER_MILLISECONDS || now - this.#drawn < REDRAW_MILLISECONDS) return;
    this.#drawn = now;
    process.stderr.write(`${ERASE_LINE}${task}${share === undefined ? " …" : ` ${formatShare(share)}`}`);
  }

  /** Takes the line away, before anything else is written. */
  end(): void {
    if (this.#drawn > 0) process.stderr.write(ERASE_LINE);
    this.#drawn = 0;
  }
}
