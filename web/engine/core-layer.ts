/** An engine's layer in the ABI's numbers. */
import {
  BlendSpaces,
  Blends,
  type Dab,
  Filters,
  type LayerDef,
  LayerKinds,
  Occlusions,
  Projectors,
  Tips,
  Wraps,
} from "../core/abi.ts";
import type { ImageHandle } from "../core/session.ts";
import type { BlendMode, EngineBrush, EngineDab, Projector } from "./engine-api.ts";
import type { EnginePaintingLayer } from "./layer-tree.ts";

/** The ABI's numbers under the standard's names, which are hyphenated. */
const BLEND_NUMBERS: Readonly<Record<BlendMode, number>> = {
  ...Blends,
  "color-dodge": Blends.colorDodge,
  "color-burn": Blends.colorBurn,
  "hard-light": Blends.hardLight,
  "soft-light": Blends.softLight,
};

/** `image`: the layer's picture, 0 where it has none. */
export function coreLayer(layer: EnginePaintingLayer, image: ImageHandle): Partial<LayerDef> {
  const shared = {
    visible: Number(layer.visible),
    opacity: layer.opacity,
    blend: BLEND_NUMBERS[layer.blend],
    blendSpace: BlendSpaces[layer.blendSpace],
    lockAlpha: Number(layer.lockAlpha),
  };
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
  return { ...cast, kind: LayerKinds.decal, ...coreProjector(layer.projector) };
}

export const coreDab = (dab: EngineDab): Partial<Dab> => ({ flow: dab.flow, ...coreProjector(dab) });

function coreBrush(brush: EngineBrush): Partial<LayerDef> {
  const { flow } = brush;
  if (brush.tip === "round") return { tip: Tips.round, flow, hardness: brush.hardness, color: brush.color };
  return brush.color === null ? { tip: Tips.picture, flow } : { tip: Tips.mask, flow, color: brush.color };
}

function coreProjector(projector: Projector): Partial<Omit<Dab, "flow">> {
  const kind = { projector: Projectors[projector.kind] };
  if (projector.kind === "uv") {
    const { center, size, angle } = projector;
    return { ...kind, uvCenter: center, uvSize: size, uvAngleDegrees: angle };
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
