/** Writes a design document: the inverse of `parseDesign`. */

import {
  type Design,
  type DesignAsset,
  type DesignLayer,
  type Gradient,
  isPlaced,
  type Mask,
  type Projector,
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

/** What is printed in the place of so many layers of a list. */
export interface PrintedPart {
  readonly text: string;
  readonly count: number;
}
/** Gives what is printed for the layers from a place of a list on; undefined where the layer there stands for itself. */
export type PartFinder = (layers: readonly DesignLayer[], at: number) => PrintedPart | undefined;

/** The design as JSON text, two spaces of indent, one line feed at the end. */
export function serialiseDesign(design: Design, findPart?: PartFinder): string {
  const document = {
    format: design.format,
    version: design.version,
    assets: Object.fromEntries(Object.entries(design.assets).map(([key, asset]) => [key, orderAsset(asset)])),
    layers: listed(design.layers, findPart),
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

const orderMask = ({ invert, linked, layers }: Mask, findPart?: PartFinder): object => ({
  invert,
  linked,
  layers: listed(layers, findPart),
});
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
function listed(layers: readonly DesignLayer[], findPart?: PartFinder): readonly unknown[] {
  const items: unknown[] = [];
  for (let at = 0; at < layers.length; ) {
    const layer = layers[at] as DesignLayer;
    const part = findPart?.(layers, at);
    at += part?.count ?? 1;
    if (part !== undefined) items.push(() => part.text);
    else if (layer.type === "group" || layer.type === "paint" || layer.mask !== null) {
      items.push(orderLayer(layer, findPart));
    } else items.push((indent: string) => layerText(layer, layer.type === "stroke" && findPart ? "" : indent));
  }
  return items;
}

function orderLayer(layer: DesignLayer, findPart?: PartFinder): object {
  const ordered = pick(layer, LAYER_FIELDS);
  if (layer.mask !== null) ordered.mask = orderMask(layer.mask, findPart);
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
  if (layer.type === "group") ordered.layers = listed(layer.layers, findPart);
  if (layer.type === "paint") ordered.strokes = listed(layer.strokes, findPart);
  return ordered;
}
