/** Zones as an engine is given them: a file of them is read by the document's own parser, a script may give anything. */
import {
  ABOVE_ZERO,
  between,
  checkFields,
  checkValue,
  LIST,
  numbers,
  OBJECT,
  oneOf,
  type Rule,
  TEXT,
} from "./check-value.ts";
import type { PrintZones } from "./print-zones.ts";

const DISTANCE = between(0, Number.MAX_VALUE);
const MATERIAL: Rule = { must: "a material's index", holds: (value) => Number.isInteger(value) && Number(value) >= 0 };
const ZONE = {
  id: TEXT,
  name: TEXT,
  material: MATERIAL,
  shape: OBJECT,
  safe: DISTANCE,
  bleed: DISTANCE,
  policy: oneOf("clip", "warn"),
};
const BOX = { position: numbers(3), rotation: numbers(4), size: numbers(3) };

/** @throws TexelcastError "bad-argument" with the field ("zones.zones[0].shape.size") and the value. */
export function checkZones(given: PrintZones): void {
  checkFields(given, { printScale: ABOVE_ZERO, dpi: OBJECT, zones: LIST }, "zones");
  checkFields(given.dpi, { least: ABOVE_ZERO, good: ABOVE_ZERO }, "zones.dpi");
  for (const [index, zone] of given.zones.entries()) {
    const field = `zones.zones[${index}]`;
    checkFields(zone, ZONE, field);
    const { shape } = zone;
    checkFields(shape, { kind: oneOf("uv", "box") }, `${field}.shape`);
    if (shape.kind === "box") {
      checkFields(shape, BOX, `${field}.shape`);
      continue;
    }
    checkFields(shape, { polygon: LIST }, `${field}.shape`);
    for (const [at, corner] of shape.polygon.entries()) {
      checkValue(corner, numbers(2), `${field}.shape.polygon[${at}]`);
    }
  }
}
