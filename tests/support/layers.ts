/** Layers with every field set, as the design document's defaults would fill them in. */
import type { EngineDecalLayer, EngineFillLayer, PlanarProjector } from "../../web/engine/engine-api.ts";

export const FRONT: PlanarProjector = {
  kind: "planar",
  position: [0, 0, 0],
  rotation: [0, 0, 0, 1],
  size: [0.5, 0.5, 0.5],
};

export function decal(id: string, asset: string, changes: Partial<EngineDecalLayer> = {}): EngineDecalLayer {
  return {
    id,
    type: "decal",
    asset,
    material: 0,
    visible: true,
    opacity: 1,
    blend: "normal",
    blendSpace: "srgb",
    lockAlpha: false,
    filter: "linear",
    wrap: "none",
    flipX: false,
    flipY: false,
    backfaces: false,
    angleFade: [70, 90],
    occlusion: "self",
    projector: FRONT,
    ...changes,
  };
}

export function fill(
  id: string,
  color: EngineFillLayer["color"],
  changes: Partial<EngineFillLayer> = {},
): EngineFillLayer {
  return {
    id,
    type: "fill",
    color,
    material: 0,
    visible: true,
    opacity: 1,
    blend: "normal",
    blendSpace: "srgb",
    lockAlpha: false,
    ...changes,
  };
}
