/** What the installed package makes of a shop's own models on a server: all of its decoders come along and run there. */
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { renderPrint } from "../../node/print.ts";
import { avifFile, avifModel } from "../support/avif-file.ts";
import { compressedModels } from "../support/compressed-models.ts";
import { ktx2File, ktx2Model, softPicture } from "../support/ktx2-file.ts";
import { buildGlb, cube } from "../support/model-builder.ts";
import { type InstalledPackage, installPackage, runInNode } from "./support/installed.ts";

let installed: InstalledPackage;
let models: Readonly<Record<"draco" | "meshopt" | "KTX2" | "AVIF", Uint8Array>>;
beforeAll(async () => {
  const geometry = await compressedModels(buildGlb({ meshes: [cube(0)], materials: [{ name: "sides" }] }));
  models = {
    ...geometry,
    KTX2: ktx2Model(await ktx2File(softPicture(32, 32), "ETC1S")),
    AVIF: avifModel(await avifFile(softPicture(32, 32), 70)),
  };
  installed = await installPackage();
});
afterAll(() => installed.remove());

const DESIGN = { format: "texelcast-design", version: 1, layers: [{ type: "fill", color: "#123456", opacity: 0.5 }] };

test.each(["draco", "meshopt", "KTX2", "AVIF"] as const)(
  "a model compressed by %s is printed as in a checkout",
  async (way) => {
    const { sha256 } = await renderPrint({ model: models[way], design: DESIGN, size: 64 });
    writeFileSync(join(installed.folder, `${way}.glb`), models[way]);
    const options = { model: `${way}.glb`, design: DESIGN, size: 64 };
    const script = `
    const { renderPrint } = await import("texelcast/node");
    console.log((await renderPrint(${JSON.stringify(options)})).sha256);`;
    expect(await runInNode(installed.folder, script)).toBe(sha256);
  },
);
