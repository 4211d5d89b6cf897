/** A decal that is given another picture stays what it is: where it lies, how it looks, and its mask. */
import type { Projector } from "../../engine/engine-api.ts";

/**
 * The projector for a picture whose width by height is `ratio` times the one before it, as large as its box lets it be: one of
 * other proportions is not drawn out, and goes beyond no side.
 */
export function fittedPicture(projector: Projector, ratio: number): Projector {
  const [wide, high] = ratio > 1 ? [1, 1 / ratio] : [ratio, 1];
  switch (projector.kind) {
    case "planar": {
      const [width, height, depth] = projector.size;
      return { ...projector, size: [width * wide, height * high, depth] };
    }
    case "uv": {
      const [width, height] = projector.size;
      return { ...projector, size: [width * wide, height * high] };
    }
    case "cylindrical":
      return { ...projector, arc: projector.arc * wide, height: projector.height * high };
    case "perspective": {
      const fov = (Math.atan(Math.tan((projector.fov * Math.PI) / 360) * high) * 360) / Math.PI;
      return { ...projector, fov, aspect: projector.aspect * ratio };
    }
  }
}
