/**
 * The command line on real models. They lie beside the checkout and are not part of it (their licences differ).
 */
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { validateBytes } from "gltf-validator";
import { describe, expect, it } from "vitest";
import type { ModelReport } from "../../node/inspect-model.ts";
import { haveSharedModels, noteSkipped, SHARED_MODELS } from "../support/shared-models.ts";
import { readNpy } from "./read-npy.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

const FOLDER = fileURLToPath(new URL("../../../shared/models/", import.meta.url));

const models = haveSharedModels ? SHARED_MODELS : [];

const inspect = async (model: string): Promise<ModelReport> =>
  JSON.parse((await texelcast(["inspect", path.join(FOLDER, model), "--json"])).stdout);

describe("real models", () => {
  it("are tried where they are there", () => {
    noteSkipped("the command line on real models");
    expect(models.length > 0).toBe(haveSharedModels);
  });

  it.each(models)("%s is inspected, and painted into a valid GLB where it has texture coordinates", async (model) => {
    const report = await inspect(model);
    expect(report.triangles).toBeGreaterThan(0);
    const paintable = report.materials.filter(({ canTakeDecals }) => canTakeDecals).map(({ index }) => index);
    const folder = temporaryFolder();
    const layers = paintable.map((material) => ({ type: "fill", color: "#3366cc80", material }));
    writeFileSync(path.join(folder, "design.json"), JSON.stringify({ format: "texelcast-design", version: 1, layers }));
    const run = await texelcast(
      ["render", path.join(FOLDER, model), "design.json", "--out", "out.glb", "--size", "64"],
      {
        cwd: folder,
      },
    );
    expect(run).toMatchObject({ code: 0, stderr: "" });
    const { issues, info } = await validateBytes(readFileSync(path.join(folder, "out.glb")));
    expect(issues.messages.filter(({ severity }) => severity === 0)).toEqual([]);
    const pictures = info.resources.flatMap(({ image }) => (image === undefined ? [] : [image]));
    expect(pictures.filter(({ width, height }) => width === 64 && height === 64)).toHaveLength(paintable.length);
  });

  it.runIf(haveSharedModels)("without texture coordinates say NO, and are refused by bake and render", async () => {
    const model = path.join(FOLDER, "RiggedFigure.glb");
    const inspected = await texelcast(["inspect", model]);
    expect(inspected.code).toBe(0);
    expect(inspected.stdout).toMatch(/ NO$/m);
    const folder = temporaryFolder();
    writeFileSync(path.join(folder, "design.json"), '{"format":"texelcast-design","version":1}');
    for (const args of [
      ["bake", model, "--out", "maps"],
      ["render", model, "design.json", "--out", "out.png"],
    ]) {
      const run = await texelcast(args, { cwd: folder });
      expect(run).toMatchObject({ code: 3, stdout: "" });
      expect(run.stderr).toContain("texture coordinates");
    }
    expect(readdirSync(folder)).toEqual(["design.json"]);
  });

  it.runIf(haveSharedModels)("bake alike from all their encodings", async () => {
    const folder = temporaryFolder();
    const bake = async (name: string) => {
      const model = path.join(FOLDER, name, "Avocado.gltf");
      await texelcast(["bake", model, "--out", name, "--size", "512"], { cwd: folder });
      const array = (channel: string) => readNpy(path.join(folder, name, `${channel}.npy`)).values;
      return { coverage: array("coverage"), positions: array("positions"), normals: array("normals") };
    };
    const { bounds } = await inspect("Avocado/Avocado.gltf");
    const diagonal = Math.hypot(...bounds.max.map((high, axis) => high - (bounds.min[axis] as number)));
    const plain = await bake("Avocado");
    // The files themselves are rounded, positions and texture coordinates (Draco: to 1/4096 of the texture, an eighth
    // of a texel here), so they agree within that and not within the bake's own accuracy.
    for (const [name, positionShare, degrees] of [
      ["AvocadoQuantized", 1 / 4096, 0.5],
      ["AvocadoDraco", 1 / 1024, 1.5],
    ] as const) {
      const twin = await bake(name);
      const both = Array.from(plain.coverage.keys()).filter(
        (at) => plain.coverage[at] === 1 && twin.coverage[at] === 1,
      );
      const either = Array.from(plain.coverage.keys()).filter(
        (at) => plain.coverage[at] === 1 || twin.coverage[at] === 1,
      );
      expect(both.length / either.length).toBeGreaterThan(0.998);
      const vector = (values: ArrayLike<number>, at: number) =>
        [0, 1, 2].map((axis) => values[3 * at + axis] as number);
      const angles: number[] = [];
      for (const at of both) {
        const [a, b] = [vector(plain.positions, at), vector(twin.positions, at)];
        const distance = Math.hypot(...a.map((part, axis) => part - (b[axis] as number)));
        if (distance > diagonal * positionShare) throw new Error(`${name}: texel ${at} lies ${distance} m off`);
        const [n, m] = [vector(plain.normals, at), vector(twin.normals, at)];
        const cosine = n.reduce((sum, part, axis) => sum + part * (m[axis] as number), 0);
        angles.push((Math.acos(Math.min(1, cosine)) * 180) / Math.PI);
      }
      angles.sort((a, b) => a - b);
      expect(angles[Math.floor(angles.length * 0.99)]).toBeLessThan(degrees);
    }
  });
});
