/** Places for new decals and copies: exactly on another one, none of the two would be seen as two. */

import type { Projector } from "../../engine/engine-api.ts";
import type { ModelViewer } from "../../viewer/viewer-api.ts";
import { type Design, flattenLayers, isPlaced } from "../document/index.ts";

/** From one to the next, of the model's diagonal. */
const STEP_SHARE = 0.04;
/** After so many the cascade has left the model, or goes in circles. */
const MOST_STEPS = 24;
/** The steps of all together: each is a search on the surface, a thousand take a fifth of a second. */
const MOST_SEARCHES = 1000;

/**
 * Gives for each of some projectors itself, or where one of them has the very place of a decal of the design, as many steps to
 * the right and down from there as bring them all to free ones. All go as far: what was arranged stays so, and copies do not
 * meet each other. Many in a dense design, which find no free places together, go one step.
 *
 * @param diagonal the model's, metres
 */
export function clearPlaces(
  design: Pick<Design, "layers">,
  projectors: readonly Projector[],
  diagonal: number,
  viewer: Pick<ModelViewer, "nudge">,
): <P extends Projector>(projector: P) => P {
  const step = STEP_SHARE * diagonal;
  // A stamp's place is a share of the texture, as the step is one of the model.
  const [flat, solid] = [new Places(STEP_SHARE / 4), new Places(step / 2)];
  const among = ({ kind }: Projector): Places => (kind === "uv" ? flat : solid);
  for (const layer of flattenLayers(design, { masks: false, strokes: false })) {
    if (isPlaced(layer)) among(layer.projector).add(placeOf(layer.projector));
  }
  const ways = new Map(
    projectors
      // What covers the whole texture, as pixel layers do, has that one place.
      .filter((projector) => projector.kind !== "uv" || Math.min(...projector.size) < 1)
      .map((projector) => [projector, new Way(projector, among(projector), (from) => viewer.nudge(from, step, -step))]),
  );
  const isCovered = (steps: number): boolean => [...ways.values()].some((way) => way.isCovered(steps));
  const most = Math.max(1, Math.min(MOST_STEPS, Math.floor(MOST_SEARCHES / ways.size)));
  let steps = 0;
  while (steps < most && isCovered(steps)) steps += 1;
  if (steps === most && ways.size > 1 && isCovered(steps)) steps = 1;
  return <P extends Projector>(projector: P) => (ways.get(projector)?.after(steps) ?? projector) as P;
}

/** Where a projector gets to. No further than it is asked for. */
class Way {
  readonly #stops: Projector[];
  readonly #places: Places;
  readonly #next: (from: Projector) => Projector;
  #ends = false;

  constructor(start: Projector, places: Places, next: (from: Projector) => Projector) {
    this.#stops = [start];
    this.#places = places;
    this.#next = next;
  }

  after(steps: number): Projector {
    while (!this.#ends && this.#stops.length <= steps) {
      const last = this.#stops.at(-1) as Projector;
      const next = this.#next(last);
      this.#ends = this.#places.areNear(placeOf(next), placeOf(last));
      if (!this.#ends) this.#stops.push(next);
    }
    return (this.#stops[steps] ?? this.#stops.at(-1)) as Projector;
  }

  /** Another decal lies there, and the way goes on. */
  isCovered(steps: number): boolean {
    const stop = this.after(steps);
    return this.#places.hasNear(placeOf(stop)) && this.after(steps + 1) !== stop;
  }
}

const placeOf = (projector: Projector): readonly number[] =>
  projector.kind === "uv" ? projector.center : projector.position;

/** By the slice of the first axis that they lie in, which is as wide as near is: of thousands few are looked at. */
class Places {
  readonly #reach: number;
  readonly #slices = new Map<number, (readonly number[])[]>();

  constructor(reach: number) {
    this.#reach = reach;
  }

  add(place: readonly number[]): void {
    const slice = this.#sliceOf(place);
    const present = this.#slices.get(slice);
    if (present) present.push(place);
    else this.#slices.set(slice, [place]);
  }

  hasNear(place: readonly number[]): boolean {
    const slice = this.#sliceOf(place);
    const around = [slice - 1, slice, slice + 1];
    return around.some((each) => this.#slices.get(each)?.some((other) => this.areNear(place, other)));
  }

  areNear(one: readonly number[], other: readonly number[]): boolean {
    return Math.hypot(...one.map((value, axis) => value - (other[axis] ?? 0))) < this.#reach;
  }

  #sliceOf([first = 0]: readonly number[]): number {
    return Math.floor(first / this.#reach);
  }
}
