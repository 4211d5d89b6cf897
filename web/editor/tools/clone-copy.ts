/** What a clone stroke copies, in either view: read once when the stroke begins, and cut to the stroke when it ends. */
import type { Picture } from "../../engine/engine-api.ts";
import type { PerspectiveProjector, Projector, StrokeLayer, UvProjector } from "../document/index.ts";
import { diagonalOf } from "../state/design-state.ts";
import { areaOf, eyeOf, joinedArea, type Look, type LookArea } from "./clone-look.ts";
import { areaAround, type PixelArea, pictureOfSight, pieceOf } from "./clone-picture.ts";
import type { ToolContext } from "./tool-context.ts";

/** A picture and where it is thrown from. */
export interface ThrownPicture {
  readonly picture: Picture;
  readonly projector: Projector;
}

export interface CloneCopy {
  /** What a stroke could show that goes anywhere in the view; coarser than the end's. Rejects as the engine does. */
  begin(): Promise<ThrownPicture>;
  /** What the stroke shows, after `begin`; null where that is nothing. */
  end(stroke: StrokeLayer): ThrownPicture | null;
}

/** Of the distance to the eye: how far to each side a stroke may go. More than a view shows. */
const WIDTH_SHARE = 1.8;
/** Pixels across. */
const LEAST_PICTURE = 16;
const BEGIN_PICTURE = 1024;
const MOST_PICTURE = 2048;
/** Pixels of the picture in a texel of the source, across: what is read twice must not blur. */
const OVERSAMPLING = 1.5;
/** Pixels left about what is shown, which filters read. */
const MARGIN = 3;

/** On the model: what an eye before the source sees is thrown from the eye before the painted place. */
export class ModelCopy implements CloneCopy {
  readonly #context: ToolContext;
  readonly #source: Look;
  readonly #painted: Look;
  readonly #texel: number;
  readonly #nearest: boolean;
  readonly #half: number;
  readonly #reach: number;
  readonly #textures = new Map<number, Picture>();

  /** @param texel metres that a texel of the source is wide */
  constructor(context: ToolContext, source: Look, painted: Look, texel: number, nearest: boolean) {
    this.#context = context;
    this.#source = source;
    this.#painted = painted;
    this.#texel = texel;
    this.#nearest = nearest;
    this.#reach = diagonalOf(context.store.state.model);
    const distance = Math.hypot(...painted.eye.map((part, axis) => part - (painted.at[axis] as number)));
    this.#half = Math.min(WIDTH_SHARE * distance, this.#reach);
  }

