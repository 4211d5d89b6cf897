/**
 * What the engine offers to the rooms above it: plain data and one interface. The same interface is served by the
 * worker's client (browser) and by the host itself (Node), so the page and the command line run the same engine.
 */

import type { BlendMode } from "./blend-modes.ts";
import type { EnginePicture, EngineText, TextMeasure } from "./engine-text.ts";
import type { LayerMaterials } from "./layer-materials.ts";
import type { PrintFile, PrintFileOptions, PrintMapKind, PrintReport } from "./print-report.ts";
import type { PrintZones } from "./print-zones.ts";

export type { BlendMode } from "./blend-modes.ts";
export type { EnginePicture, EngineText, TextMeasure } from "./engine-text.ts";

/** A model's bytes with the side files that its `.gltf` names (relative address to bytes), or a zip that has all of it. */
export interface ModelSource {
  /**
   * File name as the user knows it; errors name it. Of a zip with several models it chooses one: "pack.zip#robot/scene.gltf". Of a
   * model with variants of its materials it chooses one, too: "shoe.glb#variant=street".
   */
  readonly name: string;
  readonly bytes: Uint8Array;
  readonly resources?: ReadonlyMap<string, Uint8Array>;
}

export type Vec3 = readonly [number, number, number];
export type Quaternion = readonly [number, number, number, number];

/** spec.md, 3: lengths in metres, model space; rotation x, y, z, w. */
export interface PlanarProjector {
  readonly kind: "planar";
  readonly position: Vec3;
  readonly rotation: Quaternion;
  readonly size: Vec3;
}

/** spec.md, 3: the eye looks along its own -Z; `fov` vertical, degrees; `near` and `far` metres. */
export interface PerspectiveProjector {
  readonly kind: "perspective";
  readonly position: Vec3;
  readonly rotation: Quaternion;
  readonly fov: number;
  /** Width by height. */
  readonly aspect: number;
  readonly near: number;
  readonly far: number;
}

/** spec.md, 3: the axis is the box's Y; lengths metres, `arc` degrees up to 360. */
export interface CylindricalProjector {
  readonly kind: "cylindrical";
  readonly position: Vec3;
  readonly rotation: Quaternion;
  readonly radius: number;
  readonly height: number;
  readonly arc: number;
  readonly depth: number;
}

/** spec.md, 3: a flat stamp in the texture; `center` and `size` in u and v, `angle` degrees clockwise. */
export interface UvProjector {
  readonly kind: "uv";
  readonly center: readonly [number, number];
  readonly size: readonly [number, number];
  readonly angle: number;
}

export type Projector = PlanarProjector | PerspectiveProjector | CylindricalProjector | UvProjector;

interface EngineLayerBase {
  /** Unique among all layers, those in groups and masks included. */
  readonly id: string;
  readonly visible: boolean;
  /** 0 to 1. */
  readonly opacity: number;
  readonly blend: BlendMode;
  readonly blendSpace: "srgb" | "linear";
  /** The target's alpha stays as it was. */
  readonly lockAlpha: boolean;
  /** Without it, the layer shows everywhere. */
  readonly mask?: EngineMask | null;
}

/**
 * Layers composited onto alpha 1, bottom to top: the alpha that comes out (or 1 less it) multiplies what the masked layer
 * paints.
 */
export interface EngineMask {
  readonly layers: readonly EngineLayer[];
  readonly invert: boolean;
}

/** What paints by itself, as against a group. */
interface EnginePaintingLayer extends EngineLayerBase {
  /** glTF material index, or several: a decal that crosses from one material to another paints both. */
  readonly material: LayerMaterials;
}

/** sRGB with alpha, each 0 to 1. */
export type EngineColor = readonly [number, number, number, number];

/** A layer whose pictures are thrown at the surface. */
interface EngineCastLayer extends EnginePaintingLayer {
  readonly filter: "linear" | "nearest";
  readonly wrap: "none" | "repeat";
  readonly flipX: boolean;
  readonly flipY: boolean;
  readonly backfaces: boolean;
  /** Degrees, start to end, 0 to 90. */
  readonly angleFade: readonly [number, number];
  readonly occlusion: "self" | "none";
}

