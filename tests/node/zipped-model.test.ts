import { writeFileSync } from "node:fs";
import path from "node:path";
import { zipSync } from "fflate";
import { describe, expect, it } from "vitest";
import { planeGlb } from "./plane-model.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

/** A folder with a zip of one model, a zip of two, and a design. */
function folder(): string {
  const place = temporaryFolder();
  const glb = planeGlb();
  writeFileSync(path.join(place, "one.zip"), zipSync({ "robot/plane.glb": glb }));
  writeFileSync(path.join(place, "two.zip"), zipSync({ "a/plane.glb": glb, "b/plane.glb": glb }));
  writeFileSync(path.join(place, "design.json"), '{"format":"texelcast-design","version":1,"layers":[]}');
  return place;
}

describe("a zipped model", () => {
  it.each([
    ["inspect", ["inspect", "one.zip"]],
    ["bake", ["bake", "one.zip", "--out", "maps", "--size", "8"]],
    ["render", ["render", "one.zip", "design.json", "--out", "x.glb", "--size", "8"]],
    ["check", ["check", "one.zip", "design.json"]],
    ["print", ["print", "one.zip", "design.json", "--out", "x.png", "--size", "8"]],
    ["unwrap", ["unwrap", "one.zip", "--out", "x.glb", "--size", "64", "--material", "0"]],
  ])("is taken by texelcast %s as the model itself", async (_command, args) => {
    const { code, stderr } = await texelcast(args, { cwd: folder() });
    expect(stderr).toBe("");
    expect(code).toBe(0);
  });

  it("of several is chosen behind a #, and they are named where none is", async () => {
    const cwd = folder();
    const refused = await texelcast(["inspect", "two.zip"], { cwd });
    expect(refused).toMatchObject({ code: 3, stdout: "" });
    expect(refused.stderr).toBe(
      "texelcast: “two.zip” holds 2 models: “a/plane.glb”, “b/plane.glb”.\n" +
        "  Choose one by its path behind a “#”, as in “two.zip#a/plane.glb”.\n",
    );
    const chosen = await texelcast(["inspect", "two.zip#b/plane.glb"], { cwd });
    expect(chosen.code).toBe(0);
    expect(chosen.stdout).toMatch(/^two\.zip#b\/plane\.glb: 2 triangles/);
  });

  it("may have a # in the name of its own file", async () => {
    const cwd = folder();
    writeFileSync(path.join(cwd, "a.zip#b.glb"), planeGlb());
    expect((await texelcast(["inspect", "a.zip#b.glb"], { cwd })).code).toBe(0);
  });

  it("is no place for a result", async () => {
    const cwd = folder();
    writeFileSync(path.join(cwd, "odd.png"), zipSync({ "plane.glb": planeGlb() }));
    const { code, stderr } = await texelcast(["render", "odd.png", "design.json", "--out", "odd.png", "--size", "8"], {
      cwd,
    });
    expect(stderr).toContain('--out: "odd.png" is read by this command');
    expect(code).toBe(2);
  });
});
