import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { plainPng, planeGlb, planePosition } from "./plane-model.ts";
import { readNpy } from "./read-npy.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

const UNPAINTABLE =
  'texelcast: plane.glb: --material: material 1 ("of no triangle") cannot be painted: there are no triangles to paint\n' +
  '  Choose one that can: 0 ("paint").\n';

/** Bakes a plane into `maps` and gives the folder's reader. */
async function bakePlane(args: readonly string[], glb = planeGlb()) {
  const folder = temporaryFolder();
  writeFileSync(path.join(folder, "plane.glb"), glb);
  const run = await texelcast(["bake", "plane.glb", "--out", "maps", ...args], { cwd: folder });
  const inMaps = (name: string): string => path.join(folder, "maps", name);
  return { folder, run, inMaps, array: (name: string) => readNpy(inMaps(`${name}.npy`)) };
}

describe("texelcast bake", () => {
  it("writes four arrays and a picture of each, and says so", async () => {
    const { run, inMaps, array } = await bakePlane(["--size", "64"]);
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toBe(
      'plane.glb: material 0 "paint", 64 x 64 texels, gutter 2\n' +
        "  covered  1,024 texels (25.0 %)\n" +
        "  gutter   260 texels (6.3 %)\n" +
        "  overlap  0 texels (0.0 % of the covered)\n" +
        "  written to maps: positions.npy, positions.png, normals.npy, normals.png, " +
        "coverage.npy, coverage.png, overlap.npy, overlap.png\n",
    );
    expect(readdirSync(path.dirname(inMaps("x"))).sort()).toEqual(
      ["coverage", "normals", "overlap", "positions"].flatMap((name) => [`${name}.npy`, `${name}.png`]),
    );
    for (const name of ["positions", "normals"]) {
      expect(array(name)).toMatchObject({ descr: "<f4", shape: [64, 64, 3], headerBytes: 128 });
    }
    for (const name of ["coverage", "overlap"]) {
      expect(array(name)).toMatchObject({ descr: "|u1", shape: [64, 64], headerBytes: 128 });
    }
  });

  it("puts every covered and gutter texel where it lies on the plane, facing up, and leaves the rest at 0", async () => {
    const size = 64;
    const { array } = await bakePlane(["--size", String(size)]);
    const [coverage, overlap] = [array("coverage").values, array("overlap").values];
    const [positions, normals] = [array("positions").values, array("normals").values];
    // spec.md, 2: within 2^-15 of the diagonal of the model, which is 4 m by 2 m.
    const tolerance = Math.hypot(4, 2) / 2 ** 15;
    const counts = [0, 0, 0];
    for (let texel = 0; texel < size * size; texel += 1) {
      const [i, j] = [texel % size, Math.floor(texel / size)];
      const kind = coverage[texel] as number;
      counts[kind] = (counts[kind] as number) + 1;
      const isInside = i >= 16 && i < 48 && j >= 16 && j < 48;
      expect(kind === 1).toBe(isInside);
      expect(overlap[texel]).toBe(isInside ? 1 : 0);
      const position = positions.subarray(3 * texel, 3 * texel + 3);
      const normal = normals.subarray(3 * texel, 3 * texel + 3);
      const expected = kind === 0 ? [0, 0, 0] : planePosition((i + 0.5) / size, (j + 0.5) / size);
      const distance = Math.hypot(...expected.map((part, axis) => part - (position[axis] as number)));
      expect(distance).toBeLessThanOrEqual(tolerance);
      expect(Array.from(normal)).toEqual(
        kind === 0 ? [0, 0, 0] : [expect.closeTo(0, 2), expect.closeTo(1, 4), expect.closeTo(0, 2)],
      );
    }
    expect(counts).toEqual([64 * 64 - 1024 - 260, 1024, 260]);
  });

  it("takes width and height apart, rows first in the arrays", async () => {
    const { run, array, inMaps } = await bakePlane(["--size", "32x16", "--gutter", "0"]);
    expect(run.stdout).toContain("32 x 16 texels, gutter 0");
    expect(array("positions").shape).toEqual([16, 32, 3]);
    expect(array("coverage").shape).toEqual([16, 32]);
    expect(array("coverage").values.filter((kind) => kind === 2)).toHaveLength(0);
    const picture = await decodePicture(readFileSync(inMaps("normals.png")), "normals.png");
    expect([picture.width, picture.height]).toEqual([32, 16]);
    // Straight up, as (n + 1) / 2; outside the charts nothing.
    expect(Array.from(picture.rgba.subarray(4 * (8 * 32 + 16), 4 * (8 * 32 + 16) + 4))).toEqual([128, 255, 128, 255]);
    expect(Array.from(picture.rgba.subarray(0, 4))).toEqual([0, 0, 0, 0]);
  });

  it("bakes at the texture's own size, and at 1024 without a texture", async () => {
    const textured = await bakePlane([], planeGlb({ texture: await plainPng(48, 24, [1, 2, 3, 255]) }));
    expect(textured.array("coverage").shape).toEqual([24, 48]);
    const plain = await bakePlane([]);
    expect(plain.array("coverage").shape).toEqual([1024, 1024]);
  });

  it("bakes a model whose texture cannot be read: the map does not hang on it", async () => {
    const broken = (await plainPng(48, 24, [1, 2, 3, 255])).slice(0, 40);
    const { run, array } = await bakePlane(["--size", "8"], planeGlb({ texture: broken }));
    expect(run.code).toBe(0);
    expect(array("coverage").shape).toEqual([8, 8]);
  });

  it("makes the output folder, with those above it, and writes over an older bake", async () => {
    const folder = temporaryFolder();
    writeFileSync(path.join(folder, "plane.glb"), planeGlb());
    for (const size of ["8", "16"]) {
      const run = await texelcast(["bake", "plane.glb", "--out", "deep/down/maps", "--size", size], { cwd: folder });
      expect(run.code).toBe(0);
    }
    const maps = path.join(folder, "deep/down/maps");
    expect(readNpy(path.join(maps, "coverage.npy")).shape).toEqual([16, 16]);
    expect(readdirSync(maps)).toHaveLength(8);
  });

  it.each<[string, string[], string]>([
    [
      "a material that the model does not have",
      ["--material", "2"],
      "--material: the model has no material 2, it has materials 0 to 1",
    ],
    ["a material without triangles", ["--material", "1"], UNPAINTABLE],
  ])("refuses %s with exit code 3 and writes nothing", async (_what, args, told) => {
    const { folder, run } = await bakePlane(args);
    expect(run.code).toBe(3);
    expect(run.stdout).toBe("");
    expect(run.stderr).toContain(told);
    expect(readdirSync(folder)).toEqual(["plane.glb"]);
  });

  it("refuses an output folder that is a file, before it does any work", async () => {
    const folder = temporaryFolder();
    writeFileSync(path.join(folder, "maps"), "not a folder");
    const run = await texelcast(["bake", "no-such-model.glb", "--out", "maps"], { cwd: folder });
    expect(run.code).toBe(3);
    expect(run.stderr).toContain("is a file, not a folder");
    expect(run.stderr).not.toContain("no-such-model");
  });

  it("refuses to write where a folder has a file's name, and leaves the other files out too", async () => {
    const folder = temporaryFolder();
    mkdirSync(path.join(folder, "maps/overlap.png"), { recursive: true });
    writeFileSync(path.join(folder, "plane.glb"), planeGlb());
    const run = await texelcast(["bake", "plane.glb", "--out", "maps", "--size", "8"], { cwd: folder });
    expect(run.code).toBe(3);
    expect(run.stderr).toContain("there is a folder of that name");
    expect(readdirSync(path.join(folder, "maps"))).toEqual(["overlap.png"]);
  });

  it.each(["SIGINT", "SIGTERM", "SIGHUP"] as const)(
    "leaves nothing behind when %s ends it while it writes",
    async (signal) => {
      const folder = temporaryFolder();
      const maps = path.join(folder, "maps");
      writeFileSync(path.join(folder, "plane.glb"), planeGlb());
      const run = await texelcast(["bake", "plane.glb", "--out", "maps", "--size", "2048"], {
        cwd: folder,
        onStart: (pid) => {
          const timer = setInterval(() => {
            if (!existsSync(maps) || readdirSync(maps).length === 0) return;
            clearInterval(timer);
            process.kill(pid, signal);
          }, 2);
        },
      });
      expect(run).toMatchObject({ code: null, signal, stdout: "", stderr: "" });
      expect(readdirSync(maps)).toEqual([]);
    },
  );
});
