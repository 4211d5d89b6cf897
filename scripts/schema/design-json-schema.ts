/** The design document's JSON Schema. */
import type { JsonSchema } from "@valibot/to-json-schema";
import { designParts, designSchema } from "../../web/editor/document/design-schema.ts";
import { documentJsonSchema } from "./document-json-schema.ts";

export function designJsonSchema(): JsonSchema {
  return documentJsonSchema({
    title: "Texelcast design, version 1",
    description:
      "Which pictures lie where on a model, in which order, and how they mix. Beyond this schema the reader refuses ids " +
      "that occur twice, assets that are not there or of the wrong kind, and what descriptions below say.",
    schema: designSchema,
    parts: designParts,
  });
}
