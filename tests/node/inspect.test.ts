import { writeFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { plainPng, planeGlb } from "./plane-model.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

async function inspect(glb: Uint8Array, ...args: string[]) {
  const folder = temporaryFolder();
  writeFileSync(path.join(folder, "plane.glb"), glb);
  return texelcast(["inspect", "plane.glb", ...args], { cwd: folder });
}

describe("texelcast inspect", () => {
  it("prints a table for people, with the reason below where a material cannot take decals", async () => {
    const { code, stdout, stderr } = await inspect(planeGlb({ texture: await plainPng(64, 32, [9, 9, 9, 255]) }));
    expect({ code, stderr }).toEqual({ code: 0, stderr: "" });
    const lines = stdout.split("\n");
    expect(lines[0]).toBe("plane.glb: 2 triangles, 4 vertices, 2 materials");
    expect(lines[1]).toBe("bounds (-2, 0.5, -1) to (2, 0.5, 1) m");
    expect(lines[3]).toMatch(
      /^material +name +triangles +texture +UV coverage +overlap +out of range +degenerate +decals$/,
    );
    expect(lines[4]).toMatch(/^ +0 +paint +2 +64 x 32 +25\.0 % +0\.0 % +0 +0 +yes$/);
    expect(lines[5]).toMatch(/^ +1 +of no triangle +0 +none +- +- +0 +0 +NO$/);
    expect(lines[7]).toMatch(/^material 1 cannot take decals: .*triangle.* \(no-triangles\)$/);
  });

  it("prints one JSON object for programs, the same each time", async () => {
    const glb = planeGlb({ texture: await plainPng(64, 32, [9, 9, 9, 255]) });
    const [first, second] = await Promise.all([inspect(glb, "--json"), inspect(glb, "--json")]);
    expect(second.stdout).toBe(first.stdout);
    expect(JSON.parse(first.stdout)).toEqual({
      file: "plane.glb",
      triangles: 2,
      vertices: 4,
      bounds: { min: [-2, 0.5, -1], max: [2, 0.5, 1] },
      materials: [
        {
          index: 0,
          name: "paint",
          canTakeDecals: true,
          refusal: null,
          triangles: 2,
          textureSize: [64, 32],
          uv: {
            set: 0,
            min: [0.25, 0.25],
            max: [0.75, 0.75],
            outOfRangeTriangles: 0,
            degenerateTriangles: 0,
            measured: { size: [64, 32], coverage: 0.25, overlap: 0 },
          },
          bounds: { min: [-2, 0.5, -1], max: [2, 0.5, 1] },
        },
        expect.objectContaining({
          index: 1,
          name: "of no triangle",
          canTakeDecals: false,
          refusal: { code: "no-triangles", message: expect.stringContaining("triangle") },
          textureSize: null,
          uv: expect.objectContaining({ measured: null }),
        }),
      ],
    });
  });

  it("succeeds for a model without texture coordinates, and says NO and why", async () => {
    const { code, stdout } = await inspect(planeGlb({ withoutUvs: true }));
    expect(code).toBe(0);
    expect(stdout).toMatch(/ NO$/m);
    expect(stdout).toMatch(/^material 0 cannot take decals: .*texture coordinates.* \(no-uvs\)$/m);
  });

  it("does not let a material's name write to the terminal", async () => {
    const glb = planeGlb({
      edit: (gltf) => {
        (gltf.materials as { name: string }[])[0] = { name: "\u001b]0;gone\u0007" };
      },
    });
    const { stdout } = await inspect(glb);
    expect(stdout).not.toContain("\u001b");
    expect(stdout).toContain("\\u001b]0;gone\\u0007");
  });
});
