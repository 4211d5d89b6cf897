import { existsSync, writeFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { readFileBytes } from "../../node/read-file.ts";
import { parseDesign } from "../../web/editor/document/index.ts";
import { writeProjectFile } from "../../web/editor/document/project-file.ts";
import { buildGlb, plane } from "../support/model-builder.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

const DESIGN = { format: "texelcast-design", version: 1, layers: [{ type: "fill", color: "#ff0000" }] };

/** A folder with a model that repeats its texture too often, a design, and a project that holds a broken model. */
function folder(): string {
  const place = temporaryFolder();
  const tiled = { ...plane(1, 0), uvs: [0, 300, 300, 300, 300, 0, 0, 0] };
  writeFileSync(path.join(place, "tiled.glb"), buildGlb({ meshes: [tiled], materials: [{ name: "Brick" }] }));
  writeFileSync(path.join(place, "design.json"), JSON.stringify(DESIGN));
  const broken = writeProjectFile({
    name: "shoe",
    design: parseDesign(DESIGN),
    assetBytes: () => undefined,
    targets: [],
    model: { title: "shoe.glb", demo: null, source: { name: "shoe.glb", bytes: new TextEncoder().encode("no model") } },
  });
  writeFileSync(path.join(place, "shoe.texelcast"), broken);
  return place;
}

describe("a model that cannot be used", () => {
  it.each([
    ["bake", ["bake", "tiled.glb", "--out", "maps", "--size", "8"]],
    ["render", ["render", "tiled.glb", "design.json", "--out", "x.png", "--size", "8"]],
    ["print", ["print", "tiled.glb", "design.json", "--out", "x.png", "--size", "8"]],
  ])("is named by texelcast %s where it repeats its texture too often, with what to do", async (_command, args) => {
    const { code, stderr } = await texelcast(args, { cwd: folder() });
    expect(stderr).toMatch(/^texelcast: tiled\.glb: .*256 times.*\n {2}.*texelcast unwrap/);
    expect(code).toBe(3);
  });

  it("is named with the project that it is in", async () => {
    const { code, stderr } = await texelcast(["render", "shoe.texelcast", "--out", "x.png"], { cwd: folder() });
    expect(stderr).toContain("shoe.texelcast#shoe.glb");
    expect(code).toBe(3);
  });
});

describe.runIf(existsSync("/proc/self/status"))("a file that the system makes up as it is read", () => {
  it("is taken for empty, since one may never end", async () => {
    expect((await readFileBytes("/proc/self/status", { code: "bad-model" })).length).toBe(0);
  });
});
