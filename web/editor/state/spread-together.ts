/**
 * Several pictures spread evenly between the two that lie furthest apart: the gap from each to the next is the same, or where there
 * is less room than they fill, the way from middle to middle.
 */
import type { Projector, Vec3 } from "../../engine/engine-api.ts";
import { stampBounds } from "../../viewer/stamp-drag.ts";
import type { ModelViewer } from "../../viewer/viewer-api.ts";
import { dot } from "../document/axes.ts";
import type { PlacedLayer } from "../document/index.ts";
import { plus, turned } from "../document/rigid-motion.ts";
import { sharesTexture } from "./aligned-together.ts";
import { isStamp } from "./stamps-together.ts";

export const SPREADS = ["across", "down"] as const;
export type SpreadOfLayers = (typeof SPREADS)[number];

/** Of the way from end to end and its own half: as near to its place as a picture counts as lying there. */
const IN_PLACE = 1e-6;

/** Where a picture lies along the way that they are spread over, and how far it reaches to either side. */
interface Extent {
  readonly middle: number;
  readonly half: number;
}

interface Member extends Extent {
  readonly id: string;
  /** The picture with another middle along the way. */
  readonly move: (middle: number) => Projector;
}

/**
 * Projectors of layers, those that lie as `first` does spread along its right ("across") or its top ("down"): boxes slide along
 * the surface, measured straight, as seen from in front of the first; stamps in the texture that they share. The two ends stay, as
 * do all that cannot be spread with it, and of fewer than three all.
 */
export function spreadTogether(
  layers: readonly PlacedLayer[],
  first: PlacedLayer,
  spread: SpreadOfLayers,
  viewer: Pick<ModelViewer, "centred">,
): readonly Projector[] {
  const moved = movedEvenly(
    first.projector.kind === "planar"
      ? boxesAlong(layers, turned(first.projector.rotation, spread === "across" ? [1, 0, 0] : [0, 1, 0]), viewer)
      : stampsAlong(layers, first, spread === "across" ? 0 : 1),
  );
  return layers.map(({ id, projector }) => moved.get(id) ?? projector);
}

/** Whether there are three that can be spread. */
export function canSpread(layers: readonly PlacedLayer[]): boolean {
  const boxes = layers.filter(({ projector }) => projector.kind === "planar");
  return boxes.length > 2 || layers.some((first) => stampsAlong(layers, first, 0).length > 2);
}

/** @param normal the way, unit, model space */
function boxesAlong(layers: readonly PlacedLayer[], normal: Vec3, viewer: Pick<ModelViewer, "centred">): Member[] {
  return layers.flatMap(({ id, projector }) => {
    if (projector.kind !== "planar") return [];
    const { position, rotation, size } = projector;
    const reach = (own: Vec3): number => Math.abs(dot(normal, turned(rotation, own)));
    const middle = dot(normal, position);
    const move = (wanted: number): Projector => {
      const away = wanted - middle;
      const point = plus(position, [normal[0] * away, normal[1] * away, normal[2] * away]);
      return viewer.centred(projector, [{ point, normal }]);
    };
    return [{ id, middle, half: (reach([1, 0, 0]) * size[0] + reach([0, 1, 0]) * size[1]) / 2, move }];
  });
}

/** Of those in the texture of `first`, where that is a stamp. @param axis of the texture: 0 its u, 1 its v */
function stampsAlong(layers: readonly PlacedLayer[], first: PlacedLayer, axis: 0 | 1): Member[] {
  if (!isStamp(first.projector)) return [];
  return layers.flatMap((layer) => {
    const { id, projector } = layer;
    if (!isStamp(projector) || !sharesTexture(layer, first)) return [];
    const { low, high } = stampBounds([projector]);
    const [u, v] = projector.center;
    const move = (wanted: number): Projector => ({ ...projector, center: axis === 0 ? [wanted, v] : [u, wanted] });
    return [{ id, middle: projector.center[axis], half: (high[axis] - low[axis]) / 2, move }];
  });
}

/** By layer, those that do not lie in their place yet. */
function movedEvenly(members: readonly Member[]): ReadonlyMap<string, Projector> {
  const ordered = [...members].sort((one, other) => one.middle - other.middle);
  const [first, last] = [ordered[0], ordered.at(-1)];
  const between = ordered.slice(1, -1);
  if (first === undefined || last === undefined) return new Map();
  const length = last.middle - first.middle;
  const filled = between.reduce((sum, { half }) => sum + 2 * half, first.half + last.half);
  const room = length - filled;
  const steps = between.length + 1;
  // Gaps below zero would put small pictures on the far side of large ones.
  let edge = first.middle + first.half;
  const wanted = between.map(({ half }, at) => {
    if (room < 0) return first.middle + (length * (at + 1)) / steps;
    const middle = edge + room / steps + half;
    edge = middle + half;
    return middle;
  });
  return new Map(
    between.flatMap(({ id, middle, half, move }, at): [string, Projector][] => {
      const even = wanted[at] ?? middle;
      return Math.abs(even - middle) > IN_PLACE * (length + half) ? [[id, move(even)]] : [];
    }),
  );
}
