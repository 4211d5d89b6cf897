/**
 * A mask that goes with its layer, or with the pictures of its group: what is in it keeps its place on the picture that it lies
 * on, or is nearest to, when that is moved, turned and sized.
 */
import type { Projector, UvProjector, Vec3 } from "../../engine/engine-api.ts";
import { sameItems } from "../../engine/same-items.ts";
import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import { boundedLength } from "../document/bounded-length.ts";
import { type Gradient, type Mask, type MaskLayer, materialsOf, type PlacedLayer } from "../document/index.ts";
import { liesOnTexture, mirroredProjector } from "../document/mirror-layer.ts";
import { roundedDab } from "../tools/dab-chain.ts";
import { carriedPosed, liftOf, motionOf } from "./picture-motion.ts";
import { type Distance, distanceFrom, distanceFromStamp, isNearer, type Posed } from "./picture-place.ts";
import type { MaskSurface } from "./remembered-surface.ts";
import { StampMotion } from "./stamp-motion.ts";
import { strokeLifts } from "./stroke-lifts.ts";

/** What a mask masks, and where its mirror shows that. */
type Picture = Pick<PlacedLayer, "projector" | "mirror" | "material">;

/**
 * The mask of a layer that is put where another projector has it; itself where it is not linked, or where nothing in it can go
 * along: fills of one colour and of parts, and what lies in the texture under what is thrown at the model.
 */
export const carriedMask = (
  layer: Picture & Pick<PlacedLayer, "mask">,
  now: Projector,
  surface: MaskSurface,
): Mask | null => carriedGroupMask(layer.mask, [layer], [now], surface);

/** Whether all that is in a mask goes where its layer, or what is in its group, goes. */
export const maskGoesAlong = (mask: Mask | null, pictures: readonly Pick<Picture, "projector">[]): boolean =>
  mask === null || (mask.linked && leftBehind(mask, pictures).length === 0);

/** What in a mask cannot go along: pixels that lie in the texture, where no picture does, and fills of parts. */
export function leftBehind(mask: Mask, pictures: readonly Pick<Picture, "projector">[]): readonly MaskLayer[] {
  const hasStamp = pictures.some(({ projector }) => projector.kind === "uv");
  return mask.layers.filter((layer) =>
    layer.type === "fill" ? layer.parts !== null : !hasStamp && liesOnTexture(layer),
  );
}

/** Of a picture that is put elsewhere, or of its twin. */
interface Way {
  readonly from: Projector;
  readonly materials: readonly number[];
  /** Null where it stays, or has become one of another kind. */
  readonly carry: Carrier | null;
}

/** Null where it takes none of that kind along. */
interface Carrier {
  posed(other: Posed, lift: number): Partial<Posed> | null;
  /** Metres, by which it is raised to lie as far over the surface as before. */
  lift(other: Posed): number;
  stamp(other: UvProjector): UvProjector | null;
  place(place: Vec3): Vec3;
  /** How much wider the picture is, as the mean of both its sides. */
  readonly growth: number;
}

/** Where all pictures go that may take something along. */
interface Ways {
  /** What lies in a texture. */
  readonly stamps: readonly Way[];
  /** What is thrown at the model. */
  readonly posed: readonly Way[];
  /** A gradient: it has no twin itself. */
  readonly gradients: readonly Way[];
  readonly pictures: readonly Picture[];
  readonly surface: MaskSurface;
}

/**
 * The mask of a group whose pictures are put where other projectors have them, in the same order. Each thing in it goes with the
 * picture that it is nearest to, as it would on that picture's own mask.
 */
export function carriedGroupMask(
  mask: Mask | null,
  pictures: readonly Picture[],
  now: readonly Projector[],
  surface: MaskSurface,
): Mask | null {
  if (mask === null || !mask.linked || mask.layers.length === 0) return mask;
  const own = pictures.map((picture, index) => wayOf(picture, now[index] ?? picture.projector, surface));
  if (own.every(({ carry }) => carry === null)) return mask;
  const twins = pictures.flatMap((picture, index) => {
    const [from, to] = [picture.projector, now[index]].map(
      (each) => each && picture.mirror && mirroredProjector(each, picture.mirror),
    );
    return from && to ? [wayOf({ ...picture, projector: from }, to, surface)] : [];
  });
  const stamps = own.filter(({ from }) => from.kind === "uv");
  const ways: Ways = { stamps, posed: [...own, ...twins], gradients: own, pictures, surface };
  const layers = mask.layers.map((layer) => carriedLayer(layer, ways));
  return sameItems(layers, mask.layers) ? mask : { ...mask, layers };
}

function wayOf({ projector: from, ...picture }: Picture, to: Projector, surface: MaskSurface): Way {
  const materials = materialsOf(picture);
  // What came back to where it was must not be another for the digits that carrying costs.
  const stays = JSON.stringify(from) === JSON.stringify(to);
  return { from, materials, carry: stays ? null : carrier(from, to, materials, surface) };
}

