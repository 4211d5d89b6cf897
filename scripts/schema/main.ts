/** Writes build/design.schema.json and build/zones.schema.json, which the package publishes and `texelcast schema` prints. */
import { mkdirSync, writeFileSync } from "node:fs";
import { printJson } from "../../web/editor/document/print-json.ts";
import { BUILD, inRoot } from "../bootstrap/paths.mjs";
import { designJsonSchema } from "./design-json-schema.ts";
import { zonesJsonSchema } from "./zones-json-schema.ts";

mkdirSync(BUILD, { recursive: true });
writeFileSync(inRoot("build/design.schema.json"), printJson(designJsonSchema()));
writeFileSync(inRoot("build/zones.schema.json"), printJson(zonesJsonSchema()));