export interface EngineDecalLayer extends EngineCastLayer {
  readonly type: "decal";
  readonly asset: EnginePicture;
  readonly projector: Projector;
}

export interface EngineGradientStop {
  /** 0 to 1. */
  readonly offset: number;
  readonly color: EngineColor;
}

/** Colours by the place on the model (metres, model space); 2 to 16 stops whose offsets do not fall. */
export type EngineGradient =
  | { readonly kind: "linear"; readonly from: Vec3; readonly to: Vec3; readonly stops: readonly EngineGradientStop[] }
  | {
      readonly kind: "radial";
      readonly center: Vec3;
      readonly radius: number;
      readonly stops: readonly EngineGradientStop[];
    };

/** Triangles of the layer's one material, counted as `Engine.uvTriangles` gives them; a chart by any of its own. */
export type EngineParts =
  | { readonly kind: "charts"; readonly charts: readonly number[] }
  | { readonly kind: "faces"; readonly faces: readonly number[] };

export interface EngineFillLayer extends EnginePaintingLayer {
  readonly type: "fill";
  readonly color: EngineColor;
  /** Takes the colour's place. */
  readonly gradient?: EngineGradient | null;
  /** Without them, everywhere. */
  readonly parts?: EngineParts | null;
}

export interface EngineRoundBrush {
  readonly tip: "round";
  readonly color: EngineColor;
  /** The share of the radius that is solid, 0 to 1. */
  readonly hardness: number;
  /** What share of the tip's alpha a dab lays down, 0 to 1. */
  readonly flow: number;
}

export interface EnginePictureBrush {
  readonly tip: "picture";
  readonly asset: EnginePicture;
  /** Paints the picture's alpha in this colour; null: the picture as it is. */
  readonly color: EngineColor | null;
  readonly flow: number;
}

export type EngineBrush = EngineRoundBrush | EnginePictureBrush;

/** One touch of a brush: where it comes from, and its share of the brush's flow, 0 to 1 (a pen's pressure). */
export type EngineDab = Projector & {
  readonly flow: number;
  /** Turns the layer's `flipX` round for this dab; default false. */
  readonly flipX?: boolean;
};

/** A brush's dabs lie over each other by their flow; opacity and blend are the whole's. */
export interface EngineStrokeLayer extends EngineCastLayer {
  readonly type: "stroke";
  readonly brush: EngineBrush;
  /**
   * In order. A list that begins with the objects of the list before costs only what is new in it: neither are the others
   * sent to the worker again, nor painted.
   */
  readonly dabs: readonly EngineDab[];
}

/** Layers treated as one. */
export interface EngineGroupLayer extends EngineLayerBase {
  readonly type: "group";
  /** Bottom to top. */
  readonly layers: readonly EngineLayer[];
  /**
   * Composited by themselves first. Not isolated and of blend "normal", they are composited onto what is below, and opacity
   * and mask say how much of that shows.
   */
  readonly isolated: boolean;
}

/** A layer with every field set: the design document's defaults are already filled in. */
export type EngineLayer = EngineDecalLayer | EngineStrokeLayer | EngineFillLayer | EngineGroupLayer;

export interface MaterialInfo {
  readonly index: number;
  /** As in the file; "" without one. */
  readonly name: string;
  /** Null when the material can take decals, else why not: an error code ("no-uvs", "no-triangles", …) and what it means. */
  readonly refusal: { readonly code: string; readonly message: string } | null;
  readonly triangles: number;
  readonly degenerateUvTriangles: number;
  readonly outOfRangeUvTriangles: number;
  readonly texCoord: number;
  /** Pixels of the base colour picture, as its header says; null without a picture. */
  readonly textureSize: readonly [number, number] | null;
  readonly uvMin: readonly [number, number];
  readonly uvMax: readonly [number, number];
  readonly boundsMin: Vec3;
  readonly boundsMax: Vec3;
}

export interface ModelInfo {
  readonly name: string;
  readonly triangles: number;
  readonly vertices: number;
  readonly boundsMin: Vec3;
  readonly boundsMax: Vec3;
  readonly materials: readonly MaterialInfo[];
  /**
   * The model as an uncompressed, self-contained GLB (side files packed in, Draco and meshopt undone, a base colour texture's EXIF
   * hidden from browsers, which would turn it): what a viewer can load.
   */
  readonly glb: Uint8Array<ArrayBuffer>;
}

