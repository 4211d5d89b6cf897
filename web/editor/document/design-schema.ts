/**
 * The shape of a design document of version 1 (spec.md, 8) as a valibot schema. Fields that are missing get their
 * defaults here; ids, names and the references between parts are `parse-design.ts`'s matter, and so is the depth, which
 * must be checked before a schema goes down into it.
 */
import * as v from "valibot";
import {
  ALIGNS,
  BLEND_MODES,
  BLEND_SPACES,
  BRUSH_DEFAULTS,
  DESIGN_FORMAT,
  DESIGN_VERSION,
  type DecalLayer,
  FILTERS,
  type FillLayer,
  FONT_TYPES,
  GROUP_DEFAULTS,
  type GroupLayer,
  LAYER_DEFAULTS,
  type LayerBase,
  MASK_DEFAULTS,
  type Mask,
  MIRROR_AXES,
  MIRROR_DEFAULTS,
  OCCLUSIONS,
  type PaintLayer,
  PICTURE_DEFAULTS,
  PICTURE_TYPES,
  PROJECTED_DEFAULTS,
  type StrokeLayer,
  TEXT_DEFAULTS,
  type TextLayer,
  WRAPS,
} from "./design.ts";
import { DESIGN_LIMITS, RESERVED_KEYS } from "./design-limits.ts";
import {
  angle,
  assetName,
  boundedList,
  checkAt,
  checkEach,
  coordinate,
  cylindrical,
  dab,
  filledText,
  flag,
  flow,
  hexColor,
  length,
  listOfNumbers,
  material,
  numberBetween,
  oneOf,
  perspective,
  planar,
  point,
  projector,
  rotation,
  strict,
  text,
  uv,
} from "./schema-parts.ts";

export { DESIGN_LIMITS } from "./design-limits.ts";

const layerEntries = {
  id: v.optional(filledText(DESIGN_LIMITS.idLength)),
  name: v.optional(text(DESIGN_LIMITS.nameLength)),
  material: v.optional(material, LAYER_DEFAULTS.material),
  visible: v.optional(flag, LAYER_DEFAULTS.visible),
  opacity: v.optional(numberBetween(0, 1), LAYER_DEFAULTS.opacity),
  blend: v.optional(oneOf(BLEND_MODES), LAYER_DEFAULTS.blend),
  blendSpace: v.optional(oneOf(BLEND_SPACES), LAYER_DEFAULTS.blendSpace),
  lockAlpha: v.optional(flag, LAYER_DEFAULTS.lockAlpha),
  locked: v.optional(flag, LAYER_DEFAULTS.locked),
  mask: v.optional(v.nullable(v.lazy(() => mask)), LAYER_DEFAULTS.mask),
};

const mirror = strict({
  axis: oneOf(MIRROR_AXES),
  offset: v.optional(coordinate, MIRROR_DEFAULTS.offset),
  readable: v.optional(flag, MIRROR_DEFAULTS.readable),
});
const mirrorEntries = { mirror: v.optional(v.nullable(mirror), null) };
const MIRROR_OF_UV = 'must be null: a projector of kind "uv" lies on no side of the model';

const projectedEntries = {
  backfaces: v.optional(flag, PROJECTED_DEFAULTS.backfaces),
  angleFade: v.optional(
    v.pipe(
      listOfNumbers([angle, angle]),
      v.check(([start, end]) => start <= end, "must not end before it starts"),
    ),
    () => [...PROJECTED_DEFAULTS.angleFade] as [number, number],
  ),
  occlusion: v.optional(oneOf(OCCLUSIONS), PROJECTED_DEFAULTS.occlusion),
};

const pictureEntries = {
  filter: v.optional(oneOf(FILTERS), PICTURE_DEFAULTS.filter),
  wrap: v.optional(oneOf(WRAPS), PICTURE_DEFAULTS.wrap),
  flipX: v.optional(flag, PICTURE_DEFAULTS.flipX),
  flipY: v.optional(flag, PICTURE_DEFAULTS.flipY),
};

const decal = v.pipe(
  strict({
    type: v.literal("decal"),
    ...layerEntries,
    asset: assetName,
    ...projectedEntries,
    ...pictureEntries,
    projector,
    ...mirrorEntries,
  }),
  checkAt("mirror", (layer) => layer.mirror === null || layer.projector.kind !== "uv", MIRROR_OF_UV),
);

