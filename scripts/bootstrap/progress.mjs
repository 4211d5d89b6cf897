/**
 * Calm progress lines. All of them go to stderr: what a command prints on stdout is its result alone.
 */
export class Progress {
  #quiet;
  #worked = false;

  /** @param {{quiet: boolean}} options quiet: say nothing while there is nothing to do */
  constructor({ quiet }) {
    this.#quiet = quiet;
  }

  /** @param {string} text */
  line(text) {
    process.stderr.write(`${text}\n`);
  }

  /**
   * Announces a piece of work, does it, and says how long it took.
   * @template T
   * @param {string} title @param {() => Promise<T> | T} work
   * @returns {Promise<T>}
   */
  async work(title, work) {
    if (!this.#worked) this.line("Setting up what is missing or out of date:");
    this.#worked = true;
    this.line(`  ${title} …`);
    const start = performance.now();
    const result = await work();
    this.line(`  ${title}: done in ${seconds(performance.now() - start)}`);
    return result;
  }

  /** @param {number} milliseconds */
  end(milliseconds) {
    if (this.#worked) this.line(`Set up in ${seconds(milliseconds)}.`);
    else if (!this.#quiet) this.line(`Everything is in place (${Math.round(milliseconds)} ms).`);
  }
}

/** @param {number} milliseconds */
export function seconds(milliseconds) {
  return milliseconds < 9950 ? `${(milliseconds / 1000).toFixed(1)} s` : `${Math.round(milliseconds / 1000)} s`;
}
