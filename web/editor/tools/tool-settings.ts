/** What the options bar sets: one value for all tools, so that brush and eraser keep their size when one goes from one to the other. */

import type { BrushTip } from "./brush-tips.ts";
import { DEFAULT_PALETTE } from "./default-palette.ts";
import type { Palette } from "./gimp-palette.ts";
import type { MirrorSetting } from "./mirror-setting.ts";

export interface ToolSettings {
  /** "#rrggbb". */
  readonly color: string;
  /** What X swaps with. */
  readonly background: string;
  readonly palette: Palette;
  /** Newest first, "#rrggbb". */
  readonly recent: readonly string[];
  /** Width of a round brush, metres of the model; null until a model is open. */
  readonly size: number | null;
  /** Null: where the texture is small. */
  readonly pixelMode: boolean | null;
  /** Width of a pencil, texels. */
  readonly pixelSize: number;
  /** 0 to 1. */
  readonly hardness: number;
  /** 0 to 1. */
  readonly flow: number;
  /** 0 to 1, of a whole stroke. */
  readonly opacity: number;
  /** From dab to dab, as a share of the size. */
  readonly spacing: number;
  /** 0 to 100. */
  readonly stabiliser: number;
  /** What a pen's pressure changes. */
  readonly pressure: "none" | "flow" | "size";
  /** Paints a second time across a plane of the model. */
  readonly mirror: MirrorSetting;
  /** A picture to stamp; null paints a disc. */
  readonly tip: BrushTip | null;
  /** A picture tip is painted in the colour, else in its own. */
  readonly tinted: boolean;
  /** How far a colour may be from the one that was clicked and still be filled: 0 to 255 in each channel. */
  readonly tolerance: number;
  /** Fills only what hangs together. */
  readonly contiguous: boolean;
  /** Rectangles are filled. */
  readonly filled: boolean;
  /** Paints only where the layer has paint. */
  readonly alphaLock: boolean;
  /** Clone strokes keep the offset of the first since the source was set; else each copies from the source itself. */
  readonly cloneAligned: boolean;
  /** The next press says where clone strokes copy from. */
  readonly cloneArmed: boolean;
}

export const DEFAULT_COLORS = { color: "#000000", background: "#ffffff" } as const;

export const INITIAL_TOOL_SETTINGS: ToolSettings = {
  ...DEFAULT_COLORS,
  palette: DEFAULT_PALETTE,
  recent: [],
  size: null,
  pixelMode: null,
  pixelSize: 1,
  hardness: 0.8,
  flow: 1,
  opacity: 1,
  spacing: 0.12,
  stabiliser: 10,
  pressure: "flow",
  mirror: "none",
  tip: null,
  tinted: false,
  tolerance: 0,
  contiguous: true,
  filled: false,
  alphaLock: false,
  cloneAligned: true,
  cloneArmed: false,
};

/** Of the model's diagonal: a brush's width. */
const SIZES = { usual: 0.05, least: 0.0005, most: 0.5 } as const;
export const MOST_PIXEL_SIZE = 16;
const RECENT_KEPT = 12;

/** Puts a colour first among the recent ones. */
export function withRecent(recent: readonly string[], color: string): readonly string[] {
  return recent[0] === color ? recent : [color, ...recent.filter((other) => other !== color)].slice(0, RECENT_KEPT);
}

/** How wide a brush is at first, and may be at least and at most, metres, on a model of this diagonal. */
export function brushSizes(diagonal: number): {
  readonly usual: number;
  readonly least: number;
  readonly most: number;
} {
  return { usual: diagonal * SIZES.usual, least: diagonal * SIZES.least, most: diagonal * SIZES.most };
}
