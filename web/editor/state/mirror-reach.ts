/** What a layer takes on with a mirror: that, and the materials that its twin lies on. */
import {
  layerMaterials,
  type Mirror,
  materialsOf,
  mirroredProjector,
  type PaintLayer,
  type Projector,
  type StrokeLayer,
} from "../document/index.ts";
import type { DecalReach, PlacedLayer } from "./decal-reach.ts";
import type { LayerPatch } from "./layer-commands.ts";

/** @param mirror null takes a layer's mirror away */
export function mirrorPatch(
  reach: DecalReach,
  layer: PlacedLayer | StrokeLayer | PaintLayer,
  mirror: Mirror | null,
): LayerPatch {
  if (layer.type === "paint") {
    return { mirror, strokes: layer.strokes.map((stroke) => withTwins(reach, stroke, [stroke.mirror, mirror])) };
  }
  if (layer.type === "stroke") return { mirror, material: withTwins(reach, layer, [mirror]).material };
  return { mirror, material: reach.movedTo(layer, layer.projector, null, mirror) };
}

/** The stroke with the materials that its twins meet besides its own; the stroke itself where it has them. */
function withTwins(reach: DecalReach, stroke: StrokeLayer, mirrors: readonly (Mirror | null)[]): StrokeLayer {
  let dabs: readonly Projector[] = stroke.dabs;
  for (const mirror of mirrors) if (mirror) dabs = dabs.flatMap((dab) => [dab, mirroredProjector(dab, mirror) ?? dab]);
  const itself = new Set<Projector>(stroke.dabs);
  const own = materialsOf(stroke);
  const met = new Set(own);
  for (const dab of dabs) {
    if (!itself.has(dab)) for (const material of reach.all(dab, stroke.backfaces)) met.add(material);
  }
  return met.size === own.length ? stroke : { ...stroke, material: layerMaterials([...met].sort((a, b) => a - b)) };
}
