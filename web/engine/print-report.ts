/**
 * Print truth: what becomes of each layer on the surface, measured on the baked map (docs/print-truth.md has the definitions
 * and formulas). Plain data, the same in the page, in Node and in `texelcast check --json`.
 */
import type { EngineLayer } from "./engine-api.ts";

/** What can be measured of a layer, and of all together. Shares are 0 to 1. */
export interface PrintMeasures {
  /**
   * Pixels an inch of printed surface, along the axis on which the picture is stretched most: the least, and the mean over the
   * printed area. Of drawings and words, which have no pixels of their own, those of the texture. Null where nothing is printed
   * of a picture: strokes, fills.
   */
  readonly dpi: { readonly least: number; readonly mean: number } | null;
  /** Percent by which the picture is longer one way than the other on the surface; 0 is true to shape. Null as `dpi` is. */
  readonly stretch: { readonly greatest: number; readonly mean: number } | null;
  /** Share of the picture, by its alpha, that lands on no texel. Hidden parts are among it. */
  readonly clipped: number;
  /** Share of the picture, by its alpha, whose surface faces away or lies behind something else. */
  readonly hidden: number;
  /** Share of the printed area that lies in no zone, its bleed included. 0 without zones. */
  readonly outsideZones: number;
  /** Share of the printed area that lies in a zone, but nearer to its edge than `safe`, or in its bleed. */
  readonly inSafeMargin: number;
  /** Printed texels that several places of the surface share: what is there appears more than once. */
  readonly overlapTexels: number;
  /** Printed texels whose part of the texture lies mirrored on the surface. */
  readonly mirroredTexels: number;
  /** Printed area, square centimetres: each texel's by the layer's own alpha there. What zones cut off is not printed. */
  readonly areaCm2: number;
}

export interface LayerPrint extends PrintMeasures {
  readonly id: string;
  readonly type: Exclude<EngineLayer["type"], "group">;
  /** glTF materials that it was measured on. */
  readonly materials: readonly number[];
  /** The zones that it lies in, and what share of its printed area does. */
  readonly zones: readonly { readonly id: string; readonly share: number }[];
}

/** For programs; stable. */
export type PrintFindingCode =
  /** Fewer pixels an inch than `dpi.least` (a violation) or `dpi.good` (a warning). */
  | "low-dpi"
  /** It lies outside of its zones, which are of the policy "warn" (a violation), or is clipped to them (a warning). */
  | "outside-zones"
  /** It lies where something must be expected to be cut. */
  | "safe-margin"
  /** No part of it lands on the surface, or on a zone. */
  | "nothing-printed"
  /** Part of the picture lands on no surface. */
  | "clipped"
  /** Part of the picture lies behind something, or on a side that faces away. */
  | "hidden"
  | "stretched"
  /** This mark will appear twice. */
  | "appears-twice"
  | "mirrored"
  /** Its words have characters that no font has: signs for that would be printed. */
  | "missing-characters"
  /** It lies on a material that was not measured: the model cannot be painted there. */
  | "not-printable"
  /** A zone names a material that the model does not have: it zones nothing. */
  | "zone-without-material";

/** Something that the print would not forgive. */
export interface PrintFinding {
  readonly code: PrintFindingCode;
  /** The layer's id; null where it is about a zone alone. */
  readonly layer: string | null;
  /** The zone's id; null where it is about none. */
  readonly zone: string | null;
  /** A whole sentence for the user. */
  readonly message: string;
  /** What to do about it. */
  readonly hint: string;
  /** What was found: DPI, percent, texels or characters. */
  readonly value: number;
  /** What it must not fall below or rise above. */
  readonly limit: number;
  /** Of "missing-characters", each once. */
  readonly characters?: readonly string[];
}

export interface PrintReport {
  readonly texelcastPrintReport: 1;
  readonly printScale: number;
  readonly dpi: { readonly least: number; readonly good: number };
  /** Visible layers that paint, bottom to top, those of groups included and those of masks not. */
  readonly layers: readonly LayerPrint[];
  /** The worst of all layers; texels and areas are sums. */
  readonly whole: PrintMeasures;
  /** What must not be printed so. `texelcast check` exits with 3 where there is any. */
  readonly violations: readonly PrintFinding[];
  /** What someone should look at. */
  readonly warnings: readonly PrintFinding[];
}

/** What a picture of `Engine.printMap` shows: at each texel the least DPI, or the greatest stretch, of the decals there. */
export type PrintMapKind = "dpi" | "stretch";

/** What shall be printed. The same options, design, assets and model give the same bytes everywhere. */
export interface PrintFileOptions {
  /** glTF material index; default: the zone's, else 0. */
  readonly material?: number;
  /** Texels of the texture: its width and height where it is square, up to 16384. Default: as `dpi` asks, else the material's own. */
  readonly size?: number | readonly [number, number];
  /**
   * Pixels an inch of print, in place of a `size`: the texture is as large as that needs, in powers of two. Flat art has as many
   * pixels, default 300, and takes a `size` beside it: of the texture that it is sampled from.
   */
  readonly dpi?: number;
  /** Id of a zone: that alone, with its bleed; all around it is transparent. */
  readonly zone?: string;
  /** The zone's surface sampled back to flat art, at its true size and the right way up. Asks for a `zone`. */
  readonly flattened?: boolean;
  /** "model" (default): on the material's own picture or colour; "none": the layers alone, on nothing. */
  readonly base?: "model" | "none";
}

/** A finished print file. */
export interface PrintFile {
  /** PNG, 8-bit RGBA, with sRGB and pHYs chunks. */
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Of `bytes`, 64 hex digits. */
  readonly sha256: string;
  /** Pixels. */
  readonly width: number;
  readonly height: number;
  /** Pixels an inch of print across and down, as the pHYs chunk says. */
  readonly dpi: readonly [number, number];
}
