import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { strToU8, zipSync } from "fflate";
import { describe, expect, it } from "vitest";
import { parseDesign } from "../../web/editor/document/index.ts";
import { writeProjectFile } from "../../web/editor/document/project-file.ts";
import { FACING_DOWN, plainPng, planeGlb } from "./plane-model.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

const DESIGN = {
  format: "texelcast-design",
  version: 1,
  assets: { logo: { type: "image/png", uri: "logo.png" } },
  layers: [
    {
      type: "decal",
      asset: "logo",
      projector: { kind: "planar", position: [0, 0.5, 0], rotation: FACING_DOWN, size: [2, 1, 0.2] },
    },
  ],
};

/** A folder with a plane, a design with its picture, and both as projects: with the model inside and without. */
async function folderOfProjects() {
  const folder = temporaryFolder();
  const put = (name: string, bytes: Uint8Array | string): void => writeFileSync(path.join(folder, name), bytes);
  const logo = await plainPng(4, 4, [200, 30, 90, 255]);
  const model = planeGlb();
  put("plane.glb", model);
  put("logo.png", logo);
  put("design.json", JSON.stringify(DESIGN));
  const project = (source: { name: string; bytes: Uint8Array } | null): Uint8Array =>
    writeProjectFile({
      name: "plane",
      design: parseDesign(DESIGN),
      assetBytes: () => logo,
      targets: [{ material: 0, size: 32, gutter: 2 }],
      model: { title: "plane.glb", demo: null, source },
    });
  put("whole.texelcast", project({ name: "plane.glb", bytes: model }));
  put("bare.texelcast", project(null));
  put("bad.texelcast", zipSync({ "../evil": strToU8("x") }));
  return {
    render: (...args: string[]) => texelcast(["render", ...args], { cwd: folder }),
    read: (name: string) => readFileSync(path.join(folder, name)),
  };
}

describe("texelcast render FILE.texelcast", () => {
  it("paints the model inside, at the size that the project has, as the parts by themselves do", async () => {
    const { render, read } = await folderOfProjects();
    const run = await render("whole.texelcast", "--out", "whole.png");
    expect([run.code, run.stderr]).toEqual([0, ""]);
    expect(run.stdout).toContain("32 x 32");
    await render("plane.glb", "design.json", "--out", "parts.png", "--size", "32");
    expect(read("whole.png").equals(read("parts.png"))).toBe(true);
    const larger = await render("whole.texelcast", "--out", "large.png", "--size", "128");
    expect(larger.stdout).toContain("128 x 128");
  });

  it("paints a model that is given, whatever is inside", async () => {
    const { render, read } = await folderOfProjects();
    expect((await render("plane.glb", "bare.texelcast", "--out", "a.png")).code).toBe(0);
    expect((await render("plane.glb", "whole.texelcast", "--out", "b.png")).code).toBe(0);
    expect(read("a.png").equals(read("b.png"))).toBe(true);
  });

  it("says what to give when no model is inside", async () => {
    const { render } = await folderOfProjects();
    const run = await render("bare.texelcast", "--out", "a.png");
    expect(run.code).toBe(3);
    expect(run.stderr).toContain("bare.texelcast");
    expect(run.stderr).toContain("Give the model first");
  });

  it("refuses a hostile archive by file and entry", async () => {
    const { render } = await folderOfProjects();
    const run = await render("bad.texelcast", "--out", "a.png");
    expect(run.code).toBe(3);
    expect(run.stderr).toContain("bad.texelcast");
    expect(run.stderr).toContain("../evil");
  });
});
