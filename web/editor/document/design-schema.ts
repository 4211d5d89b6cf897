/**
 * The shape of a design document of version 1 (spec.md, 8) as a valibot schema. Fields that are missing get their
 * defaults here; ids, names and the references between parts are `parse-design.ts`'s matter.
 *
 * Messages are written to stand between a path and a value: "layers[2].opacity: must be a number from 0 to 1, is 3".
 */
import * as v from "valibot";
import {
  BLEND_MODES,
  BLEND_SPACES,
  BRUSH_DEFAULTS,
  DESIGN_FORMAT,
  DESIGN_VERSION,
  FILTERS,
  FONT_TYPES,
  LAYER_DEFAULTS,
  OCCLUSIONS,
  PICTURE_DEFAULTS,
  PICTURE_TYPES,
  PROJECTED_DEFAULTS,
  WRAPS,
} from "./design.ts";
import { HEX_COLOR } from "./hex-color.ts";

/** Bounds that no honest design meets; they keep a hostile file from costing more than its reading. */
export const DESIGN_LIMITS = {
  layers: 10_000,
  assets: 10_000,
  dabs: 100_000,
  materials: 65_536,
  idLength: 200,
  nameLength: 1000,
  textLength: 10_000,
  /** Metres. Lengths outside would not survive the engine's 32-bit arithmetic. */
  lengthMin: 1e-9,
  lengthMax: 1e9,
} as const;

/** Names that JavaScript gives a meaning of its own as an object's keys. */
const RESERVED_KEYS = ["__proto__", "prototype", "constructor"];

const quoted = (values: readonly string[]): string => values.map((value) => `"${value}"`).join(", ");

/** An object that refuses what it does not know, and says what it does. */
function strict<const Entries extends v.ObjectEntries>(entries: Entries) {
  const names = Object.keys(entries).join(", ");
  return v.strictObject(entries, (issue) => {
    if (issue.expected === "never") return `is not a known field (known here: ${names})`;
    return issue.expected === "Object" ? "must be an object" : "is missing";
  });
}

const oneOf = <const Values extends readonly [string, ...string[]]>(values: Values) =>
  v.picklist(values, `must be one of ${quoted(values)}`);

const flag = v.boolean("must be true or false");

function numberBetween(min: number, max: number, unit = "") {
  const message = `must be a number from ${min} to ${max}${unit}`;
  return v.pipe(v.number(message), v.minValue(min, message), v.maxValue(max, message));
}

const text = (maxLength: number) =>
  v.pipe(v.string("must be a string"), v.maxLength(maxLength, `must not be longer than ${maxLength} characters`));
const filledText = (maxLength: number) => v.pipe(text(maxLength), v.nonEmpty("must not be empty"));

/** A list of exactly `length` numbers. The length is checked first, so a short list is one problem and not several. */
function listOfNumbers<const Items extends [v.GenericSchema<number>, ...v.GenericSchema<number>[]]>(items: Items) {
  const message = `must be a list of ${items.length} numbers`;
  return v.pipe(v.array(v.unknown(), message), v.length(items.length, message), v.tuple(items));
}

const coordinate = numberBetween(-DESIGN_LIMITS.lengthMax, DESIGN_LIMITS.lengthMax);
const length = v.pipe(
  v.number("must be a number above 0"),
  v.gtValue(0, "must be above 0"),
  v.minValue(DESIGN_LIMITS.lengthMin, `must be at least ${DESIGN_LIMITS.lengthMin}`),
  v.maxValue(DESIGN_LIMITS.lengthMax, `must be at most ${DESIGN_LIMITS.lengthMax}`),
);
const point = listOfNumbers([coordinate, coordinate, coordinate]);

const quaternionLength = (rotation: readonly number[]): number =>
  Math.sqrt(rotation.reduce((sum, part) => sum + part * part, 0));
const rotation = v.pipe(
  listOfNumbers([coordinate, coordinate, coordinate, coordinate]),
  v.check((q) => quaternionLength(q) > 0, "must not be all zeros: without a rotation it is [0, 0, 0, 1]"),
  v.check((q) => {
    const size = quaternionLength(q);
    return size === 0 || (size >= 1e-3 && size <= 1e3);
  }, "must be a unit quaternion x, y, z, w (a length from 0.001 to 1000 is made one)"),
);

// The engine counts in 32-bit floats: what is 0 or 180 degrees there must not pass here.
const isAbove0 = (degrees: number): boolean => Math.fround(degrees) > 0;
const isBelow180 = (degrees: number): boolean => Math.fround(degrees) < 180;

const planar = strict({
  kind: v.literal("planar"),
  position: point,
  rotation,
  size: listOfNumbers([length, length, length]),
});

const perspective = v.pipe(
  strict({
    kind: v.literal("perspective"),
    position: point,
    rotation,
    fov: v.pipe(
      v.number("must be a number of degrees"),
      v.gtValue(0, "must be above 0 degrees"),
      v.ltValue(180, "must be below 180 degrees"),
      v.check(isAbove0, "must be above 0 degrees"),
      v.check(isBelow180, "must be below 180 degrees"),
    ),
    aspect: length,
    near: length,
    far: length,
  }),
  v.forward(
    v.check(({ near, far }) => near < far, "must be above near"),
    ["far"],
  ),
);

