/**
 * A text layer's box round its words. A box that lies close about them goes on to do so when they change, the letters as
 * large as before; one that a user made otherwise is a frame, which stays, and the words find their place in it.
 */
import type { Projector, TextMeasure, Vec3 } from "../../engine/engine-api.ts";
import type { Align, TextLayer } from "../document/design.ts";
import { DESIGN_LIMITS } from "../document/design-limits.ts";

export type Room = Pick<TextMeasure, "width" | "height">;

/** Width by height that differ by less are the same. */
const SLACK = 2e-3;
const MOST_DEGREES = 360;
const WIDEST_LENS = 175;
const LEAST_LENS = 0.01;

/** Whether the box lies close about words that ask for that room. `texture`: width by height, for stamps on it. */
export function fitsClosely({ projector, fontSize }: TextLayer, room: Room, texture: number): boolean {
  const wanted = room.width / room.height;
  return Math.abs(aspectOf(projector, texture) / wanted - 1) < SLACK && Math.abs(fontSize * room.height - 1) < SLACK;
}

/** The font size and the box that lie close about words which asked for `before` and now ask for `after`. */
export function refitted(
  layer: Pick<TextLayer, "projector" | "align">,
  before: Room,
  after: Room,
): Pick<TextLayer, "projector" | "fontSize"> {
  const [wide, high] = [after.width / before.width, after.height / before.height];
  return { projector: grown(layer.projector, wide, high, layer.align), fontSize: 1 / after.height };
}

/** A box for words that ask for that room, its height as it is where they go round a cylinder no more than once. */
export function fitted(
  layer: Pick<TextLayer, "projector" | "align">,
  room: Room,
  texture: number,
): Pick<TextLayer, "projector" | "fontSize"> {
  const wanted = room.width / room.height;
  const projector = grown(layer.projector, wanted / aspectOf(layer.projector, texture), 1, layer.align);
  const fontSize = 1 / room.height;
  if (projector.kind !== "cylindrical") return { projector, fontSize };
  // Once round there is no more: what is longer is made as low as goes with that.
  return { projector: { ...projector, height: projector.height * (aspectOf(projector, texture) / wanted) }, fontSize };
}

/** Height of the em, in the unit of the box's height; degrees for a lens. */
export const emOf = ({ projector, fontSize }: Pick<TextLayer, "projector" | "fontSize">): number =>
  fontSize * heightOf(projector);

/** The projector with the em at that height; its box grows or shrinks as a whole. */
export function withEm(layer: TextLayer, em: number): Projector {
  // Degrees are no measure that a box grows by.
  if (layer.projector.kind === "perspective") return { ...layer.projector, fov: em / layer.fontSize };
  const factor = em / emOf(layer);
  return grown(layer.projector, factor, factor, layer.align);
}

/** The least and the largest em whose box, and where it is moved to, a design can have, and which goes round a cylinder once. */
export function emBounds(layer: TextLayer): { readonly min: number; readonly max: number } {
  const { projector, fontSize } = layer;
  if (projector.kind === "perspective") return { min: fontSize * LEAST_LENS, max: fontSize * WIDEST_LENS };
  const em = emOf(layer);
  const { lengthMin, lengthMax } = DESIGN_LIMITS;
  const isRound = projector.kind === "cylindrical";
  const sides = isRound ? [projector.height] : projector.size;
  const most = Math.min(lengthMax / 4 / Math.max(...sides), isRound ? MOST_DEGREES / projector.arc : Infinity);
  return { min: em * ((lengthMin * 2) / Math.min(...sides)), max: em * most };
}

function heightOf(projector: Projector): number {
  switch (projector.kind) {
    case "planar":
    case "uv":
      return projector.size[1];
    case "cylindrical":
      return projector.height;
    case "perspective":
      return projector.fov;
  }
}

/** Width by height of the picture as it lies on the surface. */
export function aspectOf(projector: Projector, texture: number): number {
  switch (projector.kind) {
    case "planar":
      return projector.size[0] / projector.size[1];
    case "uv":
      return (projector.size[0] / projector.size[1]) * texture;
    case "cylindrical":
      return (((projector.arc * Math.PI) / 180) * projector.radius) / projector.height;
    case "perspective":
      return projector.aspect;
  }
}

/** The side that lines are aligned to stays where it is; above and below the box grows alike. */
function grown(projector: Projector, wide: number, high: number, align: Align): Projector {
  switch (projector.kind) {
    case "planar": {
      const [width, height, depth] = projector.size;
      const side = align === "center" ? 0 : align === "left" ? 0.5 : -0.5;
      const along = side * width * (wide - 1);
      return {
        ...projector,
        position: moved(projector.position, projector.rotation, along),
        // A wider box on a rounded surface must reach further in, or the words would end before it does.
        size: [width * wide, height * high, depth * wide],
      };
    }
    case "uv":
      return { ...projector, size: [projector.size[0] * wide, projector.size[1] * high] };
    case "cylindrical":
      return { ...projector, arc: Math.min(MOST_DEGREES, projector.arc * wide), height: projector.height * high };
    case "perspective": {
      const half = Math.atan(Math.tan((projector.fov * Math.PI) / 360) * high);
      const fov = Math.min(WIDEST_LENS, (half * 360) / Math.PI);
      return { ...projector, fov, aspect: (projector.aspect * wide) / high };
    }
  }
}

/** Along the box's own X. */
function moved([px, py, pz]: Vec3, [x, y, z, w]: readonly [number, number, number, number], by: number): Vec3 {
  return [px + by * (1 - 2 * (y * y + z * z)), py + by * 2 * (x * y + w * z), pz + by * 2 * (x * z - w * y)];
}
