/** An engine's layer in the ABI's numbers. */
import {
  BlendSpaces,
  Blends,
  type CoreGradient,
  type Dab,
  Filters,
  GradientKinds,
  type LayerDef,
  LayerKinds,
  MAX_STOPS,
  Occlusions,
  Projectors,
  Tips,
  Wraps,
} from "../core/abi.ts";
import type { ImageHandle } from "../core/session.ts";
import type { BlendMode, EngineBrush, EngineDab, EngineGradient, EngineLayer, Projector } from "./engine-api.ts";

/** The ABI's numbers under the standard's names, which are hyphenated. */
const BLEND_NUMBERS: Readonly<Record<BlendMode, number>> = {
  ...Blends,
  "color-dodge": Blends.colorDodge,
  "color-burn": Blends.colorBurn,
  "hard-light": Blends.hardLight,
  "soft-light": Blends.softLight,
};

/** A layer without its place among the others. `image`: the layer's picture, 0 where it has none. */
export function coreLayer(layer: EngineLayer, image: ImageHandle): Partial<LayerDef> {
  const shared = {
    visible: Number(layer.visible),
    opacity: layer.opacity,
    blend: BLEND_NUMBERS[layer.blend],
    blendSpace: BlendSpaces[layer.blendSpace],
    lockAlpha: Number(layer.lockAlpha),
    invertMask: Number(layer.mask?.invert ?? false),
  };
  if (layer.type === "group") return { ...shared, kind: LayerKinds.group, isolated: Number(layer.isolated) };
  if (layer.type === "fill") return { ...shared, kind: LayerKinds.fill, color: layer.color };
  const cast = {
    ...shared,
    image,
    filter: Filters[layer.filter],
    wrap: Wraps[layer.wrap],
    flipX: Number(layer.flipX),
    flipY: Number(layer.flipY),
    backfaces: Number(layer.backfaces),
    angleFadeStart: layer.angleFade[0],
    angleFadeEnd: layer.angleFade[1],
    occlusion: Occlusions[layer.occlusion],
  };
  if (layer.type === "stroke") return { ...cast, kind: LayerKinds.stroke, ...coreBrush(layer.brush) };
  return { ...cast, kind: LayerKinds[layer.type], ...coreProjector(layer.projector) };
}

/** Stops that a gradient does not have are zeros. */
export function coreGradient(gradient: EngineGradient): Partial<CoreGradient> {
  const stops = gradient.stops.slice(0, MAX_STOPS);
  const padded = (numbers: readonly number[], length: number): number[] => [
    ...numbers,
    ...new Array<number>(length - numbers.length).fill(0),
  ];
  const shared = {
    kind: GradientKinds[gradient.kind],
    // All of them, so that too many are refused and not cut off.
    stopCount: gradient.stops.length,
    offsets: padded(
      stops.map(({ offset }) => offset),
      MAX_STOPS,
    ),
    colors: padded(
      stops.flatMap(({ color }) => color),
      4 * MAX_STOPS,
    ),
  };
  if (gradient.kind === "radial") return { ...shared, fromModel: gradient.center, radius: gradient.radius };
  return { ...shared, fromModel: gradient.from, toModel: gradient.to };
}

/** A dab as the core takes it. */
export const coreDab = (dab: EngineDab): Partial<Dab> => ({
  flow: dab.flow,
  flipX: Number(dab.flipX ?? false),
  ...coreProjector(dab),
});

function coreBrush(brush: EngineBrush): Partial<LayerDef> {
  const { flow } = brush;
  if (brush.tip === "round") return { tip: Tips.round, flow, hardness: brush.hardness, color: brush.color };
  return brush.color === null ? { tip: Tips.picture, flow } : { tip: Tips.mask, flow, color: brush.color };
}

function coreProjector(projector: Projector): Partial<Omit<Dab, "flow" | "flipX">> {
  const kind = { projector: Projectors[projector.kind] };
  if (projector.kind === "uv") {
    const { center, size, angle } = projector;
    // The core's numbers have 32 bits: of many turns they hold no degrees.
    return { ...kind, uvCenter: center, uvSize: size, uvAngleDegrees: angle % 360 };
  }
  const posed = { ...kind, positionModel: projector.position, rotation: projector.rotation };
  if (projector.kind === "perspective") {
    const { fov, aspect, near, far } = projector;
    return { ...posed, fovDegrees: fov, aspect, nearDistance: near, farDistance: far };
  }
  if (projector.kind === "cylindrical") {
    const { radius, height, arc, depth } = projector;
    return { ...posed, radius, height, arcDegrees: arc, depth };
  }
  return { ...posed, size: projector.size };
}
