/**
 * The design document: the recipe that the editor edits, files hold and the engine replays (spec.md, 8). Plain data;
 * every type here has all its fields set, because reading a file fills in the defaults (`parseDesign`).
 */
import type { BlendMode } from "../../engine/blend-modes.ts";
import type {
  CylindricalProjector,
  PerspectiveProjector,
  PlanarProjector,
  Projector,
  Quaternion,
  UvProjector,
  Vec3,
} from "../../engine/engine-api.ts";
import type { LayerMaterials } from "../../engine/layer-materials.ts";

export { BLEND_MODES, type BlendMode } from "../../engine/blend-modes.ts";

export const DESIGN_FORMAT = "texelcast-design";
export const DESIGN_VERSION = 1;

export const BLEND_SPACES = ["srgb", "linear"] as const;
export const FILTERS = ["linear", "nearest"] as const;
export const WRAPS = ["none", "repeat"] as const;
export const OCCLUSIONS = ["self", "none"] as const;
export const MIRROR_AXES = ["x", "y", "z"] as const;
export const PICTURE_TYPES = ["image/png", "image/jpeg", "image/webp", "image/avif", "image/svg+xml"] as const;
export const ALIGNS = ["left", "center", "right"] as const;
export const FONT_TYPES = ["font/ttf", "font/otf"] as const;

export type BlendSpace = (typeof BLEND_SPACES)[number];
export type Filter = (typeof FILTERS)[number];
export type Wrap = (typeof WRAPS)[number];
export type Occlusion = (typeof OCCLUSIONS)[number];
export type Align = (typeof ALIGNS)[number];
export type AssetType = (typeof PICTURE_TYPES)[number] | (typeof FONT_TYPES)[number];

export { layerMaterials, materialsOf, paintsMaterial } from "../../engine/layer-materials.ts";
export type {
  CylindricalProjector,
  LayerMaterials,
  PerspectiveProjector,
  PlanarProjector,
  Projector,
  Quaternion,
  UvProjector,
  Vec3,
};

/** What every layer has. */
export interface LayerBase {
  /** Unique within the design. */
  readonly id: string;
  readonly name: string;
  /** glTF material index, or a list of different ones, all of which the layer paints. */
  readonly material: LayerMaterials;
  readonly visible: boolean;
  /** 0 to 1. */
  readonly opacity: number;
  readonly blend: BlendMode;
  readonly blendSpace: BlendSpace;
  readonly lockAlpha: boolean;
  /** The editor refuses to change it; what is painted is the same. */
  readonly locked: boolean;
  /** Null: the layer shows everywhere. */
  readonly mask: Mask | null;
}

/**
 * What of a layer shows. A mask begins with alpha 1 everywhere; its layers are composited onto that like any, bottom to
 * top, and the alpha which comes out multiplies what the masked layer paints. A stroke with blend "erase" hides, a normal
 * one shows again; what colour it has does not matter. Of their `material` only what lies in the texture itself takes notice
 * (`resolveLayers`); the others reach whatever the masked layer paints.
 */
export interface Mask {
  readonly layers: readonly MaskLayer[];
  /** One minus the alpha instead. */
  readonly invert: boolean;
  /** In the editor, what is in the mask of a decal, a text or a group goes along when that is moved, turned or sized. */
  readonly linked: boolean;
}

/** Paints a layer a second time, as a mirror across a plane of the model shows it. */
export interface Mirror {
  /** What the plane is square to, in model space. */
  readonly axis: (typeof MIRROR_AXES)[number];
  /** Where on that axis the plane stands, metres. */
  readonly offset: number;
  /** Only the place is mirrored; the picture is not, so that words can be read. */
  readonly readable: boolean;
}

/** What every layer has whose paint is thrown at the surface: which texels it reaches (spec.md, 4). */
export interface ProjectedLayer extends LayerBase {
  readonly backfaces: boolean;
  /** Degrees; 0 <= start <= end <= 90. */
  readonly angleFade: readonly [number, number];
  readonly occlusion: Occlusion;
}

