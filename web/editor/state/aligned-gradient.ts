/** Gradients that are laid over the whole model. */

import type { Vec3 } from "../../engine/engine-api.ts";
import { type DesignLayer, type Gradient, type GradientStop, isPlaced } from "../document/index.ts";
import type { OpenModel } from "./design-state.ts";
import { stopsOfGreys } from "./mask-edits.ts";

export type ModelAxis = "x" | "y" | "z";

const AXES = { x: 0, y: 1, z: 2 } as const;
const FIRST_STOPS: readonly GradientStop[] = [
  { offset: 0, color: "#2b3a67" },
  { offset: 1, color: "#f4a261" },
];

/** From hidden to shown, in a mask. */
const FADING_GREYS: readonly GradientStop[] = [
  { offset: 0, color: "#000000" },
  { offset: 1, color: "#ffffff" },
];

/** Linear, along an axis of the model from end to end, in the middle of the others. */
export function alignedGradient(
  model: OpenModel | null,
  axis: ModelAxis,
  stops: readonly GradientStop[] = FIRST_STOPS,
): Extract<Gradient, { kind: "linear" }> {
  const { low, high, middle } = boxOf(model);
  const at = (value: number): Vec3 => {
    const [x, y, z] = middle;
    if (axis === "x") return [value, y, z];
    return axis === "y" ? [x, value, z] : [x, y, value];
  };
  const index = AXES[axis];
  return { kind: "linear", from: at(low[index]), to: at(high[index]), stops };
}

/** Radial, from the model's middle as far as its longest side reaches: a circle that its view shows whole. */
export function roundGradient(
  model: OpenModel | null,
  stops: readonly GradientStop[] = FIRST_STOPS,
): Extract<Gradient, { kind: "radial" }> {
  const { low, high, middle } = boxOf(model);
  const radius = Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2;
  return { kind: "radial", center: middle, radius, stops };
}

/** Of a decal's height: where its fading ends, short of the handles at its edges. */
const FADED = 0.8;

/**
 * What a mask begins with that hides a layer at its foot and shows it at its top: those of a decal's box, of other layers the
 * model's.
 */
export function fadingGradient(model: OpenModel | null, layer: DesignLayer): Extract<Gradient, { kind: "linear" }> {
  const whole = alignedGradient(model, "y", stopsOfGreys(FADING_GREYS, layer.mask ?? { invert: false }));
  if (!isPlaced(layer) || layer.projector.kind !== "planar") return whole;
  const { position, rotation, size } = layer.projector;
  const [x, y, z, w] = rotation;
  const up = [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)] as const;
  const at = (share: number): Vec3 => {
    const [a, b, c] = position.map((part, axis) =>
      Number((part + (up[axis as 0 | 1 | 2] * size[1] * share) / 2).toPrecision(7)),
    ) as [number, number, number];
    return [a, b, c];
  };
  return { ...whole, from: at(-FADED), to: at(FADED) };
}

/** A model that is flat along an axis still has two ends there: a gradient needs them apart. */
function boxOf(model: OpenModel | null): { low: Vec3; high: Vec3; middle: Vec3 } {
  const low: Vec3 = model?.info.boundsMin ?? [-0.5, -0.5, -0.5];
  const max: Vec3 = model?.info.boundsMax ?? [0.5, 0.5, 0.5];
  const end = (axis: 0 | 1 | 2): number => (max[axis] > low[axis] ? max[axis] : low[axis] + 1);
  const high: Vec3 = [end(0), end(1), end(2)];
  const middle: Vec3 = [(low[0] + max[0]) / 2, (low[1] + max[1]) / 2, (low[2] + max[2]) / 2];
  return { low, high, middle };
}