export interface TargetOptions {
  readonly material: number;
  /** Texels, 1 to 8192. Without them: the base picture's own size, 1024 x 1024 where there is none. */
  readonly width?: number;
  readonly height?: number;
  /** Texels, 0 to 64; spec.md, 2 by default. */
  readonly gutter?: number;
  /**
   * "model" (default): the material's own picture or colour. Else a colour (sRGB with alpha, each 0 to 1), or a picture's
   * bytes (PNG, JPEG, WebP, AVIF).
   */
  readonly base?:
    | "model"
    | readonly [number, number, number, number]
    | { readonly name: string; readonly bytes: Uint8Array };
  /** Report the whole mip chain in updates (for a GPU); default false. */
  readonly mipmaps?: boolean;
}

export interface TargetInfo {
  readonly material: number;
  readonly width: number;
  readonly height: number;
  readonly gutter: number;
  readonly mipLevels: number;
  readonly coveredTexels: number;
  readonly gutterTexels: number;
  readonly overlappingTexels: number;
  readonly mapBytes: number;
  readonly boundsMin: Vec3;
  readonly boundsMax: Vec3;
}

/** Texels of its level; `byteOffset` into the update's `bytes`, rows packed, RGBA. */
export interface DirtyRect {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly level: number;
  readonly byteOffset: number;
}

/** What changed in one target. `bytes` belongs to the receiver. */
export interface TargetUpdate {
  readonly material: number;
  /**
   * The revision that the design was given with in `setLayers`: tells which transform this picture shows. A design that takes
   * seconds is shown in parts before, from the bottom up.
   */
  readonly revision: number;
  readonly rects: readonly DirtyRect[];
  readonly bytes: Uint8Array;
  readonly projectedLayers: number;
  readonly projectedTexels: number;
  readonly compositedTexels: number;
  /** Time the engine spent, milliseconds. */
  readonly milliseconds: number;
}

/** Which layer will probably change next: it is selected, or under the pointer. */
export interface ExpectedChange {
  readonly id: string;
  /** What is put on top in it (it is a group) or changes its mask, and not the layer itself. */
  readonly inside: boolean;
}

export type MapView = "positions" | "normals" | "coverage" | "overlap";