const textLayer = v.pipe(
  strict({
    type: v.literal("text"),
    ...layerEntries,
    text: text(DESIGN_LIMITS.textLength),
    font: assetName,
    fontSize: v.optional(length, TEXT_DEFAULTS.fontSize),
    letterSpacing: v.optional(numberBetween(-1, 10), TEXT_DEFAULTS.letterSpacing),
    align: v.optional(oneOf(ALIGNS), TEXT_DEFAULTS.align),
    curve: v.optional(numberBetween(-360, 360, " degrees"), TEXT_DEFAULTS.curve),
    color: v.optional(hexColor, TEXT_DEFAULTS.color),
    outline: v.optional(v.nullable(strict({ color: hexColor, width: length })), TEXT_DEFAULTS.outline),
    ...projectedEntries,
    ...pictureEntries,
    projector,
    ...mirrorEntries,
  }),
  checkAt("mirror", (layer) => layer.mirror === null || layer.projector.kind !== "uv", MIRROR_OF_UV),
);

const roundBrush = strict({
  tip: v.optional(v.literal("round"), "round"),
  color: v.optional(hexColor, BRUSH_DEFAULTS.color),
  hardness: v.optional(numberBetween(0, 1), BRUSH_DEFAULTS.hardness),
  ...flow,
});

const pictureBrush = strict({
  tip: v.literal("picture"),
  asset: assetName,
  color: v.optional(v.nullable(hexColor), null),
  ...flow,
});

const brush = v.variant("tip", [roundBrush, pictureBrush], (issue) =>
  issue.expected === "Object" ? "must be an object" : 'must be one of "round", "picture"',
);

const hasUvDab = ({ dabs }: { readonly dabs: readonly { readonly kind: string }[] }): boolean =>
  dabs.some(({ kind }) => kind === "uv");

const stroke = v.pipe(
  strict({
    type: v.literal("stroke", 'must be "stroke"'),
    ...layerEntries,
    brush,
    dabs: boundedList(DESIGN_LIMITS.dabs, "dabs", dab),
    ...projectedEntries,
    ...pictureEntries,
    ...mirrorEntries,
  }),
  checkAt("mirror", (layer) => layer.mirror === null || !hasUvDab(layer), MIRROR_OF_UV),
);

const stops = v.pipe(
  boundedList(DESIGN_LIMITS.gradientStops, "stops", strict({ offset: numberBetween(0, 1), color: hexColor })),
  v.minLength(2, "must hold two stops at least"),
  checkEach(
    "offset",
    ({ offset }, before) => offset >= (before?.offset ?? 0),
    "must not fall back in offset from one stop to the next",
  ),
);
const gradient = v.variant(
  "kind",
  [
    v.pipe(
      strict({ kind: v.literal("linear"), from: point, to: point, stops }),
      checkAt(
        "to",
        ({ from, to }) => from.some((part, axis) => Math.fround(part) !== Math.fround(to[axis] as number)),
        "must not be where from is",
      ),
    ),
    strict({ kind: v.literal("radial"), center: point, radius: length, stops }),
  ],
  (issue) => (issue.expected === "Object" ? "must be an object" : 'must be one of "linear", "radial"'),
);

const triangleMessage = "must be a triangle's index: a whole number, 0 or above";
const triangles = boundedList(
  DESIGN_LIMITS.parts,
  "triangles",
  v.pipe(
    v.number(triangleMessage),
    v.integer(triangleMessage),
    v.minValue(0, triangleMessage),
    v.maxValue(0xffff_ffff, triangleMessage),
  ),
);
const parts = v.variant(
  "kind",
  [strict({ kind: v.literal("charts"), charts: triangles }), strict({ kind: v.literal("faces"), faces: triangles })],
  (issue) => (issue.expected === "Object" ? "must be an object" : 'must be one of "charts", "faces"'),
);

const fill = v.pipe(
  strict(
    {
      type: v.literal("fill"),
      ...layerEntries,
      color: hexColor,
      gradient: v.optional(v.nullable(gradient), null),
      parts: v.optional(v.nullable(parts), null),
    },
    { color: ", which shows where there is no gradient, and is kept beside one" },
  ),
  checkAt(
    "parts",
    (layer) => layer.parts === null || typeof layer.material === "number" || layer.material.length === 1,
    "must be null where material names several: triangles are those of one material",
  ),
);

