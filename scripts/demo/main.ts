/** Writes the demo's models, decals and index to build/public/demo, and what the example shop sells to build/public/shop. */

import { mkdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { type DemoFile, generateDemo } from "./generate.ts";
import { generateShop } from "./shop/generate.ts";

const started = performance.now();
await write("demo", generateDemo());
await write("shop", generateShop());
console.log(`demo: written to build/public in ${((performance.now() - started) / 1000).toFixed(1)} s`);

async function write(name: string, files: AsyncGenerator<DemoFile>): Promise<void> {
  const folder = fileURLToPath(new URL(`../../build/public/${name}/`, import.meta.url));
  for await (const { path, bytes } of files) {
    const target = join(folder, path);
    await mkdir(dirname(target), { recursive: true });
    await writeFile(target, bytes);
    console.log(`${name}/${path}  ${(bytes.length / 1024).toFixed(0)} KiB`);
  }
}
