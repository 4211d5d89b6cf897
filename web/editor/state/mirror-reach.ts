/** What a layer takes on with a mirror: that, and the materials that its twin lies on. */

import {
  layerMaterials,
  type Mirror,
  materialsOf,
  mirroredProjector,
  type PaintLayer,
  type PlacedLayer,
  type Projector,
  type StrokeLayer,
} from "../document/index.ts";
import type { DecalReach } from "./decal-reach.ts";
import type { LayerPatch } from "./layer-commands.ts";

/**
 * Dabs of a layer whose twins are asked about in a frame of a scrub, spread over all: they lie so close that these meet what the
 * others do, but for a corner here and there. All 2000 of a painting take 35 to 600 ms a frame, so few 1 to 10.
 */
const SCRUBBED = 32;

/** @param mirror null takes a layer's mirror away */
export function mirrorPatch(
  reach: DecalReach,
  layer: PlacedLayer | StrokeLayer | PaintLayer,
  mirror: Mirror | null,
): LayerPatch {
  return patchOf(reach, layer, mirror, Number.POSITIVE_INFINITY);
}

/** As `mirrorPatch`, while the mirror is scrubbed: what few of a painting's dabs meet. */
export function scrubbedMirrorPatch(
  reach: DecalReach,
  layer: PlacedLayer | StrokeLayer | PaintLayer,
  mirror: Mirror,
): LayerPatch {
  return patchOf(reach, layer, mirror, SCRUBBED);
}

function patchOf(
  reach: DecalReach,
  layer: PlacedLayer | StrokeLayer | PaintLayer,
  mirror: Mirror | null,
  most: number,
): LayerPatch {
  if (layer.type === "paint") {
    const every = stepOf(layer.strokes, most);
    let first = 0;
    const strokes = layer.strokes.map((stroke) => {
      const changed = withTwins(reach, stroke, [stroke.mirror, mirror], sampled(stroke, every, first));
      first += stroke.dabs.length;
      return changed;
    });
    return { mirror, strokes };
  }
  if (layer.type === "stroke") {
    return { mirror, material: withTwins(reach, layer, [mirror], sampled(layer, stepOf([layer], most), 0)).material };
  }
  return { mirror, material: reach.movedTo(layer, layer.projector, null, mirror) };
}

/** Every how manieth dab is asked about, so that they are at most so many. */
const stepOf = (strokes: readonly StrokeLayer[], most: number): number =>
  Math.max(1, Math.ceil(strokes.reduce((sum, { dabs }) => sum + dabs.length, 0) / most));

/** @param first the place of the stroke's first dab among those of all strokes */
const sampled = ({ dabs }: StrokeLayer, every: number, first: number): readonly Projector[] =>
  every === 1 ? dabs : dabs.filter((_, at) => (first + at) % every === 0);

/** The stroke with the materials that the twins of those of its dabs meet besides its own; the stroke itself where it has them. */
function withTwins(
  reach: DecalReach,
  stroke: StrokeLayer,
  mirrors: readonly (Mirror | null)[],
  asked: readonly Projector[],
): StrokeLayer {
  let dabs = asked;
  for (const mirror of mirrors) if (mirror) dabs = dabs.flatMap((dab) => [dab, mirroredProjector(dab, mirror) ?? dab]);
  const itself = new Set<Projector>(asked);
  const own = materialsOf(stroke);
  const met = new Set(own);
  for (const dab of dabs) {
    if (!itself.has(dab)) for (const material of reach.all(dab, stroke.backfaces)) met.add(material);
  }
  return met.size === own.length ? stroke : { ...stroke, material: layerMaterials([...met].sort((a, b) => a - b)) };
}
