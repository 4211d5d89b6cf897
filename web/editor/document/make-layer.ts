/** New layers: every field that is not given at its default. */
import {
  type DecalLayer,
  type FillLayer,
  GROUP_DEFAULTS,
  type GroupLayer,
  LAYER_DEFAULTS,
  type PaintLayer,
  PICTURE_DEFAULTS,
  PROJECTED_DEFAULTS,
  type StrokeLayer,
  TEXT_DEFAULTS,
  type TextLayer,
} from "./design.ts";

/** What must be given, and the rest at will. */
type Fields<Layer, Required extends keyof Layer> = Pick<Layer, Required> & Partial<Omit<Layer, "type">>;

const PROJECTED = { ...LAYER_DEFAULTS, ...PROJECTED_DEFAULTS, ...PICTURE_DEFAULTS, mirror: null } as const;

export function makeDecalLayer(fields: Fields<DecalLayer, "id" | "asset" | "projector">): DecalLayer {
  return { type: "decal", ...PROJECTED, name: fields.asset, ...fields };
}

export function makeTextLayer(fields: Fields<TextLayer, "id" | "text" | "font" | "projector">): TextLayer {
  return { type: "text", ...PROJECTED, ...TEXT_DEFAULTS, name: "Text", ...fields };
}

export function makeFillLayer(fields: Fields<FillLayer, "id" | "color">): FillLayer {
  return { type: "fill", ...LAYER_DEFAULTS, name: "Fill", gradient: null, parts: null, ...fields };
}

export function makeStrokeLayer(fields: Fields<StrokeLayer, "id" | "brush" | "dabs">): StrokeLayer {
  return { type: "stroke", ...PROJECTED, name: "Stroke", ...fields };
}

export function makeGroupLayer(fields: Fields<GroupLayer, "id" | "layers">): GroupLayer {
  return { type: "group", ...LAYER_DEFAULTS, ...GROUP_DEFAULTS, name: "Group", ...fields };
}

export function makePaintLayer(fields: Fields<PaintLayer, "id" | "strokes">): PaintLayer {
  return { type: "paint", ...LAYER_DEFAULTS, mirror: null, name: "Paint", ...fields };
}
