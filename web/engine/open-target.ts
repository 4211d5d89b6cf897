/** One material's texture while it is open: the core's target, its layers, and what the engine says about it. */
import { type MapInfo, NONE } from "../core/abi.ts";
import type { ImageHandle, Session } from "../core/session.ts";
import type { CoreUpdate, LayerHandle, Target } from "../core/target.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import { applyBase, type BasePicture, loadBasePicture, targetSize } from "./base-picture.ts";
import { coreGradient } from "./core-layer.ts";
import type {
  EngineLayer,
  ExpectedChange,
  Picture,
  TargetInfo,
  TargetOptions,
  TargetUpdate,
  Vec3,
} from "./engine-api.ts";
import { nextTurn } from "./event-loop.ts";
import { FillTriangles } from "./fill-triangles.ts";
import { NO_DETAILS } from "./layer-details.ts";
import { LayerSync } from "./layer-sync.ts";
import { layersOnMaterial } from "./layer-tree.ts";
import type { LoadedModel } from "./model-loader.ts";
import type { PrintZones } from "./print-zones.ts";
import type { RasterTarget } from "./raster-size.ts";
import { texelsPerMetre } from "./texel-density.ts";
import type { ZoneClip } from "./zone-clip-picture.ts";

/** Texels of the bake's first step; later ones aim at the times below. */
const FIRST_STEP = 1 << 17;
/** A step should last a good part of a frame and no more, so that moving decals elsewhere stays smooth. */
const SHORT_STEP_MS = 6;
const LONG_STEP_MS = 20;
/** Most texels that a view or a map is copied in at once: bounds the scratch memory inside the module. */
const COPY_TEXELS = 1 << 22;
/** What is projected between two looks at the time, in texels about: some hundred dabs, a fraction of a second on a slow phone. */
const PROJECTED_AT_ONCE = 1 << 19;

export interface OpenTargetContext {
  readonly session: Session;
  readonly model: LoadedModel;
  readonly onProgress: ((share: number) => void) | undefined;
  /** Called between steps; throws when the work shall end. */
  readonly checkpoint: () => void;
}

/** A target that is a window of a larger texture, as prints are made. */
export interface TextureWindow {
  /** Texels of the whole texture. */
  readonly textureWidth: number;
  readonly textureHeight: number;
  /** Where in it the target begins; multiples of 16. */
  readonly windowX: number;
  readonly windowY: number;
  /** Decoded once for all windows. */
  readonly base: BasePicture;
  /** Of the whole texture: a drawing must get the same pixels in all windows. */
  readonly raster: RasterTarget;
}

/** The pictures of layers. */
export interface TargetPictures {
  /** Undefined while it is unknown: its layers wait. */
  readonly imageOf: (asset: string) => ImageHandle | undefined;
  /** Gives drawings and words the keys of images that were drawn for this target. */
  readonly resolve: (layers: readonly EngineLayer[], target: () => RasterTarget) => readonly EngineLayer[];
  /** The session's zones, and what cuts layers off at them; null: none. */
  readonly clipping: { readonly zones: PrintZones; readonly Clip: typeof ZoneClip } | null;
}

export class OpenTarget {
  readonly info: TargetInfo;
  /** The base holds the material's base colour factor. */
  readonly factorBaked: boolean;
  /** Why the newest layers could not be drawn: what is asked for is refused with it, as it would show older ones. */
  fault: TexelcastError | null = null;
  /** How often in a row `draw` came to its end before all was projected. */
  turns = 0;
  readonly #target: Target;
  readonly #layers: LayerSync;
  readonly #makeClip: (Clip: typeof ZoneClip) => ZoneClip;
  #clip: ZoneClip | null = null;
  #raster: RasterTarget | null;

