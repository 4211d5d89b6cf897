/**
 * What the design's schema is put together from: bounds, and the schemas of numbers, colours, projectors and materials.
 *
 * Messages are written to stand between a path and a value: "layers[2].opacity: must be a number from 0 to 1, is 3".
 */
import * as v from "valibot";
import { BRUSH_DEFAULTS } from "./design.ts";
import { DESIGN_LIMITS, RESERVED_KEYS } from "./design-limits.ts";
import { HEX_COLOR } from "./hex-color.ts";

const quoted = (values: readonly string[]): string => values.map((value) => `"${value}"`).join(", ");

type Run = v.GenericSchema["~run"];

/**
 * An object that refuses what it does not know, all of it by name, and says what it does.
 *
 * @param missing what is said of fields that are not there, behind what they must be
 */
export function strict<const Entries extends v.ObjectEntries>(
  entries: Entries,
  missing: Readonly<Record<string, string>> = {},
) {
  const names = Object.keys(entries).join(", ");
  const told = new Map<string, string>();
  const schema = v.strictObject(entries, (issue) => {
    if (issue.expected === "never") return `is not a known field (known here: ${names})`;
    if (issue.expected === "Object") return "must be an object";
    // The field's name, as JSON: what it must be is what its own schema says of nothing.
    const name = JSON.parse(issue.expected ?? "") as string;
    // Kept: a hundred thousand dabs may lack it.
    if (!told.has(name)) {
      const [first] = v.safeParse(entries[name] as v.GenericSchema, undefined).issues ?? [];
      told.set(name, `${first?.message}${missing[name] ?? ""}`);
    }
    return told.get(name) as string;
  });
  return Object.assign(schema, {
    "~run": strictly(schema as unknown as v.GenericSchema, new Set(Object.keys(entries))),
  });
}

/** Unknown fields of one object: more are not told anyway, and millions took minutes. */
const MOST_UNKNOWN = 100;

/** The library takes a list for an object, and names the first unknown field only. */
function strictly(schema: v.GenericSchema, known: ReadonlySet<string>): Run {
  const run = schema["~run"].bind(schema);
  return (dataset, config) => {
    const { value: input } = dataset;
    if (Array.isArray(input)) {
      // Refused as null is, but for what is said to stand there.
      const refused = run({ ...dataset, value: null }, config);
      for (const issue of refused.issues ?? []) Object.assign(issue, { input });
      return refused;
    }
    const result = run(dataset, config);
    if (typeof input !== "object" || input === null) return result;
    const unknown = Object.keys(input).filter((key) => !known.has(key));
    const others = unknown.slice(1, MOST_UNKNOWN);
    for (const key of others) {
      const value = (input as Record<string, unknown>)[key];
      const path = [{ type: "object", origin: "key", input, key, value }] as const;
      v._addIssue(
        schema as never,
        "key",
        result as never,
        config as never,
        { input: key, expected: "never", path } as never,
      );
    }
    return result;
  };
}

/** Where a check that failed is told, in place of where it stands. */
type Place = Partial<Pick<v.BaseIssue<unknown>, "input" | "path">>;

/**
 * A check that is told at the places that `placesOf` names. No `rawCheck` of the library's, which would have no message for the JSON
 * Schema to tell; and the library's own `forward` looks through all faults so far for each of them: a list of a hundred thousand faulty
 * dabs took minutes.
 */
function checkToldAt<Input>(
  isRight: (input: Input) => boolean,
  message: string,
  placesOf: (input: Input) => readonly Place[],
): v.CheckAction<Input, string> {
  const action = v.check(isRight, message);
  const run = action["~run"];
  return {
    ...action,
    "~run"(dataset, config) {
      const known = dataset.issues?.length ?? 0;
      const result = run.call(action, dataset, config);
      const [issue] = result.issues?.splice(known) ?? [];
      if (issue === undefined) return result;
      for (const place of placesOf(result.value as Input)) result.issues?.push({ ...issue, ...place } as never);
      return result;
    },
  };
}

