/** Where results go: what may be replaced, what it keeps, and what is told before any work is done. */
import { spawnSync } from "node:child_process";
import {
  chmodSync,
  existsSync,
  lstatSync,
  mkdirSync,
  readdirSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { planeGlb } from "./plane-model.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

const fill = (material: number) => ({ type: "fill", color: "#ff0000", material });

function folderWith(layers: readonly object[]): string {
  const folder = temporaryFolder();
  const design = { format: "texelcast-design", version: 1, layers };
  writeFileSync(path.join(folder, "plane.glb"), planeGlb());
  writeFileSync(path.join(folder, "design.json"), JSON.stringify(design));
  return folder;
}

const render = (cwd: string, out: string, ...more: string[]) =>
  texelcast(["render", "plane.glb", "design.json", "--size", "8", "--out", out, ...more], { cwd });

describe.skipIf(process.platform === "win32")("an output that is no file", () => {
  const wrong =
    "texelcast: x.png: cannot be written: it is a pipe or a device, and a result takes the place of what has its name\n";

  it("is told as what it is where it leads to a device", async () => {
    const folder = folderWith([]);
    symlinkSync("/dev/null", path.join(folder, "x.png"));
    const { code, stderr } = await render(folder, "x.png");
    expect(code).toBe(3);
    expect(stderr.startsWith(wrong)).toBe(true);
  });

  it("is told as what it is where it is a pipe, and nothing waits for its reader", async () => {
    const folder = folderWith([]);
    expect(spawnSync("mkfifo", [path.join(folder, "x.png")]).status).toBe(0);
    const { code, stderr } = await render(folder, "x.png");
    expect(code).toBe(3);
    expect(stderr.startsWith(wrong)).toBe(true);
  });
});

describe("an output that was there before", () => {
  it.skipIf(process.platform === "win32")("keeps its permissions when it is replaced", async () => {
    const folder = folderWith([]);
    const file = path.join(folder, "x.png");
    writeFileSync(file, "old");
    chmodSync(file, 0o600);
    expect(await render(folder, "x.png")).toMatchObject({ code: 0 });
    expect(statSync(file).size).toBeGreaterThan(3);
    expect(statSync(file).mode & 0o777).toBe(0o600);
  });
});

describe.skipIf(process.platform === "win32")("an output that is a link", () => {
  /** "x.png" is the link; a target that begins with "/" stands for its whole path. */
  function folderWithLink(target: string): string {
    const folder = folderWith([]);
    mkdirSync(path.join(folder, "approved"));
    symlinkSync(target.startsWith("/") ? path.join(folder, target) : target, path.join(folder, "x.png"));
    return folder;
  }

  it.each([
    ["a file", "approved/a.png", "old"],
    ["a file that is not there yet", "approved/a.png", null],
    ["a file by its whole path", "/approved/a.png", "old"],
    ["another link to a file that is not there yet", "second.png", null],
  ])("stays one, and what it leads to is written: %s", async (_what, target, before) => {
    const folder = folderWithLink(target);
    const link = path.join(folder, "x.png");
    if (target === "second.png") symlinkSync("approved/../approved/a.png", path.join(folder, target));
    const file = path.join(folder, "approved/a.png");
    if (before !== null) writeFileSync(file, before);
    const run = await render(folder, "x.png");
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toMatch(/^x\.png: /);
    expect(lstatSync(link).isSymbolicLink()).toBe(true);
    expect(statSync(file).size).toBeGreaterThan(3);
    expect(readdirSync(path.join(folder, "approved"))).toEqual(["a.png"]);
  });

  it("is told by its own name where it leads round in a ring", async () => {
    const folder = folderWithLink("x.png");
    const { code, stderr } = await render(folder, "x.png");
    expect(stderr).toMatch(/^texelcast: x\.png: cannot be written: ELOOP: [^\n]+\n {2}[^\n]+\n$/);
    expect(code).toBe(3);
  });

  it("is told by its own name where it leads into a folder's place", async () => {
    const folder = folderWithLink("plane.glb/a.png");
    const { code, stderr } = await render(folder, "x.png");
    expect(stderr).toMatch(/^texelcast: x\.png: cannot be written: "[^"\n]*plane\.glb" is a file, not a folder\n/);
    expect(code).toBe(3);
  });

  it("may be in its path as a folder, with a way up behind it", async () => {
    const folder = folderWithLink("approved/a.png");
    mkdirSync(path.join(folder, "approved/maps"));
    symlinkSync("approved/maps", path.join(folder, "maps"));
    expect(await render(folder, "maps/../b.png")).toMatchObject({ code: 0, stderr: "" });
    expect(readdirSync(path.join(folder, "approved")).sort()).toEqual(["b.png", "maps"]);
    const bake = await texelcast(["bake", "plane.glb", "--out", "maps/../baked", "--size", "8"], { cwd: folder });
    expect(bake).toMatchObject({ code: 0, stderr: "" });
    expect(readdirSync(path.join(folder, "approved/baked"))).toHaveLength(8);
    expect(existsSync(path.join(folder, "b.png"))).toBe(false);
  });
});

describe("one picture for each material", () => {
  it("is not begun where a folder has the name of a later one", async () => {
    const folder = folderWith([fill(0), fill(1)]);
    mkdirSync(path.join(folder, "m-1.png"));
    const { code, stdout, stderr } = await render(folder, "m-{material}.png");
    expect(stderr).toMatch(/^texelcast: m-1\.png: cannot be written: there is a folder of that name\n {2}[^\n]+\n$/);
    expect(code).toBe(3);
    expect(stdout).toBe("");
    expect(existsSync(path.join(folder, "m-0.png"))).toBe(false);
    expect(readdirSync(folder).filter((name) => name.startsWith(".texelcast"))).toEqual([]);
  });

  it("names the layer and the material where that cannot be painted", async () => {
    const folder = folderWith([fill(0), fill(1)]);
    const { code, stderr } = await render(folder, "m-{material}.png");
    expect(stderr).toMatch(
      /^texelcast: design\.json: layers\[1\]\.material: material 1[^\n]* cannot be painted: [^\n]+\n {2}[^\n]+\n$/,
    );
    expect(code).toBe(3);
  });

  it("names the option where it asks for one that no layer is on and that cannot be painted", async () => {
    const folder = folderWith([fill(0)]);
    const { code, stderr } = await render(folder, "m-{material}.png", "--material", "1");
    expect(stderr).toBe(
      'texelcast: plane.glb: --material: material 1 ("of no triangle") cannot be painted: there are no triangles to paint\n' +
        '  Choose one that can: 0 ("paint").\n',
    );
    expect(code).toBe(3);
  });
});
