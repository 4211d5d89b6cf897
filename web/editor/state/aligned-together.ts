/** Several pictures brought into line with one of them: into a column under it, or into a row beside it. */
import type { Projector, Vec3 } from "../../engine/engine-api.ts";
import type { ModelViewer } from "../../viewer/viewer-api.ts";
import { materialsOf, type PlacedLayer } from "../document/index.ts";
import { turned } from "../document/rigid-motion.ts";

export const ALIGNMENT_LINES = ["column", "row"] as const;
export type LineOfLayers = (typeof ALIGNMENT_LINES)[number];

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
      const across: Vec3 = line === "column" ? [1, 0, 0] : [0, 1, 0];
      return viewer.centred(projector, [{ point: lead.position, normal: turned(lead.rotation, across) }]);
    }
    if (lead.kind !== "uv" || projector.kind !== "uv" || !sharesTexture(layer, first)) return projector;
    const [u, v] = projector.center;
    return { ...projector, center: line === "column" ? [lead.center[0], v] : [u, lead.center[1]] };
  });
}

/** Whether some of these layers can be brought into line with another one. */
export function canAlign(layers: readonly PlacedLayer[]): boolean {
  const boxes = layers.filter(({ projector }) => projector.kind === "planar");
  const stamps = layers.filter(({ projector }) => projector.kind === "uv");
  return (
    boxes.length > 1 || stamps.some((stamp, at) => stamps.slice(at + 1).some((other) => sharesTexture(stamp, other)))
  );
}

function sharesTexture(layer: PlacedLayer, other: PlacedLayer): boolean {
  const materials = materialsOf(other);
  return materialsOf(layer).some((material) => materials.includes(material));
}
