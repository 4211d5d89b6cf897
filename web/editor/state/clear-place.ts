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
  const taken = flattenLayers(design, { masks: false, strokes: false }).flatMap((layer) =>
    layer.type === "decal" || layer.type === "text" ? [layer.projector] : [],
  );
  return <P extends Projector>(projector: P): P => {
    // What covers the whole texture, as pixel layers do, has that one place.
    if (projector.kind === "uv" && Math.min(...projector.size) >= 1) return projector;
    let free = projector;
    for (let steps = 0; steps < MOST_STEPS && taken.some((other) => liesOn(free, other, step)); steps += 1) {
      const next = viewer.nudge(free, step, -step) as P;
      if (liesOn(next, free, step)) break;
      free = next;
    }
    return free;
  };
}

/** A stamp's place is a share of the texture, as the step is one of the model. */
function liesOn(one: Projector, other: Projector, step: number): boolean {
  if (one.kind === "uv") return other.kind === "uv" && isNear(one.center, other.center, STEP_SHARE / 4);
  return other.kind !== "uv" && isNear(one.position, other.position, step / 2);
}

/** Asked for each of many copies about each of many layers: most are far off along the first axis already. */
function isNear(one: readonly number[], other: readonly number[], reach: number): boolean {
  let squares = 0;
  for (const [axis, value] of one.entries()) {
    squares += (value - (other[axis] ?? 0)) ** 2;
    if (squares >= reach ** 2) return false;
  }
  return true;
}
