/** Runs a task at most once per animation frame, however often it is asked for. */
export class FrameTask {
  readonly #task: () => void;
  #request = 0;

  constructor(task: () => void) {
    this.#task = task;
  }

  request(): void {
    if (this.#request === 0) {
      this.#request = requestAnimationFrame(() => {
        this.#request = 0;
        this.#task();
      });
    }
  }

  /** Runs a task that waits now instead of in the next frame. */
  flush(): void {
    if (this.#request !== 0) {
      this.cancel();
      this.#task();
    }
  }

  cancel(): void {
    cancelAnimationFrame(this.#request);
    this.#request = 0;
  }
}