  async begin(): Promise<ThrownPicture> {
    const half = this.#half;
    const across = pixelsOf(2 * half, this.#texel, BEGIN_PICTURE);
    const eye = eyeOf(this.#source, [half, half], this.#reach);
    const sight = this.#context.viewer.surface.seenFrom(eye, across, across);
    for (const material of new Set(sight?.materials)) {
      const texture = await textureOf(this.#context, material);
      if (texture !== null) this.#textures.set(material, texture);
    }
    return this.#thrown([half, half], [across, across], { left: 0, top: 0, right: across, bottom: across });
  }

  end({ dabs }: StrokeLayer): ThrownPicture | null {
    let area: LookArea | null = null;
    for (const dab of dabs) {
      if (dab.kind === "planar") area = joinedArea(area, areaOf(this.#painted, dab.position, dab.size[0] / 2));
    }
    if (area === null) return null;
    const { left, right, bottom, top } = area;
    const within = (half: number): number => Math.min(this.#half, half);
    const half = [
      within(Math.max(Math.abs(left), Math.abs(right))),
      within(Math.max(Math.abs(bottom), Math.abs(top))),
    ] as const;
    const fine = this.#texel / OVERSAMPLING;
    const [width, height] = half.map((each) => pixelsOf(2 * each, fine, MOST_PICTURE)) as [number, number];
    const [ofX, ofY] = [width / 2 / half[0], height / 2 / half[1]];
    return this.#thrown(half, [width, height], {
      left: Math.floor(width / 2 + left * ofX) - MARGIN,
      right: Math.ceil(width / 2 + right * ofX) + MARGIN,
      top: Math.floor(height / 2 - top * ofY) - MARGIN,
      bottom: Math.ceil(height / 2 - bottom * ofY) + MARGIN,
    });
  }

  #thrown(
    half: readonly [number, number],
    [width, height]: readonly [number, number],
    area: PixelArea,
  ): { readonly picture: Picture; readonly projector: PerspectiveProjector } {
    const eye = eyeOf(this.#source, half, this.#reach);
    const sight = this.#context.viewer.surface.seenFrom(eye, width, height);
    const empty = { width, height, rgba: new Uint8Array(width * height * 4) };
    return {
      picture: sight === null ? empty : pictureOfSight(sight, this.#textures, area, this.#nearest),
      projector: eyeOf(this.#painted, half, this.#reach),
    };
  }
}

type UvPoint = readonly [number, number];

/** On the flat texture: texel by texel, at an offset of whole texels of the source. */
export class TextureCopy implements CloneCopy {
  readonly #context: ToolContext;
  readonly #from: { readonly material: number; readonly uv: UvPoint };
  readonly #to: { readonly material: number; readonly uv: UvPoint };
  #texture: Picture | null = null;

  constructor(context: ToolContext, from: TextureCopy["from"], to: TextureCopy["from"]) {
    this.#context = context;
    this.#from = from;
    this.#to = to;
  }

  get from(): { readonly material: number; readonly uv: UvPoint } {
    return this.#from;
  }

  async begin(): Promise<ThrownPicture> {
    const { material, uv } = this.#from;
    this.#texture = (await textureOf(this.#context, material)) ?? { width: 1, height: 1, rgba: new Uint8Array(4) };
    return this.#thrown(this.#texture, areaAround(this.#texture, uv, BEGIN_PICTURE / 2));
  }

  end({ dabs }: StrokeLayer): ThrownPicture | null {
    const texture = this.#texture;
    if (texture === null) return null;
    const { surface } = this.#context.viewer;
    const points = dabs.flatMap((dab): readonly UvPoint[] => {
      const hit = dab.kind === "planar" ? surface.near(dab.position) : null;
      if (dab.kind !== "planar" || hit?.material !== this.#to.material) return [];
      return surface.circleInTexture(hit, dab.size[0] / 2);
    });
    if (points.length === 0) return null;
    const { width, height } = texture;
    const [acrossX, acrossY] = this.#offset(texture);
    const bounds = (axis: 0 | 1, size: number, offset: number): [number, number] => {
      const places = points.map((point) => point[axis] * size - offset);
      const [low, high] = places.reduce(([least, most], at) => [Math.min(least, at), Math.max(most, at)], [
        Number.POSITIVE_INFINITY,
        Number.NEGATIVE_INFINITY,
      ] as [number, number]);
      return [Math.max(0, Math.floor(low) - MARGIN), Math.min(size, Math.ceil(high) + MARGIN)];
    };
    const [left, right] = bounds(0, width, acrossX);
    const [top, bottom] = bounds(1, height, acrossY);
    return left < right && top < bottom ? this.#thrown(texture, { left, right, top, bottom }) : null;
  }

  #offset({ width, height }: Picture): readonly [number, number] {
    const texels = (axis: 0 | 1, size: number): number =>
      Math.floor(this.#to.uv[axis] * size) - Math.floor(this.#from.uv[axis] * size);
    return [texels(0, width), texels(1, height)];
  }

  #thrown(texture: Picture, area: PixelArea): { readonly picture: Picture; readonly projector: UvProjector } {
    const { width, height } = texture;
    const [acrossX, acrossY] = this.#offset(texture);
    const { left, right, top, bottom } = area;
    return {
      picture: pieceOf(texture, area),
      projector: {
        kind: "uv",
        center: [((left + right) / 2 + acrossX) / width, ((top + bottom) / 2 + acrossY) / height],
        size: [(right - left) / width, (bottom - top) / height],
        angle: 0,
      },
    };
  }
}

/** The finished texture of a material; null while its target is not open. */
async function textureOf({ engine, store }: ToolContext, material: number): Promise<Picture | null> {
  const target = store.state.targets.get(material);
  if (!target) return null;
  const { width, height } = target;
  return { width, height, rgba: await engine.readTexels(material, 0, 0, width, height) };
}

const pixelsOf = (length: number, pixel: number, most: number): number =>
  Math.max(LEAST_PICTURE, Math.min(most, Math.ceil(length / pixel)));
