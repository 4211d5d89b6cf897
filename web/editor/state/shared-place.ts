/**
 * Where parts of a model share texels one of them owns them (spec.md, 2), and a decal paints a texel from where its owner lies: on
 * another part it shows nowhere.
 */
import type { PlanarProjector, Vec3 } from "../../engine/engine-api.ts";
import { inverse, minus, plus, turned } from "../document/rigid-motion.ts";
import type { MaskSurface } from "./remembered-surface.ts";

/** Places along each side of the box. */
const PLACES = 5;

/** Whether the surface in a decal's box owns none of the texels that it shows: all that is there is painted from elsewhere. */
export function ownsNoTexel(surface: MaskSurface, projector: PlanarProjector): boolean {
  const { position, rotation, size } = projector;
  const isInside = (place: Vec3): boolean =>
    turned(inverse(rotation), minus(place, position)).every(
      (part, axis) => 2 * Math.abs(part) <= (size[axis] as number),
    );
  let met = false;
  for (let place = 0; place < PLACES * PLACES; place++) {
    const [x, y] = [place % PLACES, Math.floor(place / PLACES)].map((step) => step / (PLACES - 1) - 0.5);
    const foot = surface.near(plus(position, turned(rotation, [(x ?? 0) * size[0], (y ?? 0) * size[1], 0])));
    if (foot === null || !isInside(foot.position)) continue;
    const owner = surface.atUv(foot.material, foot.uv);
    if (owner === null || isInside(owner.position)) return false;
    met = true;
  }
  return met;
}
