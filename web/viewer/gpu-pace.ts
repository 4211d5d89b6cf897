/** How fast the GPU works off what it was given. */

/** Least time between two looks at the fence, milliseconds. */
const POLL = 6;
/** The longer the work takes, the rarer the looks, as a share of the time so far: nobody needs to know it more exactly. */
const LOOK_SHARE = 0.25;
/** Share of the time that the work before took, before which nobody looks: each look costs the page a task. */
const UNSEEN_SHARE = 0.75;
/** A slow piece of work says little about the next: after this, milliseconds, looking begins anyway. */
const LONGEST_UNSEEN = 60;

/** Learns by fences when the GPU is done with what it was given, without ever waiting for it. */
export class GpuPace {
  readonly #gl: WebGL2RenderingContext;
  readonly #note: ((milliseconds: number) => void) | undefined;
  #fence: WebGLSync | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #waiting: (() => void)[] = [];
  /** What the newest work took, milliseconds. */
  #expected = 0;

  /** @param note told what each fenced piece of work took, milliseconds */
  constructor(gl: WebGL2RenderingContext, note?: (milliseconds: number) => void) {
    this.#gl = gl;
    this.#note = note;
  }

  /**
   * Sets a fence behind the commands given so far, unless one is under way.
   *
   * @param flush whether to send the commands off, too; a frame's own go off when it is shown
   */
  mark({ flush }: { readonly flush: boolean }): void {
    if (this.#fence === null) {
      const fence = this.#gl.fenceSync(this.#gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      if (flush) {
        this.#gl.flush();
      }
      this.#fence = fence;
      this.#poll(performance.now(), Math.min(Math.max(this.#expected * UNSEEN_SHARE, POLL), LONGEST_UNSEEN));
    }
  }

  /** Runs a task once the fence under way is passed; at once where there is none. */
  whenDone(task: () => void): void {
    if (this.#fence === null) {
      task();
    } else {
      this.#waiting.push(task);
    }
  }

  dispose(): void {
    clearTimeout(this.#timer);
    this.#gl.deleteSync(this.#fence);
    this.#fence = null;
    this.#waiting = [];
  }

  #poll(begin: number, wait: number): void {
    this.#timer = setTimeout(() => {
      const gl = this.#gl;
      // Null where the context is lost, or was since the fence was set: such a fence is never passed.
      const status = this.#fence && gl.getSyncParameter(this.#fence, gl.SYNC_STATUS);
      if (status === gl.UNSIGNALED) {
        this.#poll(begin, Math.max(POLL, LOOK_SHARE * (performance.now() - begin)));
        return;
      }
      if (status) {
        gl.deleteSync(this.#fence);
        this.#expected = performance.now() - begin;
        this.#note?.(this.#expected);
      }
      this.#done();
    }, wait);
  }

  #done(): void {
    this.#fence = null;
    const tasks = this.#waiting;
    this.#waiting = [];
    for (const task of tasks) {
      task();
    }
  }
}
