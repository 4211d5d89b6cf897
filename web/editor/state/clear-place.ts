/** Places for new decals and copies: exactly on another one, none of the two would be seen as two. */
import type { Projector } from "../../engine/engine-api.ts";
import type { ModelViewer } from "../../viewer/viewer-api.ts";
import { type Design, flattenLayers } from "../document/index.ts";

/** From one to the next, of the model's diagonal. */
const STEP_SHARE = 0.04;
/** After so many the cascade has left the model, or goes in circles. */
const MOST_STEPS = 24;

/**
 * Gives for a projector itself, or where another decal of the design has its very place, as many steps to the right and down
 * from there as bring it to one that is free.
 *
 * @param diagonal the model's, metres
 */
export function clearPlaces(
  design: Pick<Design, "layers">,
  diagonal: number,
  viewer: Pick<ModelViewer, "nudge">,
): <P extends Projector>(projector: P) => P {
  const step = STEP_SHARE * diagonal;
  // A stamp's place is a share of the texture, as the step is one of the model.
  const [flat, solid] = [new Places(STEP_SHARE / 4), new Places(step / 2)];
  const among = ({ kind }: Projector): Places => (kind === "uv" ? flat : solid);
  for (const layer of flattenLayers(design, { masks: false, strokes: false })) {
    if (layer.type === "decal" || layer.type === "text") among(layer.projector).add(placeOf(layer.projector));
  }
  return <P extends Projector>(projector: P): P => {
    // What covers the whole texture, as pixel layers do, has that one place.
    if (projector.kind === "uv" && Math.min(...projector.size) >= 1) return projector;
    const places = among(projector);
    let free = projector;
    for (let steps = 0; steps < MOST_STEPS && places.hasNear(placeOf(free)); steps += 1) {
      const next = viewer.nudge(free, step, -step) as P;
      if (places.areNear(placeOf(next), placeOf(free))) break;
      free = next;
    }
    return free;
  };
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
