/** `texelcast unwrap` as a user runs it. */
import { writeFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { buildGlb, plane } from "../support/model-builder.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

/** Two squares on the same texels. */
function folderWithTwins(): string {
  const folder = temporaryFolder();
  const glb = buildGlb({ meshes: [plane(1, 0), plane(2, 0)], materials: [{ name: "Paint" }, { name: "Unused" }] });
  writeFileSync(path.join(folder, "twins.glb"), glb);
  return folder;
}

describe("texelcast unwrap", () => {
  it("writes a model that shares no texels, and says what it was before", async () => {
    const cwd = folderWithTwins();
    const run = await texelcast(["unwrap", "twins.glb", "--out", "apart.glb", "--size", "256"], { cwd });
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toMatch(
      /material 0 "Paint": 4 triangles in \d charts?, 256 x 256 texels, TEXCOORD_1\n.*, 0\.0 % now/,
    );
    const inspected = await texelcast(["inspect", "apart.glb", "--json"], { cwd });
    expect(JSON.parse(inspected.stdout).materials[0].uv).toMatchObject({ set: 1, measured: { overlap: 0 } });
  });

  it("takes what has coordinates of no use, as those of a palette's one pixel, without being told", async () => {
    const cwd = temporaryFolder();
    const onePixel = { ...plane(), uvs: [0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5] };
    writeFileSync(path.join(cwd, "palette.glb"), buildGlb({ meshes: [onePixel] }));
    const run = await texelcast(["unwrap", "palette.glb", "--out", "apart.glb", "--size", "256"], { cwd });
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toContain("material 0");
    const inspected = await texelcast(["inspect", "apart.glb", "--json"], { cwd });
    expect(JSON.parse(inspected.stdout).materials[0]).toMatchObject({
      canTakeDecals: true,
      uv: { degenerateTriangles: 0 },
    });
  });

  it("gives a texture of its own to what repeats its texture too often to be painted, which inspect tells beside what can be", async () => {
    const cwd = temporaryFolder();
    const tiled = { ...plane(1, 1), uvs: [0, 300, 300, 300, 300, 0, 0, 0] };
    writeFileSync(
      path.join(cwd, "tiled.glb"),
      buildGlb({ meshes: [plane(1, 0), tiled], materials: [{ name: "Paint" }, { name: "Brick" }] }),
    );
    const inspected = await texelcast(["inspect", "tiled.glb", "--json"], { cwd });
    expect(inspected).toMatchObject({ code: 0, stderr: "" });
    expect(JSON.parse(inspected.stdout).materials).toMatchObject([
      { canTakeDecals: true, refusal: null },
      {
        canTakeDecals: false,
        refusal: { code: "bad-uvs", message: expect.stringContaining("256 times") },
        uv: { measured: null },
      },
    ]);
    const run = await texelcast(["unwrap", "tiled.glb", "--out", "apart.glb", "--size", "64"], { cwd });
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toContain('material 1 "Brick"');
    const again = await texelcast(["inspect", "apart.glb", "--json"], { cwd });
    expect(JSON.parse(again.stdout).materials).toMatchObject([{ canTakeDecals: true }, { canTakeDecals: true }]);
  });

  it("says so where nothing is shared, and which materials there are", async () => {
    const cwd = folderWithTwins();
    await texelcast(["unwrap", "twins.glb", "--out", "apart.glb", "--size", "256"], { cwd });
    const again = await texelcast(["unwrap", "apart.glb", "--out", "again.glb"], { cwd });
    expect(again).toMatchObject({ code: 3, stdout: "" });
    expect(again.stderr).toContain("no material shares texels");
    const other = await texelcast(["unwrap", "twins.glb", "--out", "apart.glb", "--material", "5"], { cwd });
    expect(other.code).toBe(3);
    expect(other.stderr).toContain("the model has no material 5");
  });

  it("refuses a name that is no GLB, a size below 64, and its own input as output", async () => {
    const cwd = folderWithTwins();
    for (const args of [
      ["--out", "x.png"],
      ["--out", "x.glb", "--size", "8"],
      ["--out", "twins.glb"],
    ]) {
      expect((await texelcast(["unwrap", "twins.glb", ...args], { cwd })).code, args.join(" ")).toBe(2);
    }
  });
});
