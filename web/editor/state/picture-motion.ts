/** What a change of a picture's projector does to what is there: it keeps its place on the picture. */
import type { CylindricalProjector, Quaternion, Vec3 } from "../../engine/engine-api.ts";
import { inverse, minus, plus, turned } from "../document/rigid-motion.ts";
import { type NearSurface, times } from "./carried-projector.ts";
import type { Posed } from "./picture-place.ts";

export interface Motion {
  /** Where a place of the picture goes, and how the picture lies there before and after. */
  at(place: Vec3): { readonly place: Vec3; readonly from: Quaternion; readonly to: Quaternion };
  /** How much wider and higher the picture is. */
  readonly growth: readonly [number, number];
}

/** Null where it became one of another kind, and its picture stays where it is as near as that goes. */
export function motionOf(start: Posed, now: Posed): Motion | null {
  if (start.kind === "cylindrical" && now.kind === "cylindrical") return motionRound(start, now);
  if (start.kind === "cylindrical" || start.kind !== now.kind) return null;
  const [before, after] = [sidesOf(start), sidesOf(now)];
  const growth = [after[0] / before[0], after[1] / before[1]] as const;
  const toPicture = inverse(start.rotation);
  return {
    growth,
    at: (place) => {
      const [x, y, z] = turned(toPicture, minus(place, start.position));
      const grown: Vec3 = [x * growth[0], y * growth[1], z];
      return { place: plus(now.position, turned(now.rotation, grown)), from: start.rotation, to: now.rotation };
    },
  };
}

/** In whatever unit. */
function sidesOf(projector: Exclude<Posed, CylindricalProjector>): readonly [number, number] {
  if (projector.kind === "planar") return [projector.size[0], projector.size[1]];
  const slope = Math.tan((projector.fov * Math.PI) / 360);
  return [slope * projector.aspect, slope];
}

/** By the angle round the axis, along it, and out from it. */
function motionRound(start: CylindricalProjector, now: CylindricalProjector): Motion {
  const wider = now.arc / start.arc;
  const further = now.radius / start.radius;
  const growth = [wider * further, now.height / start.height] as const;
  const toLabel = inverse(start.rotation);
  return {
    growth,
    at: (place) => {
      const [x, y, z] = turned(toLabel, minus(place, start.position));
      const angle = Math.atan2(x, z);
      const far = Math.hypot(x, z) * further;
      const goal = angle * wider;
      const grown: Vec3 = [far * Math.sin(goal), y * growth[1], far * Math.cos(goal)];
      return {
        place: plus(now.position, turned(now.rotation, grown)),
        from: times(start.rotation, aboutAxis(angle)),
        to: times(now.rotation, aboutAxis(goal)),
      };
    },
  };
}

const aboutAxis = (angle: number): Quaternion => [0, Math.sin(angle / 2), 0, Math.cos(angle / 2)];

/** What is on a picture, where that is put elsewhere; raised by `lift` metres along its own direction. */
export function carriedPosed(other: Posed, { at, growth }: Motion, lift: number): Partial<Posed> {
  const { place, from, to } = at(other.position);
  const own = times(inverse(from), other.rotation);
  const rotation = times(to, own);
  const position = plus(place, turned(rotation, [0, 0, lift]));
  if (other.kind !== "planar") return { position, rotation };
  const [width, height, depth] = other.size;
  const factor = (axis: Vec3): number => {
    const [x, y, z] = turned(own, axis);
    // As powers, so that stretching can be undone; a reach grows by the mean of both.
    return growth[0] ** (x * x + (z * z) / 2) * growth[1] ** (y * y + (z * z) / 2);
  };
  const size: Vec3 = [width * factor([1, 0, 0]), height * factor([0, 1, 0]), depth * factor([0, 0, 1])];
  return { position, rotation, size };
}

/** What brings it as far over the surface as before: that need not go on as it did. 0 where there is none. */
export function liftOf(other: Posed, { at }: Motion, near: NearSurface): number {
  const { place, from, to } = at(other.position);
  const rotation = times(to, times(inverse(from), other.rotation));
  const [was, is] = [heightOf(other, near), heightOf({ position: place, rotation }, near)];
  return was === null || is === null ? 0 : was - is;
}

function heightOf({ position, rotation }: Pick<Posed, "position" | "rotation">, near: NearSurface): number | null {
  const foot = near(position);
  return foot && turned(inverse(rotation), minus(position, foot.position))[2];
}
