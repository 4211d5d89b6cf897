/**
 * A mask that goes with its layer, or with the pictures of its group: what is in it keeps its place on the picture that it lies
 * on, or is nearest to, when that is moved, turned and sized.
 */
import type { Projector, UvProjector, Vec3 } from "../../engine/engine-api.ts";
import { sameItems } from "../../engine/same-items.ts";
import type { Gradient, Mask, MaskLayer } from "../document/index.ts";
import { mirroredProjector } from "../document/mirror-layer.ts";
import { roundedDab } from "../tools/dab-chain.ts";
import type { NearSurface } from "./carried-projector.ts";
import type { PlacedLayer } from "./decal-reach.ts";
import { carriedPosed, motionOf } from "./picture-motion.ts";
import { type Distance, distanceFrom, distanceFromStamp, inStamp, isNearer, type Posed } from "./picture-place.ts";
import { stampWith } from "./stamps-together.ts";

/** What a mask shows of, and where its mirror shows that. */
type Picture = Pick<PlacedLayer, "projector" | "mirror">;

/**
 * The mask of a layer that is put where another projector has it; itself where it is not linked, or where nothing in it can go
 * along: fills of one colour and of parts, what lies in the texture under what is thrown at the model, and the other way round.
 */
export const carriedMask = (
  layer: Picture & Pick<PlacedLayer, "mask">,
  now: Projector,
  near: NearSurface,
): Mask | null => carriedWith(layer.mask, [layer], [now], near);

/**
 * The mask of a group whose pictures are put where other projectors have them, in the same order. Each thing in it goes with the
 * picture that it is nearest to, as it would on that picture's own mask.
 */
export const carriedGroupMask = (
  mask: Mask | null,
  pictures: readonly Picture[],
  now: readonly Projector[],
  near: NearSurface,
): Mask | null => carriedWith(mask, pictures, now, near);

/** Whether all that is in a mask goes where its layer, or what is in its group, goes. */
export const maskGoesAlong = (mask: Mask | null, pictures: readonly Pick<Picture, "projector">[]): boolean =>
  mask === null ||
  (mask.linked &&
    mask.layers.every((layer) => {
      if (layer.type === "fill") return layer.parts === null;
      const projectors: readonly Projector[] = layer.type === "stroke" ? layer.dabs : [layer.projector];
      return projectors.every((each) =>
        pictures.some(({ projector }) => (each.kind === "uv") === (projector.kind === "uv")),
      );
    }));

/** Of a picture that is put elsewhere, or of its twin. */
interface Way<P extends Projector = Projector> {
  readonly from: P;
  /** Null where it stays, or has become one of another kind. */
  readonly carry: Carrier | null;
}

/** Null where it takes none of that kind along. */
interface Carrier {
  posed(other: Posed): Partial<Posed> | null;
  stamp(other: UvProjector): UvProjector | null;
  place(place: Vec3): Vec3;
  /** How much wider the picture is, as the mean of both its sides. */
  readonly growth: number;
}

/** Where all pictures go. */
interface Ways {
  readonly posed: readonly Way<Posed>[];
  /** Of those the pictures themselves, without twins. */
  readonly own: readonly Way<Posed>[];
  readonly stamps: readonly Way<UvProjector>[];
}

function carriedWith(
  mask: Mask | null,
  pictures: readonly Picture[],
  now: readonly Projector[],
  near: NearSurface,
): Mask | null {
  if (mask === null || !mask.linked || mask.layers.length === 0) return mask;
  const goals = pictures.map(({ projector }, index) => now[index] ?? projector);
  // What came back to where it was must not be another for the digits that carrying costs.
  const moves = pictures.map(({ projector }, index) => JSON.stringify(projector) !== JSON.stringify(goals[index]));
  if (!moves.includes(true)) return mask;
  const own = pictures.map(({ projector }, index): Way => {
    const goal = goals[index] as Projector;
    return { from: projector, carry: moves[index] ? carrier(projector, goal, near) : null };
  });
  const twins = pictures.flatMap(({ projector, mirror }, index): Way[] => {
    const [from, to] = [projector, goals[index] as Projector].map((each) => mirror && mirroredProjector(each, mirror));
    return from && to ? [{ from, carry: moves[index] ? carrier(from, to, near) : null }] : [];
  });
  const ways: Ways = {
    posed: [...own, ...twins].filter(isPosed),
    own: own.filter(isPosed),
    stamps: own.filter((way): way is Way<UvProjector> => way.from.kind === "uv"),
  };
  const layers = mask.layers.map((layer) => carriedLayer(layer, ways, pictures));
  return sameItems(layers, mask.layers) ? mask : { ...mask, layers };
}