/** A check of each of a list against the one before it, told at a field of all that are at fault. */
export function checkEach<Item extends object>(
  key: keyof Item & string,
  isRight: (item: Item, before: Item | undefined) => boolean,
  message: string,
): v.CheckAction<Item[], string> {
  const isRightAt = (list: readonly Item[], index: number) => isRight(list[index] as Item, list[index - 1]);
  return checkToldAt(
    (list) => list.every((_, index) => isRightAt(list, index)),
    message,
    (list) =>
      list.flatMap((item, index) => {
        if (isRightAt(list, index)) return [];
        const input = item[key];
        return [{ input, path: [pathItem(list, index, item), pathItem(item, key, input)] }];
      }),
  );
}

/** A check of several fields, told at one of them. */
export function checkAt<Input extends object>(
  key: keyof Input & string,
  isRight: (input: Input) => boolean,
  message: string,
): v.CheckAction<Input, string> {
  return checkToldAt(isRight, message, (input) => [{ path: [pathItem(input, key, input[key])] }]);
}

const pathItem = (input: unknown, key: unknown, value: unknown): v.UnknownPathItem => ({
  type: "unknown",
  origin: "value",
  input,
  key,
  value,
});

export const oneOf = <const Values extends readonly [string, ...string[]]>(values: Values) =>
  v.picklist(values, `must be one of ${quoted(values)}`);

export const flag = v.boolean("must be true or false");

export function numberBetween(min: number, max: number, unit = "") {
  const message = `must be a number from ${min} to ${max}${unit}`;
  return v.pipe(v.number(message), v.minValue(min, message), v.maxValue(max, message));
}

/** Characters are counted as JSON Schema counts them, in code points. */
export const text = (most: number) =>
  v.pipe(v.string("must be a string"), v.maxCodePoints(most, `must not be longer than ${most} characters`));
export const filledText = (most: number) => v.pipe(text(most), v.nonEmpty("must not be empty"));

/** A list of exactly `length` numbers. The length is checked first, so a short list is one problem and not several. */
export function listOfNumbers<const Items extends [v.GenericSchema<number>, ...v.GenericSchema<number>[]]>(
  items: Items,
) {
  const message = `must be a list of ${items.length} numbers`;
  return v.pipe(v.array(v.unknown(), message), v.length(items.length, message), v.tuple(items));
}

export const coordinate = numberBetween(-DESIGN_LIMITS.lengthMax, DESIGN_LIMITS.lengthMax);
export const length = v.pipe(
  v.number("must be a number above 0"),
  v.gtValue(0, "must be above 0"),
  v.minValue(DESIGN_LIMITS.lengthMin, `must be at least ${DESIGN_LIMITS.lengthMin}`),
  v.maxValue(DESIGN_LIMITS.lengthMax, `must be at most ${DESIGN_LIMITS.lengthMax}`),
);
export const point = listOfNumbers([coordinate, coordinate, coordinate]);

const quaternionLength = (rotation: readonly number[]): number =>
  Math.sqrt(rotation.reduce((sum, part) => sum + part * part, 0));
const isQuaternion = (rotation: readonly number[]): boolean => {
  const size = quaternionLength(rotation);
  return size >= 1e-3 && size <= 1e3;
};
export const rotation = v.pipe(
  listOfNumbers([coordinate, coordinate, coordinate, coordinate]),
  v.check((q) => quaternionLength(q) > 0, "must not be all zeros: without a rotation it is [0, 0, 0, 1]"),
  v.check(
    (q) => quaternionLength(q) === 0 || isQuaternion(q),
    "must be a unit quaternion x, y, z, w (a length from 0.001 to 1000 is made one)",
  ),
);

// The engine counts in 32-bit floats: what is 0 or 180 degrees there must not pass here. Half the smallest of them is rounded
// to 0, and what lies half way between 180 and the one below it is rounded to 180.
const ROUNDED_TO_0 = 2 ** -150;
const ROUNDED_TO_180 = 180 - 2 ** -17;

export const planar = strict({
  kind: v.literal("planar"),
  position: point,
  rotation,
  size: listOfNumbers([length, length, length]),
});

export const perspective = v.pipe(
  strict({
    kind: v.literal("perspective"),
    position: point,
    rotation,
    fov: v.pipe(
      v.number("must be a number of degrees"),
      v.gtValue(ROUNDED_TO_0, "must be above 0 degrees"),
      v.ltValue(ROUNDED_TO_180, "must be at most 179.99999 degrees"),
    ),
    aspect: length,
    near: length,
    far: length,
  }),
  checkAt("far", ({ near, far }) => near < far, "must be above near"),
);

