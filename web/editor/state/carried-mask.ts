/** A mask that goes with its layer: what is in it keeps its place on the layer's picture when that is moved, turned and sized. */
import type { CylindricalProjector, Projector, Quaternion, UvProjector, Vec3 } from "../../engine/engine-api.ts";
import { sameItems } from "../../engine/same-items.ts";
import { uvOfStamp } from "../../viewer/stamp-drag.ts";
import type { Gradient, Mask, MaskLayer } from "../document/index.ts";
import { inverse, minus, plus, turned } from "../document/rigid-motion.ts";
import { roundedDab } from "../tools/dab-chain.ts";
import { type NearSurface, times } from "./carried-projector.ts";
import type { PlacedLayer } from "./decal-reach.ts";
import { stampWith } from "./stamps-together.ts";

type Posed = Exclude<Projector, UvProjector>;

/** What a change of a picture's projector does to what is there. */
interface Motion {
  /** Where a place of the picture goes, and how the picture lies there before and after. */
  at(place: Vec3): { readonly place: Vec3; readonly from: Quaternion; readonly to: Quaternion };
  /** How much wider and higher the picture is. */
  readonly growth: readonly [number, number];
}

/**
 * The mask of a layer that is put where another projector has it; itself where it is not linked, or where nothing in it can go
 * along: fills of one colour and of parts, what lies in the texture under what is thrown at the model, and the other way round.
 */
export function carriedMask(
  { mask, projector: start }: Pick<PlacedLayer, "mask" | "projector">,
  now: Projector,
  near: NearSurface,
): Mask | null {
  // What came back to where it was must not be another for the digits that carrying costs.
  if (mask === null || !mask.linked || JSON.stringify(start) === JSON.stringify(now)) return mask;
  const carry = carrier(start, now, near);
  if (carry === null) return mask;
  const layers = mask.layers.map((layer) => carriedLayer(layer, carry));
  return sameItems(layers, mask.layers) ? mask : { ...mask, layers };
}

/** Whether all that is in a layer's mask goes where the layer goes. */
export const maskGoesAlong = ({ mask, projector }: Pick<PlacedLayer, "mask" | "projector">): boolean =>
  mask === null ||
  (mask.linked &&
    mask.layers.every((layer) => {
      if (layer.type === "fill") return layer.parts === null;
      const projectors: readonly Projector[] = layer.type === "stroke" ? layer.dabs : [layer.projector];
      return projectors.every(({ kind }) => (kind === "uv") === (projector.kind === "uv"));
    }));

interface Carrier {
  projector<P extends Projector>(other: P): P;
  gradient(gradient: Gradient): Gradient;
}

function carriedLayer(layer: MaskLayer, carry: Carrier): MaskLayer {
  if (layer.type === "fill") {
    return layer.gradient === null ? layer : withChanged(layer, "gradient", carry.gradient(layer.gradient));
  }
  if (layer.type !== "stroke") return withChanged(layer, "projector", carry.projector(layer.projector));
  const dabs = layer.dabs.map((dab) => {
    const carried = carry.projector(dab);
    return carried === dab ? dab : roundedDab(carried);
  });
  return sameItems(dabs, layer.dabs) ? layer : { ...layer, dabs };
}

const withChanged = <L, K extends keyof L>(layer: L, key: K, value: L[K]): L =>
  layer[key] === value ? layer : { ...layer, [key]: value };

function carrier(start: Projector, now: Projector, near: NearSurface): Carrier | null {
  if (start.kind === "uv" || now.kind === "uv") {
    return start.kind === "uv" && now.kind === "uv" ? carrierInTexture(start, now) : null;
  }
  const motion = motionOf(start, now);
  return (
    motion && {
      projector: (other) => (other.kind === "uv" ? other : { ...other, ...carriedPosed(other, motion, near) }),
      gradient: (gradient) => carriedGradient(gradient, motion),
    }
  );
}

/** In the texture gradients have no place. */
function carrierInTexture(start: UvProjector, now: UvProjector): Carrier {
  const upright: UvProjector = { ...start, angle: 0 };
  const carried = (other: UvProjector): UvProjector => {
    const [right, down] = [other.center[0] - start.center[0], other.center[1] - start.center[1]];
    const center = uvOfStamp({ ...start, size: [1, 1], angle: -start.angle }, right, -down);
    return stampWith(upright, now, { ...other, center, angle: other.angle - start.angle });
  };
  return {
    projector: (other) => (other.kind === "uv" ? { ...other, ...carried(other) } : other),
    gradient: (gradient) => gradient,
  };
}

/** Null where it became one of another kind, and its picture stays where it is as near as that goes. */
function motionOf(start: Posed, now: Posed): Motion | null {
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

function carriedPosed(other: Posed, { at, growth }: Motion, near: NearSurface): Partial<Posed> {
  const { place, from, to } = at(other.position);
  const own = times(inverse(from), other.rotation);
  const rotation = times(to, own);
  const position = settled(other, { position: place, rotation }, near);
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

/** As far over the surface as before, along its own direction: the surface need not go on as it did. */
function settled(before: Pick<Posed, "position" | "rotation">, after: typeof before, near: NearSurface): Vec3 {
  const [was, is] = [heightOf(before, near), heightOf(after, near)];
  return was === null || is === null ? after.position : plus(after.position, turned(after.rotation, [0, 0, was - is]));
}

function heightOf({ position, rotation }: Pick<Posed, "position" | "rotation">, near: NearSurface): number | null {
  const foot = near(position);
  return foot && turned(inverse(rotation), minus(position, foot.position))[2];
}

function carriedGradient(gradient: Gradient, { at, growth }: Motion): Gradient {
  if (gradient.kind === "linear") {
    return { ...gradient, from: at(gradient.from).place, to: at(gradient.to).place };
  }
  return { ...gradient, center: at(gradient.center).place, radius: gradient.radius * Math.sqrt(growth[0] * growth[1]) };
}