function carriedLayer(layer: MaskLayer, ways: Ways): MaskLayer {
  if (layer.type === "fill") {
    return layer.gradient === null ? layer : withChanged(layer, "gradient", carriedGradient(layer.gradient, ways));
  }
  if (layer.type !== "stroke") {
    const { projector } = layer;
    return withChanged(layer, "projector", carriedThing(projector, layer, ways, liftBy(projector, ways)));
  }
  const lifts = strokeLifts(layer.dabs, (dab) => liftBy(dab, ways));
  const dabs = layer.dabs.map((dab, index) => {
    const carried = carriedThing(dab, layer, ways, lifts[index] ?? 0);
    return carried === dab ? dab : roundedDab(carried);
  });
  return sameItems(dabs, layer.dabs) ? layer : { ...layer, dabs };
}

const withChanged = <L, K extends keyof L>(layer: L, key: K, value: L[K]): L =>
  layer[key] === value ? layer : { ...layer, [key]: value };

function carriedThing<P extends Projector>(thing: P, layer: MaskLayer, ways: Ways, lift: number): P {
  const change =
    thing.kind === "uv" ? changeOfStamp(thing, layer, ways) : nearestToPosed(thing, ways)?.carry?.posed(thing, lift);
  if (!change) return thing;
  const carried = { ...thing, ...change };
  return "size" in carried ? { ...carried, size: carried.size.map(boundedLength) } : carried;
}

const liftBy = (thing: Projector, ways: Ways): number =>
  thing.kind === "uv" ? 0 : (nearestToPosed(thing, ways)?.carry?.lift(thing) ?? 0);

function changeOfStamp(stamp: UvProjector, layer: MaskLayer, { stamps, pictures }: Ways): UvProjector | null {
  const own = materialsOf(layer);
  const way = nearest(stamps, stamp, pictures, ({ from, materials }) => {
    const distance = from.kind === "uv" ? distanceFromStamp(from, stamp.center) : FAR;
    return materials.some((material) => own.includes(material)) ? distance : { ...distance, outside: FAR.outside };
  });
  return way?.carry?.stamp(stamp) ?? null;
}

const nearestToPosed = (other: Posed, { posed, pictures, surface }: Ways): Way | undefined =>
  nearest(posed, other, pictures, distanceTo(other.position, surface));

/** A place in it goes where the nearest picture goes. */
function carriedGradient(gradient: Gradient, { gradients, pictures, surface }: Ways): Gradient {
  const at = (place: Vec3): Carrier | null | undefined =>
    nearest(gradients, null, pictures, distanceTo(place, surface))?.carry;
  if (gradient.kind === "linear") {
    const [from, to] = [gradient.from, gradient.to].map((place) => at(place)?.place(place) ?? place) as [Vec3, Vec3];
    return from === gradient.from && to === gradient.to ? gradient : { ...gradient, from, to };
  }
  const { center, radius } = gradient;
  const carry = at(center);
  return carry ? { ...gradient, center: carry.place(center), radius: boundedLength(radius * carry.growth) } : gradient;
}

/** Behind whatever has a distance that can be told in metres. */
const FAR: Distance = { outside: Number.POSITIVE_INFINITY, fromMiddle: Number.POSITIVE_INFINITY };

/** Of pictures to a place of the model. One that lies in the texture there comes before all that do not hold the place. */
function distanceTo(place: Vec3, surface: MaskSurface): (way: Way) => Distance {
  let foot: SurfaceHit | null | undefined;
  return ({ from, materials }) => {
    if (from.kind !== "uv") return distanceFrom(from, place);
    if (foot === undefined) foot = surface.near(place);
    if (foot === null || !materials.includes(foot.material)) return FAR;
    const { outside, fromMiddle } = distanceFromStamp(from, foot.uv);
    return outside === 0 ? { ...FAR, outside } : { ...FAR, fromMiddle };
  };
}

/** Which of many ways each thing goes, by the pictures that it was looked for among: a drag asks for thousands at each move. */
const NEAREST = new WeakMap<Projector, { readonly pictures: readonly Picture[]; readonly index: number }>();

function nearest(
  ways: readonly Way[],
  thing: Projector | null,
  pictures: readonly Picture[],
  distance: (way: Way) => Distance,
): Way | undefined {
  if (ways.length < 2) return ways[0];
  const known = thing && NEAREST.get(thing);
  if (known?.pictures === pictures) return ways[known.index];
  const distances = ways.map(distance);
  const index = distances.reduce((best, each, at) => (isNearer(each, distances[best] as Distance) ? at : best), 0);
  if (thing) NEAREST.set(thing, { pictures, index });
  return ways[index];
}

function carrier(start: Projector, now: Projector, materials: readonly number[], surface: MaskSurface): Carrier | null {
  if (start.kind === "uv" || now.kind === "uv") {
    const stays = start.kind !== "uv" || now.kind !== "uv";
    return stays ? null : new StampMotion(start, now, materials, surface);
  }
  const motion = motionOf(start, now);
  return (
    motion && {
      posed: (other, lift) => carriedPosed(other, motion, lift),
      lift: (other) => liftOf(other, motion, (place) => surface.near(place)),
      stamp: () => null,
      place: (place) => motion.at(place).place,
      growth: Math.sqrt(motion.growth[0] * motion.growth[1]),
    }
  );
}
