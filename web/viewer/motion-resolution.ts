/**
 * Fewer pixels while the picture moves, where the GPU is too slow for all of them; all of them when it rests. What a
 * frame costs is asked of the GPU itself (a fence), for the time between frames also depends on the engine's pace.
 */

/** Shares of the full resolution along a side, from best to cheapest. */
const STEPS = [1, 0.75, 0.55] as const;

/** A frame that takes longer than this, milliseconds, is not felt as movement. */
const SLOW = 45;
/** Frames faster than this leave room for a step up. */
const FAST = 12;
const SLOW_FRAMES_TO_STEP_DOWN = 2;
const FAST_FRAMES_TO_STEP_UP = 14;
/** Asking costs the page's thread tasks: unless a step down may be near, one frame in so many is asked for. */
const FRAMES_A_QUESTION = 3;

export class MotionResolution {
  #step = 0;
  #slow = 0;
  #fast = 0;
  #newest = Number.POSITIVE_INFINITY;

  /** Whether it wants to be told what this frame costs; frames are counted. */
  asksFor(frame: number): boolean {
    const mayStepDown = this.#newest > SLOW / 2 && this.#step < STEPS.length - 1;
    return mayStepDown || frame % FRAMES_A_QUESTION === 0;
  }

  /** Share of the full resolution to draw moving pictures with, along a side. */
  get scale(): number {
    return STEPS[this.#step] as number;
  }

  /** Takes note of what a frame cost, in milliseconds. */
  note(milliseconds: number): void {
    this.#newest = milliseconds;
    this.#slow = milliseconds > SLOW ? this.#slow + 1 : 0;
    this.#fast = milliseconds < FAST ? this.#fast + 1 : 0;
    if (this.#slow >= SLOW_FRAMES_TO_STEP_DOWN && this.#step < STEPS.length - 1) {
      this.#step += 1;
      this.#slow = 0;
    } else if (this.#fast >= FAST_FRAMES_TO_STEP_UP && this.#step > 0) {
      this.#step -= 1;
      this.#fast = 0;
    }
  }
}
