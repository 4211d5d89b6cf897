/** `texelcast variant` as a user runs it. */
import { writeFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { buildModel, plane } from "../support/model-builder.ts";
import { glbWithVariants } from "../support/variant-model.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

/** A square that is red, and blue by night. */
function folderWithVariants(): string {
  const model = buildModel({ meshes: [plane(1, 0)], materials: [{ name: "Red" }, { name: "Blue" }] });
  const folder = temporaryFolder();
  const glb = glbWithVariants(model, ["day", "night"], [[{ material: 1, variants: [1] }]]);
  writeFileSync(path.join(folder, "square.glb"), glb);
  return folder;
}

describe("texelcast variant", () => {
  it("writes a model that shows the variant, which inspect lists", async () => {
    const cwd = folderWithVariants();
    const before = await texelcast(["inspect", "square.glb"], { cwd });
    expect(before.stdout).toContain("variants day (shown), night\n");
    const run = await texelcast(["variant", "square.glb", "--out", "night.glb", "--name", "night"], { cwd });
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toMatch(/^night\.glb: [\d,]+ bytes\n {2}material 1 in place of 0\n$/);
    const after = JSON.parse((await texelcast(["inspect", "night.glb", "--json"], { cwd })).stdout);
    expect(after.variants).toEqual({ names: ["day", "night"], shown: "night" });
    expect(after.materials.map(({ triangles }: { triangles: number }) => triangles)).toEqual([0, 2]);
  });

  it("refuses a name that the model has not, with those that it has, and leaves the output alone", async () => {
    const cwd = folderWithVariants();
    const run = await texelcast(["variant", "square.glb", "--out", "dusk.glb", "--name", "dusk"], { cwd });
    expect(run).toMatchObject({ code: 2, stdout: "" });
    expect(run.stderr).toContain("square.glb: --name: the model has no such variant, “dusk”\n");
    expect(run.stderr).toContain("“day”, “night”");
    expect((await texelcast(["inspect", "dusk.glb"], { cwd })).code).toBe(3);
  });

  it("asks for the variant's name", async () => {
    const run = await texelcast(["variant", "square.glb", "--out", "dusk.glb"], { cwd: folderWithVariants() });
    expect(run).toMatchObject({ code: 2, stdout: "" });
  });

  it("is not needed to render or print one: a variant behind the model's name is its look, under the numbers that designs name", async () => {
    const cwd = folderWithVariants();
    const night = JSON.parse((await texelcast(["inspect", "square.glb#variant=night", "--json"], { cwd })).stdout);
    expect(night.variants).toBeUndefined();
    expect(night.materials[0]).toMatchObject({ index: 0, name: "Blue", triangles: 2 });
    const layers = [{ id: "f", type: "fill", material: 0, color: "#ff0000" }];
    const design = JSON.stringify({ format: "texelcast-design", version: 1, assets: {}, layers });
    writeFileSync(path.join(cwd, "red.json"), design);
    const render = ["render", "square.glb#variant=night", "red.json", "--out", "painted.glb", "--size", "16"];
    expect(await texelcast(render, { cwd })).toMatchObject({ code: 0, stderr: "" });
    const painted = JSON.parse((await texelcast(["inspect", "painted.glb", "--json"], { cwd })).stdout);
    expect(painted.variants).toBeUndefined();
    expect(painted.materials[0]).toMatchObject({ name: "Blue", triangles: 2, textureSize: [16, 16] });
    const run = await texelcast(["inspect", "square.glb#variant=dusk"], { cwd });
    expect(run).toMatchObject({ code: 3, stdout: "" });
    expect(run.stderr).toContain("“square.glb” has no variant “dusk”, but “day”, “night”.");
  });
});