export const cylindrical = strict({
  kind: v.literal("cylindrical"),
  position: point,
  rotation,
  radius: length,
  height: length,
  arc: v.pipe(
    v.number("must be a number of degrees"),
    v.gtValue(ROUNDED_TO_0, "must be above 0 degrees"),
    v.maxValue(360, "must be at most 360 degrees"),
  ),
  depth: length,
});

export const uv = strict({
  kind: v.literal("uv"),
  center: listOfNumbers([coordinate, coordinate]),
  size: listOfNumbers([length, length]),
  angle: coordinate,
});

const projectorMessage = (issue: { readonly expected: string | null }): string =>
  issue.expected === "Object" ? "must be an object" : 'must be one of "planar", "perspective", "cylindrical", "uv"';

export const projector = v.variant("kind", [planar, perspective, cylindrical, uv], projectorMessage);

/** What dabs and brushes have. */
export const flow = { flow: v.optional(numberBetween(0, 1), BRUSH_DEFAULTS.flow) };

const anyDab = v.variant(
  "kind",
  [
    strict({ ...planar.entries, ...flow }),
    v.pipe(
      strict({ ...perspective.entries, ...flow }),
      checkAt("far", ({ near, far }) => near < far, "must be above near"),
    ),
    strict({ ...cylindrical.entries, ...flow }),
    strict({ ...uv.entries, ...flow }),
  ],
  projectorMessage,
);

const isListWithin = (value: unknown, length: number, least: number): value is number[] => {
  if (!Array.isArray(value) || value.length !== length) return false;
  for (let at = 0; at < length; at++) {
    const number: unknown = value[at];
    if (!(typeof number === "number" && number >= least && number <= DESIGN_LIMITS.lengthMax)) return false;
  }
  return true;
};

/** Inherited ones, too: as the schema, this reads whatever an object has. */
function countFields(value: object): number {
  let count = 0;
  for (const _ in value) count++;
  return count;
}

/** What the schema makes of a planar dab that is right; undefined for all others. */
function rightPlanarDab(value: unknown): v.InferOutput<typeof anyDab> | undefined {
  if (typeof value !== "object" || value === null) return undefined;
  const { kind, position, rotation, size, flow } = value as Readonly<Record<string, unknown>>;
  const isRight =
    kind === "planar" &&
    countFields(value) === 5 &&
    isListWithin(position, 3, -DESIGN_LIMITS.lengthMax) &&
    isListWithin(rotation, 4, -DESIGN_LIMITS.lengthMax) &&
    isListWithin(size, 3, DESIGN_LIMITS.lengthMin) &&
    isQuaternion(rotation) &&
    typeof flow === "number" &&
    flow >= 0 &&
    flow <= 1;
  if (!isRight) return undefined;
  return { kind, position: [...position], rotation: [...rotation], size: [...size], flow } as never;
}

/** Planar ones are told by hand: of a painting's 160,000 dabs the schema took most of the time that the painting's reading did. */
const runAnyDab = anyDab["~run"].bind(anyDab);
export const dab: typeof anyDab = {
  ...anyDab,
  "~run"(dataset, config) {
    const value = rightPlanarDab(dataset.value);
    return value === undefined ? runAnyDab(dataset, config) : { typed: true, value };
  },
};

export const hexColor = v.pipe(
  v.string('must be a colour as "#rrggbb" or "#rrggbbaa"'),
  v.regex(HEX_COLOR, 'must be a colour as "#rrggbb" or "#rrggbbaa"'),
);

const materialMessage = "must be a glTF material index: a whole number, 0 or above";
export const materialIndex = v.pipe(
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
export const material = v.union([materialIndex, materialList], `${materialMessage}, or a list of such`);
export const angle = numberBetween(0, 90, " degrees");
export const assetName = v.pipe(
  filledText(DESIGN_LIMITS.idLength),
  v.notValues(RESERVED_KEYS, `must not be ${RESERVED_KEYS.map((key) => `"${key}"`).join(" or ")}`),
);

/** The count is checked before the items are, so a list of millions costs no more than its reading. */
export function boundedList<Item extends v.GenericSchema>(max: number, noun: string, item: Item) {
  return v.pipe(
    v.array(v.unknown(), "must be a list"),
    v.maxLength(max, `must not hold more than ${max} ${noun}`),
    v.array(item),
  );
}
