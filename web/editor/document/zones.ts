/** Zones files: the print areas of a product, read and checked. Beside the product's model, one file each. */
import * as v from "valibot";
import { NO_ZONES, type PrintZones } from "../../engine/print-zones.ts";
import { DESIGN_LIMITS, RESERVED_KEYS } from "./design-limits.ts";
import { type DesignProblem, designError } from "./design-problem.ts";
import { parseJson } from "./parse-json.ts";
import {
  boundedList,
  filledText,
  length,
  listOfNumbers,
  materialIndex,
  numberBetween,
  oneOf,
  point,
  rotation,
  strict,
  text,
} from "./schema-parts.ts";

export type { BoxZoneShape, PrintZone, PrintZones, UvZoneShape, ZonePolicy } from "../../engine/print-zones.ts";

export const ZONES_VERSION = 1;

/** Bounds that no honest product meets. */
export const ZONES_LIMITS = { zones: 100, corners: 1000, millimetres: 10_000 } as const;

const share = numberBetween(0, 1);
const millimetres = numberBetween(0, ZONES_LIMITS.millimetres, " millimetres");
const dots = numberBetween(1, 10_000, " dots an inch");

/** Twice the area; 0 for corners that lie on one line. */
function doubledArea(polygon: readonly (readonly number[])[]): number {
  return polygon.reduce((sum, corner, index) => {
    const next = polygon[(index + 1) % polygon.length] ?? corner;
    return sum + (corner[0] as number) * (next[1] as number) - (next[0] as number) * (corner[1] as number);
  }, 0);
}

const polygon = v.pipe(
  boundedList(ZONES_LIMITS.corners, "corners", listOfNumbers([share, share])),
  v.minLength(3, "must have three corners at least"),
  v.check((corners) => doubledArea(corners) !== 0, "must enclose an area"),
);

const shape = v.variant(
  "kind",
  [
    strict({ kind: v.literal("uv"), polygon }),
    strict({
      kind: v.literal("box"),
      position: point,
      rotation: v.optional(rotation, () => [0, 0, 0, 1] as [number, number, number, number]),
      size: listOfNumbers([length, length, length]),
    }),
  ],
  (issue) => (issue.expected === "Object" ? "must be an object" : 'must be one of "uv", "box"'),
);

const zone = strict({
  id: v.pipe(
    filledText(DESIGN_LIMITS.idLength),
    v.notValues(RESERVED_KEYS, `must not be ${RESERVED_KEYS.map((key) => `"${key}"`).join(" or ")}`),
  ),
  name: v.optional(text(DESIGN_LIMITS.nameLength)),
  material: v.optional(materialIndex, 0),
  shape,
  safe: v.optional(millimetres, 0),
  bleed: v.optional(millimetres, 0),
  policy: v.optional(oneOf(["clip", "warn"]), "clip"),
});

/** For the published JSON Schema. @internal */
export const zonesSchema = strict({
  texelcastZones: v.literal(ZONES_VERSION, `must be ${ZONES_VERSION}`),
  printScale: v.optional(length, NO_ZONES.printScale),
  dpi: v.optional(
    v.pipe(
      strict({ least: v.optional(dots, NO_ZONES.dpi.least), good: v.optional(dots, NO_ZONES.dpi.good) }),
      v.check(({ least, good }) => least <= good, "must not have a “least” above its “good”"),
    ),
    () => ({ ...NO_ZONES.dpi }),
  ),
  zones: v.pipe(
    boundedList(ZONES_LIMITS.zones, "zones", zone),
    v.check((zones) => new Set(zones.map(({ id }) => id)).size === zones.length, "must not hold two zones of one id"),
  ),
});

/** The parts of the schema that the published JSON Schema gives definitions of their own. @internal */
export const zonesParts = { zone, shape, polygon, point, rotation, length };

/**
 * Reads a zones file.
 *
 * @param source JSON text, or the data that such text holds.
 * @param name The file's name as the user knows it; errors name it.
 * @throws TexelcastError "bad-zones": `field` and `value` are those of the first problem, the message tells them all.
 */
export function parseZones(source: unknown, name = "the zones file"): PrintZones {
  const data = typeof source === "string" ? parseJson(source, name, "the zones file", "bad-zones") : source;
  const result = v.safeParse(zonesSchema, data);
  if (!result.success) {
    const hint = "The fields of a zones file are described in docs/print-truth.md.";
    throw designError(name, result.issues.map(problemOf), hint, "bad-zones", "the zones file");
  }
  const { zones, ...rest } = result.output;
  return { ...rest, zones: zones.map((one) => ({ ...one, name: one.name ?? one.id })) };
}

function problemOf(issue: v.BaseIssue<unknown>): DesignProblem {
  const path = (issue.path ?? []).map((item) => item.key as string | number);
  const unknownField = issue.type === "strict_object" && issue.expected === "never";
  return { path, message: issue.message, ...(unknownField ? {} : { value: issue.input }) };
}
