/** From the design's vocabulary to the engine's. */

import type {
  EngineBrush,
  EngineDecalLayer,
  EngineFillLayer,
  EngineGradient,
  EngineGroupLayer,
  EngineLayer,
  EngineMask,
  EngineText,
} from "../../engine/engine-api.ts";
import { isShippedFontAddress } from "../../engine/font-address.ts";
import { sameItems } from "../../engine/same-items.ts";
import {
  type Brush,
  type DecalLayer,
  type Design,
  type DesignLayer,
  type FillLayer,
  type Gradient,
  type GroupLayer,
  isPlaced,
  type LayerMaterials,
  layerMaterials,
  type Mirror,
  type PaintLayer,
  type StrokeLayer,
  type TextLayer,
} from "./design.ts";
import { parseHexColor } from "./hex-color.ts";
import { materialsIn } from "./layer-tree.ts";
import { liesOnTexture, type MaskMirror, mirroredDabs, mirroredDecal, sameMirror } from "./mirror-layer.ts";

type Assets = Design["assets"];

/**
 * The design's layers, bottom to top, as the engine takes them: paint layers as the groups that they are, words as pictures,
 * and what has a mirror with its twin inside the same layer.
 */
export function resolveLayers({ layers, assets }: Pick<Design, "layers" | "assets">): EngineLayer[] {
  return resolveList(layers, assets);
}

function resolveList(layers: readonly DesignLayer[], assets: Assets): EngineLayer[] {
  return layers.map((layer) => resolveLayer(layer, assets));
}

function resolveLayer(
  layer: DesignLayer,
  assets: Assets,
  outer: Mirror | MaskMirror | null = null,
  masked: readonly number[] | null = null,
): EngineLayer {
  // Not looked for where nobody asks: a paint layer may hold thousands of strokes.
  const own = masked ? materialsInMask(layer, masked) : layer.mask ? materialsIn(layer) : [];
  const mask = resolveMask(layer, assets, own, outer);
  const held =
    layer.type === "group"
      ? resolveList(layer.layers, assets)
      : layer.type === "paint"
        ? layer.strokes.map((stroke) => resolveLayer(stroke, assets, layer.mirror))
        : [];
  const font = layer.type === "text" ? (assets[layer.font]?.uri ?? null) : null;
  const material = masked === null ? null : layerMaterials(own);
  return resolvedOnce(layer, { mask, held, outer, font, material }, () => {
    const resolved = resolveKind(layer, { mask, held, outer, font, material }, assets);
    return material === null || resolved.type === "group" ? resolved : { ...resolved, material };
  });
}

function resolveKind(layer: DesignLayer, { mask, held, outer }: LayerContext, assets: Assets): EngineLayer {
  switch (layer.type) {
    case "text":
      return resolveText(layer, mask, outer, assets);
    case "decal":
      return resolveDecal(layer, mask, outer);
    case "stroke":
      return resolveStroke(layer, mask, outer);
    case "fill":
      return resolveFill(layer, mask);
    case "group":
      return resolveGroup(layer, held, mask, layer.isolated);
    case "paint":
      return resolveGroup(layer, held, mask, true);
  }
}

/**
 * A mask's layers reach what the masked layer paints: thrown at the surface, they need no list of their own. What lies in one
 * texture itself, by its place there or by its triangles, keeps to those that it names, unless the masked layer paints none.
 */
function materialsInMask(layer: DesignLayer, masked: readonly number[]): readonly number[] {
  const isInTexture = layer.type === "fill" ? layer.parts !== null : liesOnTexture(layer);
  if (!isInTexture) return masked;
  const common = materialsIn(layer).filter((material) => masked.includes(material));
  // Triangles are those of one material, and mean others in another.
  return common.length > 0 || layer.type === "fill" ? common : masked;
}

/** What a resolved layer is made of besides its own fields. */
interface LayerContext {
  readonly mask: EngineMask | null;
  readonly held: readonly EngineLayer[];
  /** Of the paint layer that it is in, or of the layer that it masks. */
  readonly outer: Mirror | MaskMirror | null;
  /** Of words: their font's address. */
  readonly font: string | null;
  /** Of a mask's layers: in place of their own. */
  readonly material: LayerMaterials | null;
}

/** By the design's layers, which never change: what is the same object for the editor is the same one for the engine. */
const RESOLVED = new WeakMap<DesignLayer, LayerContext & { readonly engineLayer: EngineLayer }>();

function resolvedOnce(layer: DesignLayer, context: LayerContext, resolve: () => EngineLayer): EngineLayer {
  const known = RESOLVED.get(layer);
  const isKnown =
    known !== undefined &&
    isSame(known.outer, context.outer) &&
    known.font === context.font &&
    String(known.material) === String(context.material) &&
    sameItems(known.held, context.held) &&
    sameItems(known.mask?.layers ?? [], context.mask?.layers ?? []);
  if (isKnown) return known.engineLayer;
  const engineLayer = resolve();
  RESOLVED.set(layer, { ...context, engineLayer });
  return engineLayer;
}

