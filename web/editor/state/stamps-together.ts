/** Flat stamps as one: turned and sized about their common middle, which lies in the texture. */
import type { Projector, UvProjector } from "../../engine/engine-api.ts";
import { stampBounds, uvOfStamp } from "../../viewer/stamp-drag.ts";
import { materialsOf, type PlacedLayer } from "../document/index.ts";
import type { ProjectorChange } from "./chosen-together.ts";
import { wrapDegrees } from "./rotation.ts";

const RADIANS = Math.PI / 180;

/** A layer that lies in a texture as a stamp. */
export type Stamp = PlacedLayer & { readonly projector: UvProjector };

/** One that covers the whole texture is no stamp to be moved but a sheet of pixels. */
export function isStamp(projector: Projector): projector is UvProjector {
  if (projector.kind !== "uv") return false;
  const { center, size, angle } = projector;
  return angle !== 0 || [...center, ...size].some((part, index) => part !== (index < 2 ? 0.5 : 1));
}

/** Of layers those that lie as stamps in the texture of a material. */
export function stampsIn(layers: readonly PlacedLayer[], material: number | null): Stamp[] {
  return layers.filter(
    (layer): layer is Stamp => isStamp(layer.projector) && material !== null && materialsOf(layer).includes(material),
  );
}

/** Upright, round all of them. */
export function stampsBox(stamps: readonly Stamp[]): UvProjector {
  const { low, high } = stampBounds(stamps.map(({ projector }) => projector));
  return {
    kind: "uv",
    center: [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2],
    size: [high[0] - low[0], high[1] - low[1]],
    angle: 0,
  };
}

/** A stamp that lies in an upright box, as it lies once the box is another. */
export function stampWith(box: UvProjector, now: UvProjector, stamp: UvProjector): UvProjector {
  const place = uvOfStamp(
    now,
    (stamp.center[0] - box.center[0]) / box.size[0],
    (box.center[1] - stamp.center[1]) / box.size[1],
  );
  const [across, down] = [now.size[0] / box.size[0], now.size[1] / box.size[1]];
  const share = Math.cos(stamp.angle * RADIANS) ** 2;
  // Turned in the box it could not be slanted as the box would slant it: as a power, so that stretching can be undone.
  const width = stamp.size[0] * across ** share * down ** (1 - share);
  const height = stamp.size[1] * down ** share * across ** (1 - share);
  return { ...stamp, center: place, size: [width, height], angle: wrapDegrees(stamp.angle + now.angle) };
}

/**
 * Projectors of layers, in which those of stamps are what a change of all stamps of a texture at once makes of each. It goes about
 * the mean of their middles, which stays where it is however often that is done.
 */
export function stampsChanged(
  layers: readonly PlacedLayer[],
  projectors: readonly Projector[],
  change: ProjectorChange,
): readonly Projector[] {
  const centers = new Map<string, UvProjector["center"][]>();
  for (const layer of layers) {
    if (layer.projector.kind !== "uv") continue;
    const texture = textureOf(layer);
    const known = centers.get(texture);
    if (known) known.push(layer.projector.center);
    else centers.set(texture, [layer.projector.center]);
  }
  const changes = new Map([...centers].map(([texture, all]) => [texture, changeAbout(all, change)]));
  return layers.map((layer, index) => {
    const { projector } = layer;
    const changed = projector.kind === "uv" ? changes.get(textureOf(layer))?.(projector) : projectors[index];
    return changed ?? projector;
  });
}

const textureOf = (layer: PlacedLayer): string => materialsOf(layer).join();

/** About the mean of those places. */
function changeAbout(
  centers: readonly UvProjector["center"][],
  change: ProjectorChange,
): (stamp: UvProjector) => UvProjector {
  const mean = (axis: 0 | 1): number => centers.reduce((sum, center) => sum + center[axis], 0) / centers.length;
  const box: UvProjector = { kind: "uv", center: [mean(0), mean(1)], size: [1, 1], angle: 0 };
  const now = change(box);
  return (stamp) => stampWith(box, now, stamp);
}
