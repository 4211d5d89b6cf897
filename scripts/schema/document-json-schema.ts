/**
 * A document's shape as JSON Schema, draft 2020-12, made from the valibot schema that reads it: it has no
 * rules of its own, so the two cannot part. It describes what may stand in a file (fields with a default may be
 * left out), for editors and for programs in other languages.
 */
import { type ConversionConfig, type JsonSchema, toJsonSchema } from "@valibot/to-json-schema";
import type { GenericSchema } from "valibot";

export interface DocumentSchema {
  readonly title: string;
  readonly description: string;
  readonly schema: GenericSchema;
  /** Parts that a reader knows by name: definitions of their own. */
  readonly parts: NonNullable<ConversionConfig["definitions"]>;
}

/** Kinds of valibot that JSON Schema has no word for, and what stands for them. All others must convert by themselves. */
const STAND_INS: Readonly<Record<string, JsonSchema>> = { custom: { type: "object" } };

const conversion: ConversionConfig = {
  target: "draft-2020-12",
  // Lists are checked in two steps, the count before the items, which the converter warns of though it joins them right.
  // What it truly cannot convert is thrown below.
  errorMode: "ignore",
  overrideSchema: ({ valibotSchema, jsonSchema, errors }) => {
    if (valibotSchema.type === "tuple") return { ...jsonSchema, items: false };
    if (errors === undefined) return jsonSchema;
    const standIn = STAND_INS[valibotSchema.type];
    if (standIn === undefined) throw new Error(errors.join(" "));
    return { ...jsonSchema, ...standIn };
  },
  overrideAction: ({ valibotAction, jsonSchema, errors }) => {
    if (errors === undefined) return jsonSchema;
    // The converter knows `maxLength` alone, which counts otherwise than JSON Schema does.
    if (valibotAction.type === "max_code_points") return { ...jsonSchema, maxLength: requirementOf(valibotAction) };
    if (valibotAction.type !== "check") throw new Error(errors.join(" "));
    // JSON Schema runs no code: what only code can check is told in words.
    const { description } = jsonSchema;
    const rule = messageOf(valibotAction);
    return {
      ...jsonSchema,
      description: description === undefined ? `Checked by the reader: ${rule}` : `${description}; ${rule}`,
    };
  },
};

function messageOf(action: object): string {
  const message = "message" in action ? action.message : undefined;
  if (typeof message !== "string") throw new Error("A check of the schema has no message.");
  return message;
}

function requirementOf(action: object): number {
  if ("requirement" in action && typeof action.requirement === "number") return action.requirement;
  throw new Error("A bound of the schema has no number.");
}

/** @throws Error where the valibot schema holds something that has no counterpart here: name it above. */
export function documentJsonSchema({ title, description, schema, parts }: DocumentSchema): JsonSchema {
  const { $schema, ...shape } = toJsonSchema(schema, { ...conversion, definitions: parts });
  return { $schema, title, description, ...shape } as JsonSchema;
}
