/** Writes a design document: the inverse of `parseDesign`. */

import {
  type Design,
  type DesignAsset,
  type DesignLayer,
  type Gradient,
  isPlaced,
  type Mask,
  type Projector,
  type StrokeLayer,
} from "./design.ts";
import { print, printJson } from "./print-json.ts";

/**
 * The order in which fields are written, whatever order the editor's objects have: a saved design then changes in a
 * version control system only where it was changed. Every field is written, defaults too, so that a file says what it
 * means without this program's help.
 */
const LAYER_FIELDS = [
  "id",
  "type",
  "name",
  "material",
  "visible",
  "locked",
  "asset",
  "text",
  "font",
  "fontSize",
  "letterSpacing",
  "align",
  "curve",
  "color",
  "outline",
  "gradient",
  "parts",
  "brush",
  "opacity",
  "blend",
  "blendSpace",
  "lockAlpha",
  "isolated",
  "mask",
  "filter",
  "wrap",
  "flipX",
  "flipY",
  "backfaces",
  "angleFade",
  "occlusion",
  "projector",
  "mirror",
  "dabs",
  "strokes",
  "layers",
] as const;
/** A dab's flow is among them. */
const PROJECTOR_FIELDS = [
  "kind",
  "position",
  "center",
  "rotation",
  "size",
  "angle",
  "fov",
  "aspect",
  "near",
  "far",
  "radius",
  "height",
  "arc",
  "depth",
  "flow",
] as const;
const OUTLINE_FIELDS = ["color", "width"] as const;
const MIRROR_FIELDS = ["axis", "offset", "readable"] as const;
const GRADIENT_FIELDS = ["kind", "from", "to", "center", "radius", "stops"] as const;
const STOP_FIELDS = ["offset", "color"] as const;
const PARTS_FIELDS = ["kind", "charts", "faces"] as const;
const BRUSH_FIELDS = ["tip", "asset", "color", "hardness", "flow"] as const;

/** Gives a paint layer's strokes as what is printed: items that give their text for the indent at which it will stand. */
export type StrokePrinter = (strokes: readonly StrokeLayer[]) => readonly unknown[];

/** The design as JSON text, two spaces of indent, one line feed at the end. */
export function serialiseDesign(design: Design, printStrokes?: StrokePrinter): string {
  const document = {
    format: design.format,
    version: design.version,
    assets: Object.fromEntries(Object.entries(design.assets).map(([key, asset]) => [key, orderAsset(asset)])),
    layers: listed(design.layers, printStrokes),
  };
  return printJson(document);
}

function pick(source: object, fields: readonly string[]): Record<string, unknown> {
  const values = source as Record<string, unknown>;
  return Object.fromEntries(
    fields.filter((field) => values[field] !== undefined).map((field) => [field, values[field]]),
  );
}

const orderAsset = (asset: DesignAsset): object => pick(asset, ["type", "uri"]);
const orderProjector = (projector: Projector): object => pick(projector, PROJECTOR_FIELDS);

const orderMask = (mask: Mask): object => ({ invert: mask.invert, linked: mask.linked, layers: listed(mask.layers) });
const orderGradient = (gradient: Gradient): object => ({
  ...pick(gradient, GRADIENT_FIELDS),
  stops: gradient.stops.map((stop) => pick(stop, STOP_FIELDS)),
});

/** A layer's text, by its place's indent: in a design of thousands all but the newest were written before. */
const TEXTS = new WeakMap<DesignLayer, { readonly indent: string; readonly text: string }>();

export function layerText(layer: DesignLayer, indent: string): string {
  const known = TEXTS.get(layer);
  if (known?.indent === indent) return known.text;
  const text = print(orderLayer(layer), indent);
  TEXTS.set(layer, { indent, text });
  return text;
}

/** Of a layer that will not be written again soon. */
export const forgetText = (layer: DesignLayer): boolean => TEXTS.delete(layer);

/** What holds layers is another with each change of one of them, and has the texts of these. */
const listed = (layers: readonly DesignLayer[], printStrokes?: StrokePrinter): readonly unknown[] =>
  layers.map((layer) =>
    layer.type === "group" || layer.type === "paint"
      ? orderLayer(layer, printStrokes)
      : (indent: string) => layerText(layer, indent),
  );

function orderLayer(layer: DesignLayer, printStrokes: StrokePrinter = listed): object {
  const ordered = pick(layer, LAYER_FIELDS);
  if (layer.mask !== null) ordered.mask = orderMask(layer.mask);
  if ("mirror" in layer && layer.mirror !== null) ordered.mirror = pick(layer.mirror, MIRROR_FIELDS);
  if (isPlaced(layer)) ordered.projector = orderProjector(layer.projector);
  if (layer.type === "text" && layer.outline !== null) ordered.outline = pick(layer.outline, OUTLINE_FIELDS);
  if (layer.type === "stroke") {
    ordered.brush = pick(layer.brush, BRUSH_FIELDS);
    ordered.dabs = layer.dabs.map(orderProjector);
  }
  if (layer.type === "fill") {
    if (layer.gradient !== null) ordered.gradient = orderGradient(layer.gradient);
    if (layer.parts !== null) ordered.parts = pick(layer.parts, PARTS_FIELDS);
  }
  if (layer.type === "group") ordered.layers = listed(layer.layers, printStrokes);
  if (layer.type === "paint") ordered.strokes = printStrokes(layer.strokes);
  return ordered;
}
