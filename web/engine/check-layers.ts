/**
 * Layers as an engine is given them, looked at when they could not be drawn: the types of a design that was parsed hold, and what
 * is drawn in every frame is not checked in each of them.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { BLEND_MODES } from "./blend-modes.ts";
import { checkText } from "./check-text.ts";
import {
  between,
  checkFields,
  checkValue,
  either,
  FLAG,
  isObject,
  LIST,
  maybe,
  NUMBER,
  numbers,
  OBJECT,
  oneOf,
  type Rule,
  type Rules,
  TEXT,
} from "./check-value.ts";

const SHARE = between(0, 1);
const COLOR = numbers(4);
const MATERIALS: Rule = {
  must: "a material's index, or a list of them",
  holds: (value) => (Array.isArray(value) ? value : [value]).every(Number.isInteger),
};

const EVERY: Rules = {
  type: oneOf("decal", "stroke", "fill", "group"),
  opacity: SHARE,
  blend: oneOf(...BLEND_MODES),
  blendSpace: oneOf("srgb", "linear"),
  mask: maybe(OBJECT),
};
const CAST: Rules = {
  material: MATERIALS,
  filter: oneOf("linear", "nearest"),
  wrap: oneOf("none", "repeat"),
  angleFade: numbers(2),
  occlusion: oneOf("self", "none"),
};
const BY_TYPE: Readonly<Record<string, Rules>> = {
  decal: { ...CAST, asset: either(TEXT, OBJECT) },
  stroke: { ...CAST, brush: OBJECT, dabs: LIST },
  fill: { material: MATERIALS, color: COLOR, gradient: maybe(OBJECT), parts: maybe(OBJECT) },
  group: { layers: LIST },
};

const POSED: Rules = { position: numbers(3), rotation: numbers(4) };
const PROJECTORS: Readonly<Record<string, Rules>> = {
  planar: { ...POSED, size: numbers(3) },
  perspective: { ...POSED, fov: NUMBER, aspect: NUMBER, near: NUMBER, far: NUMBER },
  cylindrical: { ...POSED, radius: NUMBER, height: NUMBER, arc: NUMBER, depth: NUMBER },
  uv: { center: numbers(2), size: numbers(2), angle: NUMBER },
};

/** The first thing that is no layer's: a "bad-argument" with its field ("layers[0].projector.size") and value; null without one. */
export function layersFault(layers: unknown): TexelcastError | null {
  try {
    checkLayers(layers, "layers", new Set());
    return null;
  } catch (thrown) {
    return TexelcastError.wrap(thrown, "internal", "The layers could not be read.");
  }
}

/** `ids`: those of the layers before. */
function checkLayers(layers: unknown, field: string, ids: Set<unknown>): void {
  checkValue(layers, LIST, field);
  for (const [index, layer] of (layers as readonly unknown[]).entries()) checkLayer(layer, `${field}[${index}]`, ids);
}

function checkLayer(layer: unknown, field: string, ids: Set<unknown>): void {
  checkFields(layer, EVERY, field);
  const { id, type, mask, layers, asset, brush, dabs, gradient, parts, projector } = layer as Readonly<
    Record<string, unknown>
  >;
  const holds = (): boolean => typeof id === "string" && id !== "" && !ids.has(id);
  checkValue(id, { must: "a text that no other layer has", holds }, `${field}.id`);
  ids.add(id);
  checkFields(layer, BY_TYPE[type as string] ?? {}, field);
  if (isObject(mask)) checkLayers(mask.layers, `${field}.mask.layers`, ids);
  if (type === "group") checkLayers(layers, `${field}.layers`, ids);
  if (type === "decal") {
    if (isObject(asset)) checkText(asset, `${field}.asset`);
    checkProjector(projector, `${field}.projector`);
  } else if (type === "stroke") {
    checkBrush(brush, `${field}.brush`);
    for (const [index, dab] of (dabs as readonly unknown[]).entries()) {
      checkFields(dab, { flow: SHARE, flipX: maybe(FLAG) }, `${field}.dabs[${index}]`);
      checkProjector(dab, `${field}.dabs[${index}]`);
    }
  } else if (type === "fill") {
    if (isObject(gradient)) checkGradient(gradient, `${field}.gradient`);
    if (isObject(parts)) checkParts(parts, `${field}.parts`);
  }
}

function checkProjector(projector: unknown, field: string): void {
  checkFields(projector, { kind: oneOf(...Object.keys(PROJECTORS)) }, field);
  checkFields(projector, PROJECTORS[(projector as { kind: string }).kind] ?? {}, field);
}

function checkBrush(brush: unknown, field: string): void {
  checkFields(brush, { tip: oneOf("round", "picture"), flow: SHARE }, field);
  const { tip, asset } = brush as { readonly tip: string; readonly asset?: unknown };
  if (tip === "round") checkFields(brush, { color: COLOR, hardness: SHARE }, field);
  else checkFields(brush, { color: maybe(COLOR), asset: either(TEXT, OBJECT) }, field);
  if (isObject(asset)) checkText(asset, `${field}.asset`);
}

function checkGradient(gradient: unknown, field: string): void {
  checkFields(gradient, { kind: oneOf("linear", "radial"), stops: LIST }, field);
  const { kind, stops } = gradient as { readonly kind: string; readonly stops: readonly unknown[] };
  if (kind === "radial") checkFields(gradient, { center: numbers(3), radius: NUMBER }, field);
  else checkFields(gradient, { from: numbers(3), to: numbers(3) }, field);
  for (const [index, stop] of stops.entries()) {
    checkFields(stop, { offset: SHARE, color: COLOR }, `${field}.stops[${index}]`);
  }
}

function checkParts(parts: unknown, field: string): void {
  checkFields(parts, { kind: oneOf("charts", "faces") }, field);
  const { kind } = parts as { readonly kind: string };
  checkFields(parts, { [kind]: LIST }, field);
}
