/** `texelcast schema`: the JSON Schemas of designs and zones files, as the package publishes them. */
import { readFile } from "node:fs/promises";

export interface SchemaOptions {
  readonly zones?: true;
}

/** Prints the one of designs, or with `zones` that of zones files. */
export async function schema({ zones }: SchemaOptions): Promise<void> {
  // Beside the bundle's folder in the package and in a checkout's build/.
  const file = new URL(zones ? "../zones.schema.json" : "../design.schema.json", import.meta.url);
  process.stdout.write(await readFile(file));
}
