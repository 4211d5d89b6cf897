/** How far places lie from where a projector throws its picture: what masks several pictures goes with the nearest of them. */
import type { Projector, UvProjector, Vec3 } from "../../engine/engine-api.ts";
import { uvOfStamp } from "../../viewer/stamp-drag.ts";
import { inverse, minus, turned } from "../document/rigid-motion.ts";

export type Posed = Exclude<Projector, UvProjector>;

/** In metres, of stamps in parts of the texture. */
export interface Distance {
  /** From the picture's own room; 0 in it. */
  readonly outside: number;
  readonly fromMiddle: number;
}

export const isNearer = (one: Distance, other: Distance): boolean =>
  one.outside === other.outside ? one.fromMiddle < other.fromMiddle : one.outside < other.outside;

export function distanceFrom(picture: Posed, place: Vec3): Distance {
  const [x, y, z] = turned(inverse(picture.rotation), minus(place, picture.position));
  if (picture.kind === "planar") {
    const [width, height, depth] = picture.size;
    return distanceOf([x, width / 2], [y, height / 2], [z, depth / 2]);
  }
  if (picture.kind === "cylindrical") {
    const { radius, arc, height, depth } = picture;
    const halfway = (radius * arc * Math.PI) / 360;
    return distanceOf([radius * Math.atan2(x, z), halfway], [y, height / 2], [Math.hypot(x, z) - radius, depth]);
  }
  const { fov, aspect, near, far } = picture;
  const seen = Math.max(0, -z) * Math.tan((fov * Math.PI) / 360);
  return distanceOf([x, seen * aspect], [y, seen], [-z - (near + far) / 2, (far - near) / 2]);
}

export function distanceFromStamp(stamp: UvProjector, uv: UvProjector["center"]): Distance {
  const [right, down] = inStamp(stamp, uv);
  return distanceOf([right, stamp.size[0] / 2], [down, stamp.size[1] / 2]);
}

/** From a stamp's middle along its own sides: to the right, and down; parts of the texture. */
export const inStamp = ({ center, angle }: UvProjector, [u, v]: UvProjector["center"]): UvProjector["center"] =>
  uvOfStamp({ kind: "uv", center: [0, 0], size: [1, 1], angle: -angle }, u - center[0], center[1] - v);

/** @param ways from the middle along each axis, and how far the picture reaches there */
function distanceOf(...ways: readonly (readonly [way: number, reach: number])[]): Distance {
  return {
    outside: Math.hypot(...ways.map(([way, reach]) => Math.max(0, Math.abs(way) - reach))),
    fromMiddle: Math.hypot(...ways.map(([way]) => way)),
  };
}