  private constructor(
    session: Session,
    target: Target,
    info: TargetInfo,
    factorBaked: boolean,
    window: TextureWindow | null,
    model: string,
  ) {
    this.#target = target;
    this.info = info;
    this.factorBaked = factorBaked;
    this.#raster = window?.raster ?? null;
    this.#makeClip = (Clip) => new Clip(session, target, info, window);
    const triangles = new FillTriangles(() => session.materialUvs(info.material), model);
    this.#layers = new LayerSync(target, (layer) => {
      if (layer.type === "stroke") return { ...NO_DETAILS, dabs: layer.dabs };
      if (layer.type !== "fill") return NO_DETAILS;
      const { gradient, parts } = layer;
      return {
        ...NO_DETAILS,
        gradient: gradient ? coreGradient(gradient) : null,
        triangles: parts ? triangles.of(parts) : null,
      };
    });
  }

  /** Makes a target, sets its base and bakes it in steps. When it throws, nothing is left of it. */
  static async open(
    options: TargetOptions,
    context: OpenTargetContext,
    window: TextureWindow | null = null,
  ): Promise<OpenTarget> {
    const { session, model, checkpoint } = context;
    checkpoint();
    // Refuses materials that cannot be painted, before their picture is decoded for nothing.
    const { paintStatus } = session.materialInfo(options.material);
    if (!session.core.isOk(paintStatus)) {
      throw session.core.statusError(paintStatus, "", { subject: model.name, field: `materials[${options.material}]` });
    }
    const [width, height] = await targetSize(model, options);
    checkInteger("material", options.material);
    checkInteger("width", width);
    checkInteger("height", height);
    if (options.gutter !== undefined) checkInteger("gutter", options.gutter);
    const base = window?.base ?? (await loadBasePicture(model, options));
    checkpoint();
    const target = session.createTarget({
      material: options.material,
      width,
      height,
      gutter: options.gutter ?? NONE,
      mipLevels: options.mipmaps ? 0 : 1,
      ...(window !== null && {
        textureWidth: window.textureWidth,
        textureHeight: window.textureHeight,
        windowX: window.windowX,
        windowY: window.windowY,
      }),
    });
    try {
      applyBase(target, base);
      await bake(target, context);
      const info = targetInfo(options.material, target.info());
      return new OpenTarget(session, target, info, base.factorBaked, window, model.name);
    } catch (error) {
      if (!session.core.crashed) target.destroy();
      throw error;
    }
  }

  destroy(): void {
    this.#target.destroy();
    this.forgetImages();
  }

  /** Gives back what the target keeps in the session beside itself: for one that ended with its model. */
  forgetImages(): void {
    this.#clip?.forget();
  }

  /** What decides how many pixels a drawing gets here. */
  get raster(): RasterTarget {
    if (this.#raster === null) {
      const { width, height, boundsMin, boundsMax } = this.info;
      const density = texelsPerMetre({
        width,
        height,
        readPositions: (row, count) => this.#target.readPositions(row, count),
        readCoverage: (row, count) => this.#target.readCoverage(row, count),
      });
      // A target without an area has no place where a drawing could be seen.
      this.#raster = { width, height, boundsMin, boundsMax, texelsPerMetre: density ?? 0 };
    }
    return this.#raster;
  }

  /**
   * Draws the layers of this material; null when no texel changed. What is not projected when `until` has come
   * (`performance.now`) is left to the next call. The picture stays as it was in the meantime, but for the second turn, the
   * fourth, the eighth and so on: after those it has the layers that are there so far, from the bottom up.
   */
  draw(
    layers: readonly EngineLayer[],
    revision: number,
    pictures: TargetPictures,
    report: (error: TexelcastError) => void,
    until: number,
  ): TargetUpdate | null {
    const start = performance.now();
    const { material } = this.info;
    const own = layersOnMaterial(layers, material);
    const drawn = pictures.resolve(own, () => this.raster);
    const { clipping } = pictures;
    if (clipping !== null) this.#clip ??= this.#makeClip(clipping.Clip);
    const { layers: clipped, imageOf } = this.#clip?.apply(drawn, clipping?.zones ?? null, pictures.imageOf) ?? {
      layers: drawn,
      imageOf: pictures.imageOf,
    };
    this.#layers.apply(clipped, { imageOf, report });
    let update: CoreUpdate;
    do update = this.#target.update(undefined, PROJECTED_AT_ONCE);
    while (update.unfinished && performance.now() < until);
    this.turns = update.unfinished ? this.turns + 1 : 0;
    // To composite and upload the whole picture at each would cost as much as it has layers.
    if (this.turns > 1 && (this.turns & (this.turns - 1)) === 0) {
      update = { ...this.#target.update(undefined, 0), projectedTexels: update.projectedTexels };
    }
    if (update.rects.length === 0) return null;
    return { material, revision, ...update, milliseconds: performance.now() - start };
  }

  /**
   * Gets ready for a change, on at most `tileCount` tiles from `firstTile` on. Returns the tile to go on with; null when there
   * is no more to do.
   */
  prepare({ id, inside }: ExpectedChange, firstTile: number, tileCount: number): number | null {
    const layer = this.#layers.handleOf(id);
    return layer === undefined ? null : this.#target.prepareLayer(layer, inside, firstTile, tileCount);
  }

  /** What a layer paints here, or its mask; null where it is not, and nothing of it is to be seen. */
  miniature(id: string, of: "layer" | "mask", side: number): Uint8Array<ArrayBuffer> | null {
    const layer = this.#layers.handleOf(id);
    if (layer === undefined) return null;
    this.checkDrawn();
    const rgba = this.#target.layerMiniature(layer, of === "mask", side);
    return rgba.some((value) => value > 0) ? rgba : null;
  }

  /** The core's layer of that id, once it was drawn; undefined where it is not on this material. */
  handleOf(id: string): LayerHandle | undefined {
    return this.#layers.handleOf(id);
  }

  checkDrawn(): void {
    if (this.fault !== null) throw this.fault;
  }

  /** For measurements of the surface and the print. */
  get core(): Target {
    return this.#target;
  }

  read(x: number, y: number, width: number, height: number): Uint8Array<ArrayBuffer> {
    this.checkDrawn();
    this.#checkRegion(x, y, width, height);
    return this.#target.read(0, x, y, width, height);
  }

  /** The whole texture as of the newest `draw`, as it is exported: with colour bled beyond the gutter. */
  exportedPicture(): Picture {
    this.checkDrawn();
    return this.picture((row, count) => this.#target.readBled(row, count, this.info.width));
  }

  hash(x: number, y: number, width: number, height: number): string {
    this.checkDrawn();
    this.#checkRegion(x, y, width, height);
    return this.#target.hash(x, y, width, height);
  }

  /** Of the target's size, by its rows. */
  picture(read: (row: number, count: number) => Uint8Array): Picture {
    const { width, height } = this.info;
    const rgba = new Uint8Array(width * height * 4);
    const rowsAtOnce = Math.max(1, Math.floor(COPY_TEXELS / width));
    for (let row = 0; row < height; row += rowsAtOnce) {
      rgba.set(read(row, Math.min(rowsAtOnce, height - row)), row * width * 4);
    }
    return { width, height, rgba };
  }

  #checkRegion(x: number, y: number, width: number, height: number): void {
    const inside =
      [x, y, width, height].every((value) => Number.isInteger(value) && value >= 0) &&
      x + width <= this.info.width &&
      y + height <= this.info.height;
    if (inside) return;
    const value = `${x}, ${y}, ${width} × ${height}`;
    const texture = `${this.info.width} × ${this.info.height}`;
    throw new TexelcastError("bad-argument", `The region ${value} does not lie in the ${texture} texture.`, {
      field: "region",
      value,
    });
  }
}

