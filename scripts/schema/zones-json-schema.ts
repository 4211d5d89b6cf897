/** The zones file's JSON Schema. */
import type { JsonSchema } from "@valibot/to-json-schema";
import { zonesParts, zonesSchema } from "../../web/editor/document/zones.ts";
import { documentJsonSchema } from "./document-json-schema.ts";

export function zonesJsonSchema(): JsonSchema {
  return documentJsonSchema({
    title: "Texelcast zones, version 1",
    description: "Where a product may be printed: its zones, the scale of the print, and how fine it must be.",
    schema: zonesSchema,
    parts: zonesParts,
  });
}