function resolveMask(
  layer: DesignLayer,
  assets: Assets,
  masked: readonly number[],
  outer: Mirror | null,
): EngineMask | null {
  if (layer.mask === null) return null;
  const { invert, layers } = layer.mask;
  const mirror = ("mirror" in layer && layer.mirror) || outer;
  const shown = mirror && isPlaced(layer) ? { ...mirror, of: layer.projector } : mirror;
  return { invert, layers: layers.map((each) => resolveLayer(each, assets, shown, masked)) };
}

const isSame = (a: Mirror | null, b: Mirror | null): boolean =>
  a === b || (a !== null && b !== null && sameMirror(a, b));

/** Its own, and the one that shows it with another layer; that they are the same counts once. */
function mirrorsOf(own: Mirror | null, outer: Mirror | null): readonly (Mirror | MaskMirror)[] {
  const isTwice = own !== null && outer !== null && sameMirror(own, outer);
  return isTwice ? [own] : [own, outer].filter((one) => one !== null);
}

function resolveText(layer: TextLayer, mask: EngineMask | null, outer: Mirror | null, assets: Assets): EngineLayer {
  const { name: _shownName, locked: _locked, mirror, ...fields } = layer;
  const { text: _text, font: _font, fontSize: _size, letterSpacing: _spacing, align: _align, ...rest } = fields;
  const { curve: _curve, color: _color, outline: _outline, ...cast } = rest;
  const decal = { ...cast, type: "decal" as const, asset: resolveWords(layer, assets), mask };
  return withTwins(decal, mirrorsOf(mirror, outer));
}

/** A text layer's words. A font that comes with Texelcast goes by its address, another by its key among the assets. */
export function resolveWords(
  layer: Pick<TextLayer, "text" | "font" | "fontSize" | "letterSpacing" | "align" | "curve" | "color" | "outline">,
  assets: Assets,
): EngineText {
  const { text, fontSize, letterSpacing, align, curve, outline } = layer;
  const uri = assets[layer.font]?.uri ?? "";
  return {
    text,
    font: isShippedFontAddress(uri) ? uri : layer.font,
    fontSize,
    letterSpacing,
    align,
    curve,
    color: parseHexColor(layer.color),
    outline: outline === null ? null : { color: parseHexColor(outline.color), width: outline.width },
  };
}

function resolveDecal(layer: DecalLayer, mask: EngineMask | null, outer: Mirror | null): EngineLayer {
  const { name: _shownName, locked: _locked, mirror, ...fields } = layer;
  return withTwins({ ...fields, mask }, mirrorsOf(mirror, outer));
}

/** A stamp has none. */
const withTwins = (decal: EngineDecalLayer, mirrors: readonly Mirror[]): EngineLayer =>
  mirrors.length === 0 || decal.projector.kind === "uv" ? decal : mirroredDecal(decal, mirrors);

function resolveStroke(layer: StrokeLayer, mask: EngineMask | null, outer: Mirror | null): EngineLayer {
  const { name: _shownName, locked: _locked, mirror, ...fields } = layer;
  // The dabs' own objects: by them the engine knows what is new in a stroke that grows.
  return {
    ...fields,
    mask,
    brush: resolveBrush(layer.brush),
    dabs: mirroredDabs(layer.dabs, mirrorsOf(mirror, outer)),
  };
}

function resolveBrush(brush: Brush): EngineBrush {
  if (brush.tip === "round") return { ...brush, color: parseHexColor(brush.color) };
  return { ...brush, color: brush.color === null ? null : parseHexColor(brush.color) };
}

function resolveFill(layer: FillLayer, mask: EngineMask | null): EngineFillLayer {
  const { name: _shownName, locked: _locked, gradient, ...fields } = layer;
  return {
    ...fields,
    mask,
    color: parseHexColor(layer.color),
    gradient: gradient === null ? null : resolveGradient(gradient),
  };
}

function resolveGradient(gradient: Gradient): EngineGradient {
  const stops = gradient.stops.map(({ offset, color }) => ({ offset, color: parseHexColor(color) }));
  return { ...gradient, stops };
}

function resolveGroup(
  { id, visible, opacity, blend, blendSpace, lockAlpha }: GroupLayer | PaintLayer,
  layers: readonly EngineLayer[],
  mask: EngineMask | null,
  isolated: boolean,
): EngineGroupLayer {
  return { id, type: "group", visible, opacity, blend, blendSpace, lockAlpha, isolated, layers, mask };
}
