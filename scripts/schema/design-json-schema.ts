/** The design document's JSON Schema. */
import type { JsonSchema } from "@valibot/to-json-schema";
import { designParts, designSchema } from "../../web/editor/document/design-schema.ts";
import { fontAddress } from "../../web/engine/font-address.ts";
import { SHIPPED_FONTS } from "../../web/engine/shipped-fonts.ts";
import { documentJsonSchema } from "./document-json-schema.ts";

/** Of an asset's type and address together, which the reader compares once the shape is read. */
const SHIPPED_FONT_RULE: JsonSchema = {
  anyOf: [
    { properties: { uri: { not: { type: "string", pattern: `^${fontAddress("")}` } } } },
    { properties: { type: { const: "font/ttf" }, uri: { enum: Object.keys(SHIPPED_FONTS).map(fontAddress) } } },
  ],
};

export function designJsonSchema(): JsonSchema {
  const { $defs, ...schema } = documentJsonSchema({
    title: "Texelcast design, version 1",
    description:
      "Which pictures lie where on a model, in which order, and how they mix. Beyond this schema the reader refuses ids " +
      "that occur twice, assets that are not there or of the wrong kind, and what descriptions below say.",
    schema: designSchema,
    parts: designParts,
  });
  return { ...schema, $defs: { ...$defs, asset: { ...($defs?.asset as JsonSchema), ...SHIPPED_FONT_RULE } } };
}