/** Straight-alpha RGBA, row 0 at the top. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8Array;
}

export interface EngineStats {
  readonly bakeCount: number;
  readonly projectionCount: number;
  readonly memoryUsedBytes: number;
  readonly memoryPeakBytes: number;
  readonly memoryBudgetBytes: number;
}

export interface Engine {
  /** Loads a model in place of the one before; a failed load keeps the old one. Rejects with a TexelcastError. */
  loadModel(source: ModelSource): Promise<ModelInfo>;

  /**
   * Decodes a decal's picture (PNG, JPEG, WebP, AVIF) or reads a drawing (SVG), and keeps it under `key`; replaces one of the same
   * key. Returns its size. A drawing gets its pixels when it is painted, as many as its place on the target asks for.
   */
  setAsset(
    key: string,
    asset: { readonly name: string; readonly bytes: Uint8Array },
  ): Promise<{ width: number; height: number }>;
  /** Takes away the picture or the font of a key. */
  removeAsset(key: string): Promise<void>;

  /**
   * Takes in a font for texts (TrueType, OpenType) and keeps it under `key`; replaces one of the same key. Returns its name as
   * the file tells it, "" without one. Rejects with "bad-font".
   */
  setFont(key: string, font: { readonly name: string; readonly bytes: Uint8Array }): Promise<{ readonly name: string }>;
  /** How much room a text asks for. Rejects where its font is not there. */
  measureText(text: EngineText): Promise<TextMeasure>;

  /**
   * Bakes (or reuses) the map of a material and makes its target; replaces that material's target of another size.
   * `onProgress`: 0 to 1. An aborted signal rejects with an AbortError-like TexelcastError of code "cancelled" and
   * leaves the old target. The first update of a target reports every texel.
   */
  openTarget(options: TargetOptions, onProgress?: (share: number) => void, signal?: AbortSignal): Promise<TargetInfo>;
  closeTarget(material: number): Promise<void>;

  /**
   * All layers of all materials, bottom to top. Returns at once; updates arrive by `onUpdate`. Latest wins: a list that
   * is still waiting when a newer one comes is dropped. Layers that refer to unknown assets or fonts, or materials without an
   * open target are kept and drawn when those appear.
   */
  setLayers(layers: readonly EngineLayer[], revision: number): void;
  /**
   * Makes the first steps of a change that is likely to come as quick as those after it: what lies below the layer is kept
   * ready, in pauses of other work. Null: nothing in particular is expected. Returns at once; changes no texel.
   */
  expect(change: ExpectedChange | null): void;
  /**
   * Called after each change, one call per changed target. Returns an unsubscribe function. What a listener throws, of this or of
   * `onError`, is the rejection of a promise that nobody handles; the others are told all the same.
   */
  onUpdate(listener: (update: TargetUpdate) => void): () => void;
  /** Faults outside a call of the user's (the engine crashed, a layer was refused, a target could not be drawn). */
  onError(listener: (error: Error) => void): () => void;

  /**
   * Resolves when everything asked so far has been computed and reported. Rejects while a target cannot be drawn as its layers
   * ask ("out-of-budget"), as does all that would show that target; the others are not concerned.
   */
  idle(): Promise<void>;

  /** A map's view as a picture, for people to look at. */
  viewMap(material: number, view: MapView): Promise<Picture>;
  /** Six numbers (u, v of three corners) a triangle, as the model has them (may lie outside 0 to 1). */
  uvTriangles(material: number): Promise<Float32Array>;
  /** Texels of the target, RGBA straight alpha. */
  readTexels(material: number, x: number, y: number, width: number, height: number): Promise<Uint8Array<ArrayBuffer>>;
  /**
   * A small picture of what a layer paints, or of its mask (white where that shows the layer): the square of the first target
   * around it, `side` x `side` pixels (1 to 256), RGBA straight alpha. Null where nothing of it is to be seen. For lists of
   * layers: opacity, mode and mask of the layer itself are left out.
   */
  layerMiniature(id: string, of: "layer" | "mask", side: number): Promise<Uint8Array<ArrayBuffer> | null>;
  /** 64-bit FNV-1a over a region's bytes, 16 hex digits; the whole target without a region. */
  hash(material: number, region?: { x: number; y: number; width: number; height: number }): Promise<string>;

  /** The finished texture as PNG. */
  exportPng(material: number): Promise<Uint8Array<ArrayBuffer>>;
  /**
   * The model with the textures of its open targets inside, or of those of them that paint `materials`; all else of the file
   * stays as it was.
   */
  exportGlb(materials?: readonly number[]): Promise<Uint8Array<ArrayBuffer>>;
  /**
   * The same as USDZ, for augmented reality on iPhones and iPads: the model at rest, without animations, cameras and lights. Its
   * pictures are PNG and JPEG, those that are painted with the texels of `exportPng`. Rejects with "bad-picture" for one of the
   * model's own in another format that cannot be read.
   */
  exportUsdz(materials?: readonly number[]): Promise<Uint8Array<ArrayBuffer>>;

  /**
   * Where the product may be printed; null: everywhere. Layers are cut off at zones of the policy "clip" from now on, in
   * updates and in all that is exported. Rejects with "bad-argument".
   */
  setZones(zones: PrintZones | null): Promise<void>;
  /** What becomes of each layer on the surface. Materials that are not open are measured at their own size. */
  printReport(): Promise<PrintReport>;
  /** The decals' density or stretch on a material, as a picture in its texture's form: red is bad, green good, clear no decal. */
  printMap(material: number, kind: PrintMapKind): Promise<Picture>;
  /**
   * A print file: the newest layers drawn by themselves at the size that is asked for, whatever is open. The same bytes in
   * the page and in Node. Rejects with "bad-argument", "bad-size", "bad-zones", "out-of-budget", "cancelled".
   */
  exportPrint(
    options?: PrintFileOptions,
    onProgress?: (share: number) => void,
    signal?: AbortSignal,
  ): Promise<PrintFile>;

  stats(): Promise<EngineStats>;
  /** Ends the engine; every later call rejects with code "disposed". */
  dispose(): void;
}