const paint = v.pipe(
  strict({
    type: v.literal("paint"),
    ...layerEntries,
    strokes: boundedList(DESIGN_LIMITS.layers, "strokes", stroke),
    ...mirrorEntries,
  }),
  checkAt("mirror", (layer) => layer.mirror === null || !layer.strokes.some(hasUvDab), MIRROR_OF_UV),
);

const group = strict({
  type: v.literal("group"),
  ...layerEntries,
  layers: boundedList(
    DESIGN_LIMITS.layers,
    "layers",
    v.lazy(() => layer),
  ),
  isolated: v.optional(flag, GROUP_DEFAULTS.isolated),
});

/** Groups hold layers and masks hold layers: types that the compiler cannot infer from their own schemas. */
const layer: v.GenericSchema<unknown, ParsedLayer> = v.variant(
  "type",
  [decal, textLayer, stroke, fill, group, paint],
  (issue) =>
    issue.expected === "Object"
      ? "must be an object"
      : 'must be one of "decal", "text", "stroke", "fill", "group", "paint"',
);
const maskLayer: v.GenericSchema<unknown, ParsedMaskLayer> = v.variant(
  "type",
  [decal, textLayer, stroke, fill],
  (issue) =>
    issue.expected === "Object" ? "must be an object" : 'must be one of "decal", "text", "stroke", "fill" in a mask',
);
const mask: v.GenericSchema<unknown, ParsedMask> = strict({
  layers: boundedList(DESIGN_LIMITS.layers, "layers", maskLayer),
  invert: v.optional(flag, MASK_DEFAULTS.invert),
  linked: v.optional(flag, MASK_DEFAULTS.linked),
});

const asset = strict({
  type: oneOf([...PICTURE_TYPES, ...FONT_TYPES]),
  uri: v.pipe(v.string("must be a string"), v.nonEmpty("must not be empty")),
});

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** valibot drops reserved keys of a record without a word; a name that vanishes is worse than one refused. */
const assets = v.pipe(
  v.custom<Record<string, unknown>>(isObject, "must be an object of named assets"),
  v.maxEntries(DESIGN_LIMITS.assets, `must not hold more than ${DESIGN_LIMITS.assets} assets`),
  v.check(
    (value) => !RESERVED_KEYS.some((key) => Object.hasOwn(value, key)),
    `must not name an asset ${RESERVED_KEYS.map((key) => `"${key}"`).join(" or ")}`,
  ),
  v.record(assetName, asset),
);

export const designSchema = strict({
  format: v.literal(DESIGN_FORMAT),
  version: v.literal(DESIGN_VERSION),
  assets: v.optional(assets, () => ({})),
  layers: v.optional(boundedList(DESIGN_LIMITS.layers, "layers", layer), () => []),
});

/** The parts of the schema that a reader knows by name; the published JSON Schema gives each a definition of its own. */
export const designParts = {
  decal,
  text: textLayer,
  stroke,
  fill,
  group,
  paint,
  layer,
  maskLayer,
  mask,
  mirror,
  gradient,
  parts,
  material,
  asset,
  assetName,
  planar,
  perspective,
  cylindrical,
  uv,
  projector,
  point,
  rotation,
  length,
  hexColor,
};

/** A layer as the schema leaves it: ids and names may still be missing, here and further down. */
type Parsed<Layer extends LayerBase> = Omit<Layer, "id" | "name" | "mask"> & {
  readonly id?: string | undefined;
  readonly name?: string | undefined;
  readonly mask: ParsedMask | null;
};
export type ParsedMaskLayer = Parsed<DecalLayer> | Parsed<TextLayer> | Parsed<StrokeLayer> | Parsed<FillLayer>;
export interface ParsedMask extends Omit<Mask, "layers"> {
  readonly layers: readonly ParsedMaskLayer[];
}
type ParsedGroup = Omit<Parsed<GroupLayer>, "layers"> & { readonly layers: readonly ParsedLayer[] };
type ParsedPaint = Omit<Parsed<PaintLayer>, "strokes"> & { readonly strokes: readonly Parsed<StrokeLayer>[] };
export type ParsedLayer = ParsedMaskLayer | ParsedGroup | ParsedPaint;
export type ParsedDesign = v.InferOutput<typeof designSchema>;