const cylindrical = strict({
  kind: v.literal("cylindrical"),
  position: point,
  rotation,
  radius: length,
  height: length,
  arc: v.pipe(
    v.number("must be a number of degrees"),
    v.gtValue(0, "must be above 0 degrees"),
    v.check(isAbove0, "must be above 0 degrees"),
    v.maxValue(360, "must be at most 360 degrees"),
  ),
  depth: length,
});

const uv = strict({
  kind: v.literal("uv"),
  center: listOfNumbers([coordinate, coordinate]),
  size: listOfNumbers([length, length]),
  angle: coordinate,
});

const projectorMessage = (issue: { readonly expected: string | null }): string =>
  issue.expected === "Object" ? "must be an object" : 'must be one of "planar", "perspective", "cylindrical", "uv"';

const projector = v.variant("kind", [planar, perspective, cylindrical, uv], projectorMessage);

/** What dabs and brushes have. */
const flow = { flow: v.optional(numberBetween(0, 1), BRUSH_DEFAULTS.flow) };

const dab = v.variant(
  "kind",
  [
    strict({ ...planar.entries, ...flow }),
    v.pipe(
      strict({ ...perspective.entries, ...flow }),
      v.forward(
        v.check(({ near, far }) => near < far, "must be above near"),
        ["far"],
      ),
    ),
    strict({ ...cylindrical.entries, ...flow }),
    strict({ ...uv.entries, ...flow }),
  ],
  projectorMessage,
);

const hexColor = v.pipe(
  v.string('must be a colour as "#rrggbb" or "#rrggbbaa"'),
  v.regex(HEX_COLOR, 'must be a colour as "#rrggbb" or "#rrggbbaa"'),
);

const materialMessage = "must be a glTF material index: a whole number, 0 or above";
const materialIndex = v.pipe(
  v.number(materialMessage),
  v.integer(materialMessage),
  v.minValue(0, materialMessage),
  v.maxValue(DESIGN_LIMITS.materials - 1, `must be at most ${DESIGN_LIMITS.materials - 1}`),
);
const materialList = v.pipe(
  boundedList(DESIGN_LIMITS.materials, "materials", materialIndex),
  v.nonEmpty("must name one material at least"),
  v.check((materials) => new Set(materials).size === materials.length, "must not name a material twice"),
  // For the published JSON Schema, which has a word for the check above.
  v.metadata({ uniqueItems: true }),
);
const material = v.union([materialIndex, materialList], `${materialMessage}, or a list of such`);
const angle = numberBetween(0, 90, " degrees");
const assetName = v.pipe(
  filledText(DESIGN_LIMITS.idLength),
  v.notValues(RESERVED_KEYS, `must not be ${RESERVED_KEYS.map((key) => `"${key}"`).join(" or ")}`),
);

const layerEntries = {
  id: v.optional(filledText(DESIGN_LIMITS.idLength)),
  name: v.optional(text(DESIGN_LIMITS.nameLength)),
  material: v.optional(material, LAYER_DEFAULTS.material),
  visible: v.optional(flag, LAYER_DEFAULTS.visible),
  opacity: v.optional(numberBetween(0, 1), LAYER_DEFAULTS.opacity),
  blend: v.optional(oneOf(BLEND_MODES), LAYER_DEFAULTS.blend),
  blendSpace: v.optional(oneOf(BLEND_SPACES), LAYER_DEFAULTS.blendSpace),
  lockAlpha: v.optional(flag, LAYER_DEFAULTS.lockAlpha),
};

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

const decal = strict({
  type: v.literal("decal"),
  ...layerEntries,
  asset: assetName,
  ...projectedEntries,
  ...pictureEntries,
  projector,
});

const textLayer = strict({
  type: v.literal("text"),
  ...layerEntries,
  text: text(DESIGN_LIMITS.textLength),
  font: assetName,
  fontSize: v.optional(length, 1),
  color: v.optional(hexColor, "#000000"),
  outline: v.optional(v.nullable(strict({ color: hexColor, width: length })), null),
  ...projectedEntries,
  ...pictureEntries,
  projector,
});

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

const stroke = strict({
  type: v.literal("stroke"),
  ...layerEntries,
  brush,
  dabs: boundedList(DESIGN_LIMITS.dabs, "dabs", dab),
  ...projectedEntries,
  ...pictureEntries,
});

const fill = strict({ type: v.literal("fill"), ...layerEntries, color: hexColor });

const layer = v.variant("type", [decal, textLayer, stroke, fill], (issue) =>
  issue.expected === "Object" ? "must be an object" : 'must be one of "decal", "text", "stroke", "fill"',
);

/** The count is checked before the items are, so a list of millions costs no more than its reading. */
function boundedList<Item extends v.GenericSchema>(max: number, noun: string, item: Item) {
  return v.pipe(
    v.array(v.unknown(), "must be a list"),
    v.maxLength(max, `must not hold more than ${max} ${noun}`),
    v.array(item),
  );
}

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
  layer,
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

/** A layer as the schema leaves it: ids and names may still be missing. */
export type ParsedLayer = v.InferOutput<typeof layer>;
export type ParsedDesign = v.InferOutput<typeof designSchema>;