/** What every layer has that throws a picture: how the picture is read. */
export interface PictureLayer extends ProjectedLayer {
  readonly filter: Filter;
  readonly wrap: Wrap;
  readonly flipX: boolean;
  readonly flipY: boolean;
}

export interface DecalLayer extends PictureLayer {
  readonly type: "decal";
  /** Key in the design's `assets`. */
  readonly asset: string;
  readonly projector: Projector;
  /** Null for a "uv" projector, which lies on no side of the model. */
  readonly mirror: Mirror | null;
}

/** A decal whose picture is written words. */
export interface TextLayer extends PictureLayer {
  readonly type: "text";
  /** Line feeds part lines. */
  readonly text: string;
  /** Key of a font in the design's `assets`. */
  readonly font: string;
  /** Height of the font's em as a share of the box's height, above 0; the engine takes less where the text would not fit. */
  readonly fontSize: number;
  /** Between letters, em. */
  readonly letterSpacing: number;
  /** Of the lines among each other, and of the text in its box. */
  readonly align: Align;
  /** Degrees of the arc that the longest line spans: 0 straight, above 0 an arch, below 0 a bowl; -360 to 360. */
  readonly curve: number;
  /** "#rrggbb" or "#rrggbbaa". */
  readonly color: string;
  /** `width`: how far it reaches out from the letters, as a share of the em; null without an outline. */
  readonly outline: { readonly color: string; readonly width: number } | null;
  readonly projector: Projector;
  /** As a decal's. */
  readonly mirror: Mirror | null;
}

/** A disc as wide as the dab. */
export interface RoundBrush {
  readonly tip: "round";
  /** "#rrggbb" or "#rrggbbaa", sRGB. */
  readonly color: string;
  /** The share of the radius that is solid: 0 (soft to the middle) to 1 (sharp edge). */
  readonly hardness: number;
  /** What share of the tip's alpha a dab lays down, 0 to 1. */
  readonly flow: number;
}

export interface PictureBrush {
  readonly tip: "picture";
  /** Key in the design's `assets`. */
  readonly asset: string;
  /** Paints the picture's alpha in this colour; null: the picture as it is. */
  readonly color: string | null;
  readonly flow: number;
}

export type Brush = RoundBrush | PictureBrush;

/** One touch of a brush: where it comes from, and its share of the brush's flow, 0 to 1 (a pen's pressure). */
export type Dab = Projector & { readonly flow: number };

/** A brush drawn over the surface. Dabs build up by their flow; opacity and blend are the whole stroke's. */
export interface StrokeLayer extends PictureLayer {
  readonly type: "stroke";
  readonly brush: Brush;
  /** In order. */
  readonly dabs: readonly Dab[];
  /** Each dab's mirrored twin follows it, so that opacity does not build up. Null where a dab is of kind "uv". */
  readonly mirror: Mirror | null;
}

/** A colour at a place of a gradient; `offset` 0 to 1. */
export interface GradientStop {
  readonly offset: number;
  /** "#rrggbb" or "#rrggbbaa", sRGB. */
  readonly color: string;
}

/** Colours by the place on the model: model space, metres. Stops are 2 to 16, their offsets do not fall. */
export type Gradient =
  | { readonly kind: "linear"; readonly from: Vec3; readonly to: Vec3; readonly stops: readonly GradientStop[] }
  | {
      readonly kind: "radial";
      readonly center: Vec3;
      readonly radius: number;
      readonly stops: readonly GradientStop[];
    };

/**
 * Some of a material's triangles, counted as `Engine.uvTriangles` gives them. A chart is what hangs together by shared
 * corners in the unfolded texture, and goes by the lowest index of its triangles; `charts` may name it by any of them.
 */
export type Parts =
  | { readonly kind: "charts"; readonly charts: readonly number[] }
  | { readonly kind: "faces"; readonly faces: readonly number[] };

/** One colour, or a gradient, over the whole target or parts of it. */
export interface FillLayer extends LayerBase {
  readonly type: "fill";
  /** "#rrggbb" or "#rrggbbaa", sRGB. A gradient takes its place. */
  readonly color: string;
  readonly gradient: Gradient | null;
  /** Null: everywhere. Not null only where `material` is one. */
  readonly parts: Parts | null;
}