async function bake(target: Target, { onProgress, checkpoint }: OpenTargetContext): Promise<void> {
  for (let workLimit = FIRST_STEP; ; ) {
    const start = performance.now();
    const { done, progress } = target.bake(workLimit);
    onProgress?.(done ? 1 : progress);
    if (done) return;
    const milliseconds = performance.now() - start;
    if (milliseconds < SHORT_STEP_MS) workLimit *= 2;
    else if (milliseconds > LONG_STEP_MS) workLimit = Math.max(FIRST_STEP >> 4, workLimit >> 1);
    await nextTurn();
    checkpoint();
  }
}

/** The ABI takes 32-bit whole numbers; 1.5 or -1 would silently become another one. */
function checkInteger(field: string, value: number): void {
  if (Number.isInteger(value) && value >= 0 && value <= 0xffffffff) return;
  throw new TexelcastError("bad-argument", `“${field}” must be a whole number from 0, not ${value}.`, {
    field,
    value: String(value),
  });
}

function targetInfo(material: number, map: MapInfo): TargetInfo {
  return {
    material,
    width: map.width,
    height: map.height,
    gutter: map.gutter,
    mipLevels: map.mipLevels,
    coveredTexels: map.coveredTexels,
    gutterTexels: map.gutterTexels,
    overlappingTexels: map.overlappingTexels,
    mapBytes: map.byteCount,
    boundsMin: vec3(map.boundsMinModel),
    boundsMax: vec3(map.boundsMaxModel),
  };
}

/** The first three numbers, 0 for what is missing. */
export function vec3(numbers: readonly number[]): Vec3 {
  return [numbers[0] ?? 0, numbers[1] ?? 0, numbers[2] ?? 0];
}
