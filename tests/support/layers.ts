/** Layers with every field set, as the design document's defaults would fill them in. */
import type {
  EngineDab,
  EngineDecalLayer,
  EngineFillLayer,
  EngineGroupLayer,
  EngineLayer,
  EngineStrokeLayer,
  PlanarProjector,
} from "../../web/engine/engine-api.ts";

export const FRONT: PlanarProjector = {
  kind: "planar",
  position: [0, 0, 0],
  rotation: [0, 0, 0, 1],
  size: [0.5, 0.5, 0.5],
};

/** The defaults of spec.md, 8: how any layer is laid on the texture, and how one with a picture is cast at the surface. */
const LAID_ON = {
  material: 0,
  visible: true,
  opacity: 1,
  blend: "normal",
  blendSpace: "srgb",
  lockAlpha: false,
} as const;
const CAST = {
  filter: "linear",
  wrap: "none",
  flipX: false,
  flipY: false,
  backfaces: false,
  angleFade: [70, 90],
  occlusion: "self",
} as const;

export function decal(
  id: string,
  asset: EngineDecalLayer["asset"],
  changes: Partial<EngineDecalLayer> = {},
): EngineDecalLayer {
  return {
    id,
    type: "decal",
    asset,
    ...LAID_ON,
    ...CAST,
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
    ...LAID_ON,
    ...changes,
  };
}

/** A group that is passed through. */
export function group(
  id: string,
  layers: readonly EngineLayer[],
  changes: Partial<EngineGroupLayer> = {},
): EngineGroupLayer {
  const { material: _material, ...laidOn } = LAID_ON;
  return { id, type: "group", layers, isolated: false, ...laidOn, ...changes };
}

/** A black round brush. */
export function stroke(
  id: string,
  dabs: readonly EngineDab[],
  changes: Partial<EngineStrokeLayer> = {},
): EngineStrokeLayer {
  return {
    id,
    type: "stroke",
    brush: { tip: "round", color: [0, 0, 0, 1], hardness: 1, flow: 1 },
    dabs,
    ...LAID_ON,
    ...CAST,
    ...changes,
  };
}

/** A dab on the plane z = 0, metres. */
export function dab(x: number, y: number, size = 0.25, flow = 1): EngineDab {
  return { ...FRONT, position: [x, y, 0], size: [size, size, 0.5], flow };
}