/** Layers that are treated as one. Its own `material` means nothing: those in it have theirs. */
export interface GroupLayer extends LayerBase {
  readonly type: "group";
  /** Bottom to top. */
  readonly layers: readonly DesignLayer[];
  /**
   * Its layers are composited among themselves, and what comes out is then laid on what is below. Not isolated and of blend
   * "normal", they are composited onto what is below, one by one; opacity and mask then say how much of that shows.
   */
  readonly isolated: boolean;
}

/** What the brush paints on: strokes in one isolated group, so that an eraser takes away from it alone. */
export interface PaintLayer extends LayerBase {
  readonly type: "paint";
  /** Bottom to top, one for each gesture. */
  readonly strokes: readonly StrokeLayer[];
  /** Of all its strokes, besides their own. */
  readonly mirror: Mirror | null;
}

/** What lies where its projector is: a picture, or words. */
export type PlacedLayer = DecalLayer | TextLayer;
export type MaskLayer = PlacedLayer | StrokeLayer | FillLayer;
export type DesignLayer = MaskLayer | GroupLayer | PaintLayer;

/** File endings of what a design names. */
export const ASSET_ENDINGS: Readonly<Record<AssetType, string>> = {
  "image/png": "png",
  "image/jpeg": "jpg",
  "image/webp": "webp",
  "image/avif": "avif",
  "image/svg+xml": "svg",
  "font/ttf": "ttf",
  "font/otf": "otf",
};

export interface DesignAsset {
  readonly type: AssetType;
  /**
   * A `data:` URI, an https address, an address relative to the design's own place, or that of a font which comes with
   * Texelcast, "texelcast:fonts/inter-700".
   */
  readonly uri: string;
}

export interface Design {
  readonly format: typeof DESIGN_FORMAT;
  readonly version: typeof DESIGN_VERSION;
  readonly assets: Readonly<Record<string, DesignAsset>>;
  /** Bottom to top. */
  readonly layers: readonly DesignLayer[];
}

/** The defaults of spec.md, 8, that do not hang on the layer's place in the list. */
export const LAYER_DEFAULTS = {
  material: 0,
  visible: true,
  opacity: 1,
  blend: "normal",
  blendSpace: "srgb",
  lockAlpha: false,
  locked: false,
  mask: null,
} as const;

export const MASK_DEFAULTS = { invert: false, linked: true } as const;
export const MIRROR_DEFAULTS = { offset: 0, readable: false } as const;
export const GROUP_DEFAULTS = { isolated: false } as const;

export const PROJECTED_DEFAULTS = {
  backfaces: false,
  angleFade: [70, 90],
  occlusion: "self",
} as const;

export const PICTURE_DEFAULTS = {
  filter: "linear",
  wrap: "none",
  flipX: false,
  flipY: false,
} as const;

export const TEXT_DEFAULTS = {
  fontSize: 1,
  letterSpacing: 0,
  align: "center",
  curve: 0,
  color: "#000000",
  outline: null,
} as const;

export const BRUSH_DEFAULTS = { color: "#000000", hardness: 1, flow: 1 } as const;

/** Whether a layer lies where its projector is; what is not there does not. */
export const isPlaced = (layer: DesignLayer | null | undefined): layer is PlacedLayer =>
  layer?.type === "decal" || layer?.type === "text";

/** A design without assets and layers. */
export function emptyDesign(): Design {
  return { format: DESIGN_FORMAT, version: DESIGN_VERSION, assets: {}, layers: [] };
}

/** The least number from `start` on whose id "layer-N" none of `taken` uses. */
export function freeLayerNumber(taken: ReadonlySet<string>, start: number): number {
  let number = start;
  while (taken.has(layerIdOf(number))) number += 1;
  return number;
}

/** "layer-7": the form of the ids that are made up. */
export const layerIdOf = (number: number): string => `layer-${number}`;
