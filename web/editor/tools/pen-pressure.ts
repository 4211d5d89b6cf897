/**
 * Pens whose drivers report pressure 0 for as long as they touch: painted with that, nothing would be seen of their strokes. They
 * paint as a mouse does. A pen that has pressure begins a stroke with none or next to none too, so that a stroke's first samples
 * without any are held back until one shows which of the two it is.
 */
import type { ToolSample } from "../../viewer/viewer-api.ts";

/** So many samples in contact without any pressure, a quarter of a second of a slow pen, are none that still comes. */
const MOST_HELD = 32;
/** A pen's lightest touch has as few, and says nothing of the strokes after it. */
const LEAST_TOLD = 4;

export class PenPressure {
  /** Whether pens have pressure here; unknown until a stroke has shown it. */
  #has: boolean | null = null;
  #held: ToolSample[] = [];

  /** A stroke begins. */
  begin(): void {
    this.#held = [];
  }

  /** What is to be painted of a stroke's new samples and of those that were held back. */
  take(samples: readonly ToolSample[]): readonly ToolSample[] {
    // Mice and fingers have 1, by which nothing is known of a pen.
    if (samples.some(({ pressure }) => pressure > 0 && pressure < 1)) this.#has = true;
    const isBare = samples.every(({ pressure }) => pressure === 0);
    if (this.#has === null && isBare) {
      this.#held.push(...samples);
      return this.#held.length < MOST_HELD ? [] : this.end();
    }
    const taken = [...this.#held.splice(0), ...samples];
    return this.#has === false ? taken.map(full) : taken;
  }

  /** The stroke ends: what is held back still, which never had any pressure. */
  end(): readonly ToolSample[] {
    const held = this.#held.splice(0);
    if (held.length >= LEAST_TOLD) this.#has = false;
    return held.map(full);
  }
}

const full = (sample: ToolSample): ToolSample => (sample.pressure === 0 ? { ...sample, pressure: 1 } : sample);
