/** Runs a task at most once per animation frame, however often it is asked for. */
export class FrameTask {
  readonly #task: () => void;
  #request = 0;
  /** Frames that pass before the one that runs it. */
  #passing = 0;

  constructor(task: () => void) {
    this.#task = task;
  }

  request(): void {
    this.#ask(0);
  }

  /** Asks for it in the frame after the next, unless it is asked for sooner: what goes on and on runs in every second frame. */
  requestLater(): void {
    this.#ask(1);
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

  #ask(passing: number): void {
    this.#passing = this.#request === 0 ? passing : Math.min(this.#passing, passing);
    if (this.#request === 0) {
      this.#waitAFrame();
    }
  }

  #waitAFrame(): void {
    this.#request = requestAnimationFrame(() => {
      this.#request = 0;
      if (this.#passing > 0) {
        this.#passing--;
        this.#waitAFrame();
      } else {
        this.#task();
      }
    });
  }
}
