import type { Projector } from "../../engine/engine-api.ts";
import { boundedLength } from "../document/bounded-length.ts";

/** Whether a design may have a projector's lengths: with a smaller or a larger one it could not be read again. */
export const hasFittingLengths = (projector: Projector): boolean =>
  lengthsOf(projector).every((length) => boundedLength(length) === length);

function lengthsOf(projector: Projector): readonly number[] {
  switch (projector.kind) {
    case "planar":
    case "uv":
      return projector.size;
    case "perspective":
      return [projector.near, projector.far, projector.aspect];
    case "cylindrical":
      return [projector.radius, projector.height, projector.depth];
  }
}
