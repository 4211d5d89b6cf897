/** Writes the demo models, decals and their index to build/public/demo. */

import { mkdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { generateDemo } from "./generate.ts";

const folder = fileURLToPath(new URL("../../build/public/demo/", import.meta.url));
const started = performance.now();
for await (const { path, bytes } of generateDemo()) {
  const target = join(folder, path);
  await mkdir(dirname(target), { recursive: true });
  await writeFile(target, bytes);
  console.log(`${path}  ${(bytes.length / 1024).toFixed(0)} KiB`);
}
console.log(`demo: written to build/public/demo in ${((performance.now() - started) / 1000).toFixed(1)} s`);
