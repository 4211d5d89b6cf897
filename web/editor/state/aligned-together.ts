/** Several pictures brought into line with one of them: into a column under it, or into a row beside it. */
import type { PlanarProjector, Projector, Vec3 } from "../../engine/engine-api.ts";
import type { ModelViewer } from "../../viewer/viewer-api.ts";
import { dot } from "../document/axes.ts";
import { materialsOf, type PlacedLayer } from "../document/index.ts";
import { minus, turned } from "../document/rigid-motion.ts";
import { isStamp } from "./stamps-together.ts";

export const ALIGNMENT_LINES = ["column", "row"] as const;
export type LineOfLayers = (typeof ALIGNMENT_LINES)[number];

/** Of a picture's longer side. */
const IN_PLACE = 2e-6;

/**
 * Projectors of layers, those that can be brought into line with `first`: boxes slide along the surface onto the plane through
 * the middle of another box, stamps in the texture that they share. The others stay as they are.
 */
export function alignedTogether(
  layers: readonly PlacedLayer[],
  first: PlacedLayer,
  line: LineOfLayers,
  viewer: Pick<ModelViewer, "centred">,
): readonly Projector[] {
  const lead = first.projector;
  return layers.map((layer) => {
    const { projector } = layer;
    if (layer.id === first.id) return projector;
    if (lead.kind === "planar") {
      const normal = turned(lead.rotation, line === "column" ? [1, 0, 0] : [0, 1, 0]);
      if (projector.kind !== "planar" || isThere(projector, lead.position, normal)) return projector;
      return viewer.centred(projector, [{ point: lead.position, normal }]);
    }
    if (!isStamp(lead) || !isStamp(projector) || !sharesTexture(layer, first)) return projector;
    const [u, v] = projector.center;
    if ((line === "column" ? u - lead.center[0] : v - lead.center[1]) === 0) return projector;
    return { ...projector, center: line === "column" ? [lead.center[0], v] : [u, lead.center[1]] };
  });
}

/** Nearer to the plane than a slide onto it comes. */
function isThere({ position, size }: PlanarProjector, point: Vec3, normal: Vec3): boolean {
  return Math.abs(dot(normal, minus(position, point))) <= IN_PLACE * Math.max(size[0], size[1]);
}

/** Whether some of these layers can be brought into line with another one. */
export function canAlign(layers: readonly PlacedLayer[]): boolean {
  const boxes = layers.filter(({ projector }) => projector.kind === "planar");
  const stamps = layers.filter(({ projector }) => isStamp(projector));
  return (
    boxes.length > 1 || stamps.some((stamp, at) => stamps.slice(at + 1).some((other) => sharesTexture(stamp, other)))
  );
}

/** Whether one lies on a material that the other lies on, too. */
export function sharesTexture(layer: PlacedLayer, other: PlacedLayer): boolean {
  const materials = materialsOf(other);
  return materialsOf(layer).some((material) => materials.includes(material));
}
