/**
 * From a pointer's samples to the places of the surface that a brush passes: steadied on the screen, and looked up on the
 * model between the samples, so that a quick line follows the surface instead of cutting through it.
 */
import type { SurfaceHit, ToolSample, ToolView } from "../../viewer/viewer-api.ts";

/** A place that the brush passes. */
export interface PassedPlace {
  readonly hit: SurfaceHit;
  readonly pressure: number;
}

/** Null where the path breaks: the pointer left the model, or jumped to another part of it. */
export type PathStep = PassedPlace | null;

export interface PointerPathOptions {
  /** Pixels of slack between the pointer and the brush that it pulls. */
  readonly rope: number;
  /** Pixels between two looks at the model; default 5. */
  readonly look?: number;
  /** Whether the line between two neighbouring places runs over the surface. */
  readonly joined: (a: SurfaceHit, b: SurfaceHit) => boolean;
}

interface ScreenPoint {
  readonly x: number;
  readonly y: number;
}

const LOOK = 5;
/** More looks for one sample are a pointer that jumped across a large screen. */
const MOST_LOOKS = 400;

/** The rope of a stabiliser set from 0 to 100, pixels. */
export const ropeOf = (stabiliser: number): number => stabiliser * 0.5;

export class PointerPath {
  readonly #options: PointerPathOptions;
  readonly #view: ToolView;
  #tip: ScreenPoint;
  #pressure: number;
  #last: SurfaceHit | null = null;

  /** `from`: where the path begins; `first` gives its step. */
  constructor(from: ToolSample, options: PointerPathOptions) {
    this.#options = options;
    this.#view = from.view;
    this.#tip = from.at;
    this.#pressure = from.pressure;
  }

  /** Where the brush is, behind the pointer. */
  get tip(): ScreenPoint {
    return this.#tip;
  }

  /** The newest place on the surface; null while the brush is beside it. */
  get last(): SurfaceHit | null {
    return this.#last;
  }

  first(sample: ToolSample): PathStep[] {
    return this.#look(sample.hit, sample.pressure);
  }

  /** The brush is pulled by the rope: it moves once that is taut, straight towards the pointer. */
  add(sample: ToolSample): PathStep[] {
    const { at } = sample;
    const length = Math.hypot(at.x - this.#tip.x, at.y - this.#tip.y);
    const { rope } = this.#options;
    if (length <= rope || length === 0) return [];
    const share = (length - rope) / length;
    return this.#walkTo(
      { x: this.#tip.x + (at.x - this.#tip.x) * share, y: this.#tip.y + (at.y - this.#tip.y) * share },
      sample.pressure,
    );
  }

  /** The pointer was released: the brush catches up with it. */
  finish(sample: ToolSample): PathStep[] {
    // A pen that lifts has no pressure left; the line keeps what it had.
    return this.#walkTo(sample.at, this.#pressure);
  }

  /** A straight line on the screen from a place of before to where the path begins. */
  lineFrom(place: SurfaceHit, sample: ToolSample): PathStep[] {
    const from = this.#view.placeOf(place);
    if (from === null) return this.first(sample);
    this.#tip = from;
    this.#last = place;
    return this.#walkTo(sample.at, sample.pressure);
  }

  #walkTo(to: ScreenPoint, pressure: number): PathStep[] {
    const from = this.#tip;
    const before = this.#pressure;
    this.#tip = to;
    this.#pressure = pressure;
    const looks = Math.min(
      MOST_LOOKS,
      Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / (this.#options.look ?? LOOK)),
    );
    return Array.from({ length: looks }, (_, look) => (look + 1) / looks).flatMap((share) => {
      const at = { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share };
      return this.#look(this.#view.hitAt(at), before + (pressure - before) * share);
    });
  }

  #look(hit: SurfaceHit | null, pressure: number): PathStep[] {
    const before = this.#last;
    this.#last = hit;
    if (hit === null) return before === null ? [] : [null];
    const place = { hit, pressure };
    return before !== null && !this.#options.joined(before, hit) ? [null, place] : [place];
  }
}
