/** What the keyboard's steps make of a projector of any kind: turned and scaled, its picture's middle kept in place. */
import type { Projector } from "../../engine/engine-api.ts";
import { spun, wrapDegrees } from "./rotation.ts";

/** A camera wider than this shows next to nothing but its rim. */
const WIDEST_FOV = 175;
const FULL_ARC = 360;

/** The picture turned counter-clockwise as its viewer sees it, degrees. */
export function spunProjector<P extends Projector>(projector: P, degrees: number): P {
  if (projector.kind === "uv") return { ...projector, angle: wrapDegrees(projector.angle - degrees) };
  return { ...projector, rotation: spun(projector.rotation, degrees) };
}

/** The picture made larger by a factor, its proportions kept as far as its kind lets it. */
export function scaledProjector<P extends Projector>(projector: P, factor: number): P;
export function scaledProjector(projector: Projector, factor: number): Projector {
  switch (projector.kind) {
    case "planar": {
      const [x, y, z] = projector.size;
      return { ...projector, size: [x * factor, y * factor, z] };
    }
    case "perspective": {
      const slope = Math.tan((projector.fov * Math.PI) / 360) * factor;
      return { ...projector, fov: Math.min(WIDEST_FOV, (Math.atan(slope) * 360) / Math.PI) };
    }
    case "cylindrical":
      return {
        ...projector,
        height: projector.height * factor,
        arc: Math.min(FULL_ARC, projector.arc * factor),
      };
    case "uv":
      return { ...projector, size: [projector.size[0] * factor, projector.size[1] * factor] };
  }
}
