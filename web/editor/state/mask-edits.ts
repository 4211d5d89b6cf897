/** What is painted on a mask: what hides and what shows again, and the fill that a mask begins with. */

import {
  type BlendMode,
  type Design,
  type DesignLayer,
  type FillLayer,
  type Gradient,
  type GradientStop,
  isPlaced,
  type Mask,
} from "../document/design.ts";
import { findLayer, freeIdIn, insertAt, mapLayer, removeById } from "../document/layer-tree.ts";
import { makeFillLayer } from "../document/make-layer.ts";
import type { NoticeBoard } from "./notice-board.ts";

/** What a mask shows before anything is painted on it. */
export type MaskStart = "all" | "nothing" | Gradient;

const INK = "#000000";

/** How what hides the masked layer, or shows it again, is blended: the other way round in an inverted mask. */
export const maskBlend = ({ invert }: Pick<Mask, "invert">, hides: boolean): BlendMode =>
  hides === invert ? "normal" : "erase";

/** Whether nothing is hidden by a mask: what shows again changes nothing there. */
export const hidesNothing = ({ invert, layers }: Mask): boolean =>
  !invert && layers.every(({ blend }) => blend !== "erase");

/** Whether a layer's mask can be linked to it: it is moved, or what is in it. */
export const canGoAlong = (layer: DesignLayer): boolean => isPlaced(layer) || layer.type === "group";

/** After a gesture that shows again: says so where it could change nothing. */
export function tellShownAlready(design: Design, id: string, board: NoticeBoard): void {
  const mask = findLayer(design, id)?.mask;
  if (mask && hidesNothing(mask)) board.info(board.strings.tools.shownAlready);
}

/** The fill below all that is painted on a mask; undefined where it begins with alpha 1. */
function groundOf({ layers: [lowest] }: Mask): FillLayer | undefined {
  return lowest?.type === "fill" && lowest.blend === "erase" && lowest.parts === null ? lowest : undefined;
}

/** Of a layer whose mask begins with a gradient: that fill. */
export function maskFade(layer: DesignLayer | undefined): (FillLayer & { readonly gradient: Gradient }) | undefined {
  const ground = layer?.mask ? groundOf(layer.mask) : undefined;
  return ground?.gradient ? { ...ground, gradient: ground.gradient } : undefined;
}

export function maskStartOf(mask: Mask): MaskStart {
  const ground = groundOf(mask);
  if (ground?.gradient) return ground.gradient;
  return (ground === undefined) === mask.invert ? "nothing" : "all";
}

/**
 * Lets a layer's mask begin otherwise: what was painted on it stays above. A mask is made where there is none. An unknown id
 * changes nothing. Throws as `insertAt`.
 */
export function withMaskStart(design: Design, id: string, start: MaskStart): Design {
  const layer = findLayer(design, id);
  if (layer === undefined) return design;
  const { material, mask } = layer;
  const ground = mask ? groundOf(mask) : undefined;
  const gradient = typeof start === "string" ? null : start;
  if (gradient === null && (start === "nothing") === (mask?.invert ?? false)) {
    return ground === undefined ? design : removeById(design, ground.id);
  }
  if (ground !== undefined) return mapLayer(design, ground.id, (each) => ({ ...each, gradient }) as DesignLayer);
  const fill = makeFillLayer({ id: freeIdIn(design), color: INK, blend: "erase", gradient, material });
  return insertAt(design, { parentId: id, list: "mask", index: 0 }, fill);
}

/**
 * A gradient's stops as masks are looked at: white where they show the layer, black where they hide it. In the document their alpha
 * says how much they take away, and their colours mean nothing.
 */
export const stopsAsGreys = (stops: readonly GradientStop[], { invert }: Pick<Mask, "invert">): GradientStop[] =>
  stops.map(({ offset, color }) => {
    const alpha = color.length > 7 ? Number.parseInt(color.slice(7, 9), 16) : 255;
    return { offset, color: `#${hex(invert ? alpha : 255 - alpha).repeat(3)}` };
  });

/** The way back; colours that are no greys count by their lightness. */
export const stopsOfGreys = (stops: readonly GradientStop[], { invert }: Pick<Mask, "invert">): GradientStop[] =>
  stops.map(({ offset, color }) => {
    const [red, green, blue] = [1, 3, 5].map((at) => Number.parseInt(color.slice(at, at + 2), 16)) as [
      number,
      number,
      number,
    ];
    const shown = Math.round((red * 299 + green * 587 + blue * 114) / 1000);
    const alpha = invert ? shown : 255 - shown;
    return { offset, color: alpha === 255 ? INK : `${INK}${hex(alpha)}` };
  });

const hex = (byte: number): string => byte.toString(16).padStart(2, "0");
