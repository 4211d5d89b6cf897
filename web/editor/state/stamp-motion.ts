/**
 * What a stamp takes along when it is put elsewhere in its texture: what lies in the texture as that does, and what is thrown at
 * the model by way of the surface, each thing from where its place of the texture lay to where the stamp has taken that.
 */
import type { UvProjector, Vec3 } from "../../engine/engine-api.ts";
import { uvOfStamp } from "../../viewer/stamp-drag.ts";
import { cross, dot, lengthOf, scaled, turnOfAxes, unit } from "../document/axes.ts";
import { minus, plus, turned } from "../document/rigid-motion.ts";
import { inStamp, type Posed } from "./picture-place.ts";
import type { MaskSurface } from "./remembered-surface.ts";
import { stampWith } from "./stamps-together.ts";

type Uv = UvProjector["center"];

/** How the surface lies where a place of the texture is painted. */
interface Lie {
  readonly position: Vec3;
  readonly normal: Vec3;
  /** Metres, of a step as long as the texture is wide, and high. */
  readonly u: Vec3;
  readonly v: Vec3;
}

/** What the surface at one place of the texture becomes at another. */
interface Passage {
  place(place: Vec3): Vec3;
  way(way: Vec3): Vec3;
}

/** Of the texture: the surface's directions are measured over so much of it. */
const STEP = 2 ** -12;

export class StampMotion {
  readonly #start: UvProjector;
  readonly #now: UvProjector;
  readonly #materials: readonly number[];
  readonly #surface: MaskSurface;
  /** As the surface under the stamp's own middle is carried; null where it lies between charts. */
  readonly #middle: Passage | null;

  /** @param materials in whose textures the stamp lies */
  constructor(start: UvProjector, now: UvProjector, materials: readonly number[], surface: MaskSurface) {
    this.#start = start;
    this.#now = now;
    this.#materials = materials;
    this.#surface = surface;
    this.#middle =
      materials.map((material) => this.#passage(material, start.center)).find((each) => each !== null) ?? null;
  }

  /** By how much it is larger, as the mean of its sides. */
  get growth(): number {
    const [width, height] = this.#start.size;
    return Math.sqrt((this.#now.size[0] / width) * (this.#now.size[1] / height));
  }

  stamp(other: UvProjector): UvProjector {
    const { center, angle } = this.#start;
    const [right, down] = inStamp(this.#start, other.center);
    const upright = { ...other, center: [center[0] + right, center[1] + down], angle: other.angle - angle } as const;
    return stampWith({ ...this.#start, angle: 0 }, this.#now, upright);
  }

  /** The texture knows where the surface is. */
  lift(): number {
    return 0;
  }

  /** Null where the texture has no surface that it could go over. */
  posed(other: Posed): Partial<Posed> | null {
    const foot = this.#surface.near(other.position);
    const own = foot && this.#materials.includes(foot.material) ? this.#passage(foot.material, foot.uv) : null;
    const passage = own ?? this.#middle;
    if (passage === null) return null;
    const axis = (of: Vec3): Vec3 => passage.way(turned(other.rotation, of));
    const axes = [axis([1, 0, 0]), axis([0, 1, 0]), axis([0, 0, 1])] as const;
    const z = unit(axes[2]);
    const x = unit(minus(axes[0], scaled(z, dot(axes[0], z))));
    const position = passage.place(other.position);
    const rotation = turnOfAxes(x, cross(z, x), z);
    if (other.kind !== "planar") return { position, rotation };
    const [width, height, depth] = other.size;
    return {
      position,
      rotation,
      size: [width * lengthOf(axes[0]), height * lengthOf(axes[1]), depth * lengthOf(axes[2])],
    };
  }

  /** Of what may lie far from the stamp: where its middle takes that. */
  place(place: Vec3): Vec3 {
    return this.#middle?.place(place) ?? place;
  }

  #passage(material: number, at: Uv): Passage | null {
    const goal = this.#goalOf(at);
    const [from, to] = [this.#lieAt(material, at), this.#lieAt(material, goal)];
    if (from === null || to === null) return null;
    const [uu, uv, vv] = [dot(from.u, from.u), dot(from.u, from.v), dot(from.v, from.v)];
    const area = uu * vv - uv * uv;
    if (!(area > 0)) return null;
    const way = (of: Vec3): Vec3 => {
      const [alongU, alongV] = [dot(of, from.u), dot(of, from.v)];
      const next = this.#goalOf([
        at[0] + (alongU * vv - alongV * uv) / area,
        at[1] + (alongV * uu - alongU * uv) / area,
      ]);
      const [right, down] = [next[0] - goal[0], next[1] - goal[1]];
      const grown = Math.sqrt(lengthOf(cross(to.u, to.v)) / Math.sqrt(area)) * this.growth;
      const above = scaled(to.normal, dot(of, from.normal) * grown);
      return plus(plus(scaled(to.u, right), scaled(to.v, down)), above);
    };
    return { way, place: (place) => plus(to.position, way(minus(place, from.position))) };
  }

  #goalOf(uv: Uv): Uv {
    const [right, down] = inStamp(this.#start, uv);
    return uvOfStamp(this.#now, right / this.#start.size[0], -down / this.#start.size[1]);
  }

  #lieAt(material: number, [u, v]: Uv): Lie | null {
    const { position, normal } = this.#surface.atUv(material, [u, v]) ?? {};
    if (!position || !normal) return null;
    const measured = (right: number, down: number): Vec3 | null => {
      const ways = [STEP, -STEP].flatMap((step) => {
        const beside = this.#surface.atUv(material, [u + right * step, v + down * step]);
        const way = beside && scaled(minus(beside.position, position), 1 / step);
        return way && dot(way, way) > 0 ? [way] : [];
      });
      // At a chart's rim one of both lies on the next chart: beyond a fold, or anywhere.
      const [first, second] = ways;
      return first && second && astray(second, normal) < astray(first, normal) ? second : (first ?? null);
    };
    const [alongU, alongV] = [measured(1, 0), measured(0, 1)];
    return alongU && alongV && { position, normal, u: alongU, v: alongV };
  }
}

/** How far a way is, and leaves the surface: less of the one that stays on it. */
const astray = (way: Vec3, normal: Vec3): number => lengthOf(way) + Math.abs(dot(way, normal));