const isPosed = (way: Way): way is Way<Posed> => way.from.kind !== "uv";

function carriedLayer(layer: MaskLayer, ways: Ways, pictures: readonly Picture[]): MaskLayer {
  if (layer.type === "fill") {
    return layer.gradient === null ? layer : withChanged(layer, "gradient", carriedGradient(layer.gradient, ways));
  }
  if (layer.type !== "stroke") return withChanged(layer, "projector", carriedThing(layer.projector, ways, pictures));
  const dabs = layer.dabs.map((dab) => {
    const carried = carriedThing(dab, ways, pictures);
    return carried === dab ? dab : roundedDab(carried);
  });
  return sameItems(dabs, layer.dabs) ? layer : { ...layer, dabs };
}

const withChanged = <L, K extends keyof L>(layer: L, key: K, value: L[K]): L =>
  layer[key] === value ? layer : { ...layer, [key]: value };

function carriedThing<P extends Projector>(thing: P, ways: Ways, pictures: readonly Picture[]): P {
  const change = thing.kind === "uv" ? changeOfStamp(thing, ways, pictures) : changeOfPosed(thing, ways, pictures);
  return change ? { ...thing, ...change } : thing;
}

function changeOfStamp(stamp: UvProjector, { stamps }: Ways, pictures: readonly Picture[]): UvProjector | null {
  const way = nearest(stamps, stamp, pictures, ({ from }) => distanceFromStamp(from, stamp.center));
  return way?.carry?.stamp(stamp) ?? null;
}

function changeOfPosed(other: Posed, { posed }: Ways, pictures: readonly Picture[]): Partial<Posed> | null {
  const way = nearest(posed, other, pictures, ({ from }) => distanceFrom(from, other.position));
  return way?.carry?.posed(other) ?? null;
}

/** A place in it goes where the nearest picture goes; a twin takes none along, as a fill has no twin itself. */
function carriedGradient(gradient: Gradient, { own }: Ways): Gradient {
  const at = (place: Vec3): Carrier | null | undefined =>
    nearest(own, null, [], ({ from }) => distanceFrom(from, place))?.carry;
  if (gradient.kind === "linear") {
    const [from, to] = [gradient.from, gradient.to].map((place) => at(place)?.place(place) ?? place) as [Vec3, Vec3];
    return from === gradient.from && to === gradient.to ? gradient : { ...gradient, from, to };
  }
  const { center, radius } = gradient;
  const carry = at(center);
  return carry ? { ...gradient, center: carry.place(center), radius: radius * carry.growth } : gradient;
}

/** Which of many ways each thing goes, by the pictures that it was looked for among: a drag asks for thousands at each move. */
const NEAREST = new WeakMap<Projector, { readonly pictures: readonly Picture[]; readonly index: number }>();

function nearest<W extends Way>(
  ways: readonly W[],
  thing: Projector | null,
  pictures: readonly Picture[],
  distance: (way: W) => Distance,
): W | undefined {
  if (ways.length < 2) return ways[0];
  const known = thing && NEAREST.get(thing);
  if (known?.pictures === pictures) return ways[known.index];
  const distances = ways.map(distance);
  const index = distances.reduce((best, each, at) => (isNearer(each, distances[best] as Distance) ? at : best), 0);
  if (thing) NEAREST.set(thing, { pictures, index });
  return ways[index];
}

function carrier(start: Projector, now: Projector, near: NearSurface): Carrier | null {
  if (start.kind === "uv" || now.kind === "uv") {
    return start.kind === "uv" && now.kind === "uv" ? carrierInTexture(start, now) : null;
  }
  const motion = motionOf(start, now);
  return (
    motion && {
      posed: (other) => carriedPosed(other, motion, near),
      stamp: () => null,
      place: (place) => motion.at(place).place,
      growth: Math.sqrt(motion.growth[0] * motion.growth[1]),
    }
  );
}

/** In the texture gradients have no place. */
function carrierInTexture(start: UvProjector, now: UvProjector): Carrier {
  const upright: UvProjector = { ...start, angle: 0 };
  return {
    posed: () => null,
    stamp: (other) => {
      const [right, down] = inStamp(start, other.center);
      const center = [start.center[0] + right, start.center[1] + down] as const;
      return stampWith(upright, now, { ...other, center, angle: other.angle - start.angle });
    },
    place: (place) => place,
    growth: 1,
  };
}
