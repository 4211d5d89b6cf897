/** `texelcast schema`: the design document's JSON Schema, as the package publishes it. */
import { readFile } from "node:fs/promises";

/** Beside the bundle's folder in the package and in a checkout's build/. */
const FILE = new URL("../design.schema.json", import.meta.url);

export async function schema(): Promise<void> {
  process.stdout.write(await readFile(FILE));
}
