import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { validateBytes } from "gltf-validator";
import { describe, expect, it } from "vitest";
import { parseDesign, resolveLayers } from "../../web/editor/document/index.ts";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { halvesGlb } from "../support/two-halves.ts";
import { storedFiles } from "../support/usdz-files.ts";
import { FACING_DOWN, plainPng, planeGlb, readGlbJson } from "./plane-model.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

const RED = [255, 0, 0, 255] as const;
const GREEN = [0, 255, 0, 255] as const;
const BLUE = [0, 0, 255, 255] as const;
const GREY = [128, 128, 128, 255] as const;

/** On a texture of 64 texels: the middle 16 by 16, from texel 24 to texel 39. */
const middle = { kind: "planar", position: [0, 0.5, 0], rotation: FACING_DOWN, size: [2, 1, 0.2] };
const decal = (fields: object = {}) => ({ type: "decal", asset: "logo", projector: middle, ...fields });

interface Workbench {
  readonly folder: string;
  read(name: string): Uint8Array;
  render(...args: string[]): ReturnType<typeof texelcast>;
  /** The colour of a texel of a picture that was written. */
  texel(name: string, i: number, j: number): Promise<number[]>;
}

/** A folder with a plane, a design of these layers, and its picture: red, green over blue, grey, from the top left. */
async function workbench(layers: readonly object[], glb = planeGlb()): Promise<Workbench> {
  const folder = temporaryFolder();
  const inFolder = (name: string): string => path.join(folder, name);
  const logo = await encodePng({ width: 2, height: 2, rgba: new Uint8Array([...RED, ...GREEN, ...BLUE, ...GREY]) });
  writeFileSync(inFolder("plane.glb"), glb);
  writeFileSync(inFolder("logo.png"), logo);
  const assets = {
    logo: { type: "image/png", uri: "logo.png" },
    serif: { type: "font/ttf", uri: "serif.ttf" },
    notes: { type: "image/png", uri: "design.json" },
  };
  writeFileSync(inFolder("design.json"), JSON.stringify({ format: "texelcast-design", version: 1, assets, layers }));
  return {
    folder,
    read: (name) => readFileSync(inFolder(name)),
    render: (...args) => texelcast(["render", "plane.glb", "design.json", ...args], { cwd: folder }),
    async texel(name, i, j) {
      const { width, rgba } = await decodePicture(readFileSync(inFolder(name)), name);
      return Array.from(rgba.subarray(4 * (j * width + i), 4 * (j * width + i) + 4));
    },
  };
}

/** The four corners of the decal, well inside their pixel: from the top left, row by row. */
const corners = async (bench: Workbench, name: string): Promise<number[][]> =>
  Promise.all([
    bench.texel(name, 26, 26),
    bench.texel(name, 37, 26),
    bench.texel(name, 26, 37),
    bench.texel(name, 37, 37),
  ]);

describe("texelcast render to .png", () => {
  it("puts the picture where the projector throws it, the right way up, and leaves the ground around it", async () => {
    const bench = await workbench([decal({ filter: "nearest" })]);
    const run = await bench.render("--out", "out.png", "--size", "64", "--base", "#102030");
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toMatch(/^out\.png: [\d,]+ bytes, 1 layer, material 0 at 64 x 64\n$/);
    expect(await corners(bench, "out.png")).toEqual([RED, GREEN, BLUE, GREY]);
    for (const [i, j] of [
      [22, 30],
      [41, 30],
      [30, 22],
      [30, 41],
      [0, 0],
      [63, 63],
    ] as const) {
      expect(await bench.texel("out.png", i, j)).toEqual([16, 32, 48, 255]);
    }
  });

  it.each([
    {
      kind: "perspective",
      position: [0, 2.5, 0],
      rotation: FACING_DOWN,
      fov: (2 * Math.atan(0.25) * 180) / Math.PI,
      aspect: 2,
      near: 1,
      far: 3,
    },
    {
      kind: "cylindrical",
      position: [0, 0.5 - 100, 0],
      rotation: FACING_DOWN,
      radius: 100,
      height: 1,
      arc: (2 * Math.asin(0.01) * 180) / Math.PI,
      depth: 0.1,
    },
    { kind: "uv", center: [0.5, 0.5], size: [0.25, 0.25], angle: 0 },
  ])("puts it in the same place by the projector $kind, where that covers the same", async (projector) => {
    const bench = await workbench([decal({ filter: "nearest", projector })]);
    const run = await bench.render("--out", "out.png", "--size", "64", "--base", "#102030");
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(await corners(bench, "out.png")).toEqual([RED, GREEN, BLUE, GREY]);
    for (const [i, j] of [
      [22, 30],
      [41, 30],
      [30, 22],
      [30, 41],
    ] as const) {
      expect(await bench.texel("out.png", i, j)).toEqual([16, 32, 48, 255]);
    }
  });

  it("paints strokes with round and with picture brushes, as the engine paints them", async () => {
    const size = [0.5, 0.25, 0.2];
    const dab = (x: number, flow = 1) => ({ ...middle, position: [x, 0.5, 0], size, flow });
    const layers = [
      { type: "stroke", brush: { color: "#ff8000" }, opacity: 0.5, dabs: [dab(-1), dab(-1), dab(-0.75, 0.5)] },
      { type: "stroke", brush: { tip: "picture", asset: "logo" }, filter: "nearest", dabs: [middle] },
      { type: "stroke", brush: {}, blend: "erase", dabs: [{ ...dab(1.5), size: [1, 0.5, 0.2] }] },
    ];
    const bench = await workbench(layers);
    const run = await bench.render("--out", "out.png", "--size", "64", "--base", "white");
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toContain("3 layers");
    expect(await corners(bench, "out.png")).toEqual([RED, GREEN, BLUE, GREY]);
    const engine = createEngineHost();
    await engine.loadModel({ name: "plane.glb", bytes: planeGlb() });
    await engine.openTarget({ material: 0, width: 64, height: 64, base: [1, 1, 1, 1] });
    await engine.setAsset("logo", { name: "logo.png", bytes: bench.read("logo.png") });
    const assets = { logo: { type: "image/png", uri: "logo.png" } };
    engine.setLayers(resolveLayers(parseDesign({ format: "texelcast-design", version: 1, assets, layers })), 1);
    await engine.idle();
    expect(bench.read("out.png")).toEqual(Buffer.from(await engine.exportPng(0)));
    engine.dispose();
    const { rgba } = await decodePicture(bench.read("out.png"), "out.png");
    expect(rgba.some((value, i) => i % 4 === 3 && value === 0)).toBe(true);
    expect(rgba.some((value, i) => i % 4 === 2 && value === 128)).toBe(true);
  });

  it("mirrors the picture by flipX and flipY", async () => {
    const bench = await workbench([decal({ filter: "nearest", flipX: true, flipY: true })]);
    await bench.render("--out", "out.png", "--size", "64");
    expect(await corners(bench, "out.png")).toEqual([GREY, BLUE, GREEN, RED]);
  });

  it("lies on the material's own colour, white, a colour or a picture, as --base says", async () => {
    const bench = await workbench([]);
    writeFileSync(path.join(bench.folder, "ground.png"), await plainPng(5, 3, [7, 8, 9, 255]));
    await bench.render("--out", "own.png", "--size", "16");
    await bench.render("--out", "white.png", "--size", "16", "--base", "white");
    await bench.render("--out", "colour.png", "--size", "16", "--base", "#01020380");
    await bench.render("--out", "picture.png", "--base", "ground.png");
    await bench.render("--out", "resized.png", "--base", "ground.png", "--size", "16x8");
    expect(await bench.texel("own.png", 8, 8)).toEqual([255, 0, 0, 255]);
    expect(await bench.texel("white.png", 8, 8)).toEqual([255, 255, 255, 255]);
    expect(await bench.texel("colour.png", 8, 8)).toEqual([1, 2, 3, 128]);
    expect(await bench.texel("picture.png", 2, 1)).toEqual([7, 8, 9, 255]);
    expect(await bench.texel("resized.png", 15, 7)).toEqual([7, 8, 9, 255]);
    const { width, height } = await decodePicture(bench.read("picture.png"), "picture.png");
    expect([width, height]).toEqual([5, 3]);
  });

  it("stacks layers bottom to top, hides those that are hidden, and mixes by opacity", async () => {
    const bench = await workbench([
      { type: "fill", color: "#0000ff" },
      { type: "fill", color: "#00ff00", opacity: 0.5 },
      { type: "fill", color: "#ffffff", visible: false },
    ]);
    const run = await bench.render("--out", "out.png", "--size", "16");
    expect(run.stdout).toContain("2 layers");
    expect(await bench.texel("out.png", 8, 8)).toEqual([0, 128, 128, 255]);
  });

  it("blends by the design's modes, in sRGB or in linear light, and erases", async () => {
    const over = { filter: "nearest", blend: "multiply" };
    const bench = await workbench([
      { type: "fill", color: "#808000" },
      decal(over),
      decal({ ...over, blendSpace: "linear", opacity: 0.5 }),
      { type: "fill", color: "#000000", blend: "erase", opacity: 0.2 },
    ]);
    const run = await bench.render("--out", "out.png", "--size", "64");
    expect(run.stdout).toContain("4 layers");
    expect(await bench.texel("out.png", 4, 4)).toEqual([128, 128, 0, 204]);
    const [red, green, blue, grey] = await corners(bench, "out.png");
    // Both multiply by the picture's 0 and 1: red keeps the first channel, green the second, blue none.
    expect([red, green, blue]).toEqual([
      [128, 0, 0, 204],
      [0, 128, 0, 204],
      [0, 0, 0, 204],
    ]);
    // 128 · 128 / 255 = 64.3; half of that times 0.2159, which is 128 in linear light: 49.6.
    expect(grey).toEqual([50, 50, 0, 204]);
  });

  it("writes the same bytes each time", async () => {
    const bench = await workbench([decal({ opacity: 0.7 })]);
    await bench.render("--out", "first.png", "--size", "64");
    await bench.render("--out", "second.png", "--size", "64");
    expect(Buffer.compare(bench.read("first.png"), bench.read("second.png"))).toBe(0);
  });

  it("replays the same recipe at another size", async () => {
    const bench = await workbench([decal({ filter: "nearest" })]);
    await bench.render("--out", "out.png", "--size", "128");
    expect(await bench.texel("out.png", 52, 52)).toEqual(RED);
    expect(await bench.texel("out.png", 74, 74)).toEqual(GREY);
  });

  it("takes pictures that are written into the design", async () => {
    const bench = await workbench([]);
    const uri = `data:image/png;base64,${Buffer.from(bench.read("logo.png")).toString("base64")}`;
    const assets = { logo: { type: "image/png", uri } };
    const layers = [decal({ filter: "nearest" })];
    const design = JSON.stringify({ format: "texelcast-design", version: 1, assets, layers });
    writeFileSync(path.join(bench.folder, "design.json"), design);
    await bench.render("--out", "out.png", "--size", "64");
    expect(await corners(bench, "out.png")).toEqual([RED, GREEN, BLUE, GREY]);
  });

  it("does not read the pictures of layers that are not drawn", async () => {
    const bench = await workbench([decal({ visible: false })]);
    writeFileSync(path.join(bench.folder, "logo.png"), "not a picture");
    expect((await bench.render("--out", "out.png", "--size", "16")).code).toBe(0);
  });
});

describe("texelcast render of several materials", () => {
  /** Stands upright, over the border between the halves. */
  const crossing = decal({
    material: [0, 1],
    projector: { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [0.5, 0.5, 0.2] },
    filter: "nearest",
  });
  const halves = halvesGlb({ materials: 2 });

  it("paints one decal on both sides of a border, in a picture for each material", async () => {
    const bench = await workbench([crossing, { type: "fill", color: "#000000", material: 1, opacity: 0 }], halves);
    const run = await bench.render("--out", "print-{material}.png", "--size", "64", "--base", "#102030");
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toMatch(
      /^print-0\.png: [\d,]+ bytes, 1 layer, material 0 at 64 x 64\nprint-1\.png: [\d,]+ bytes, 2 layers, material 1 at 64 x 64\n$/,
    );
    expect(await bench.texel("print-0.png", 28, 28)).toEqual(RED);
    expect(await bench.texel("print-0.png", 28, 36)).toEqual(BLUE);
    expect(await bench.texel("print-1.png", 36, 28)).toEqual(GREEN);
    expect(await bench.texel("print-1.png", 36, 36)).toEqual(GREY);
  });

  it("puts every picture into the .glb, those of the .png files byte for byte", async () => {
    const bench = await workbench([crossing], halves);
    await bench.render("--out", "print-{material}.png", "--size", "64");
    const run = await bench.render("--out", "out.glb", "--size", "64");
    expect(run.stdout).toContain("1 layer, material 0 at 64 x 64, material 1 at 64 x 64");
    const glb = Buffer.from(bench.read("out.glb"));
    for (const name of ["print-0.png", "print-1.png"]) expect(glb.includes(Buffer.from(bench.read(name)))).toBe(true);
  });

  it("writes the one picture that --material chooses", async () => {
    const bench = await workbench([crossing], halves);
    await bench.render("--out", "print-{material}.png", "--size", "64", "--material", "1");
    expect(readdirSync(bench.folder).filter((name) => name.startsWith("print"))).toEqual(["print-1.png"]);
  });

  it("writes no picture where nothing is painted, and says so", async () => {
    const bench = await workbench([{ ...crossing, visible: false }], halves);
    const run = await bench.render("--out", "print-{material}.png");
    expect(run).toMatchObject({ code: 0, stdout: "no material is painted, so there is no picture to write\n" });
    expect(readdirSync(bench.folder).filter((name) => name.endsWith(".png"))).toEqual(["logo.png"]);
  });
});

describe("texelcast render to .usdz", () => {
  it("has the finished texture beside the layer, byte for byte that of the .png", async () => {
    const bench = await workbench([decal()], planeGlb({ texture: await plainPng(64, 64, [1, 2, 3, 255]) }));
    const run = await bench.render("--out", "out.usdz");
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toMatch(/^out\.usdz: [\d,]+ bytes, 1 layer, material 0 at 64 x 64\n$/);
    await bench.render("--out", "out.png");
    const [layer, picture] = storedFiles(bench.read("out.usdz"));
    expect(layer?.path).toBe("model.usda");
    expect(Buffer.from(picture?.bytes ?? []).equals(bench.read("out.png"))).toBe(true);
  });
});

describe("texelcast render to .glb", () => {
  it("puts the finished texture into the model, byte for byte that of the .png, and stays valid", async () => {
    const bench = await workbench([decal()], planeGlb({ texture: await plainPng(64, 64, [1, 2, 3, 255]) }));
    const run = await bench.render("--out", "out.glb");
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect(run.stdout).toMatch(/^out\.glb: [\d,]+ bytes, 1 layer, material 0 at 64 x 64\n$/);
    await bench.render("--out", "out.png");
    const glb = bench.read("out.glb");
    const report = await validateBytes(glb);
    expect(report.issues.messages.filter(({ severity }) => severity <= 1)).toEqual([]);
    expect(Buffer.from(glb).includes(Buffer.from(bench.read("out.png")))).toBe(true);
  });

  it("leaves everything else of the file as it was, unknown extensions too", async () => {
    const original = planeGlb({ texture: await plainPng(64, 64, [1, 2, 3, 255]) });
    const bench = await workbench([decal()], original);
    await bench.render("--out", "out.glb");
    const [before, after] = [readGlbJson(original), readGlbJson(bench.read("out.glb"))];
    const untouched = [
      "asset",
      "extensionsUsed",
      "extensions",
      "extras",
      "scene",
      "scenes",
      "nodes",
      "animations",
      "meshes",
      "accessors",
    ];
    for (const field of untouched) expect(after[field]).toEqual(before[field]);
    expect((after.materials as unknown[])[1]).toEqual((before.materials as unknown[])[1]);
  });

  it("can be rendered again from its own output: the picture comes back as the ground", async () => {
    const bench = await workbench([{ type: "fill", color: "#336699" }]);
    await bench.render("--out", "once.glb", "--size", "32");
    writeFileSync(path.join(bench.folder, "plane.glb"), bench.read("once.glb"));
    writeFileSync(path.join(bench.folder, "design.json"), '{"format":"texelcast-design","version":1}');
    await bench.render("--out", "again.png");
    const { width, height } = await decodePicture(bench.read("again.png"), "again.png");
    expect([width, height]).toEqual([32, 32]);
    expect(await bench.texel("again.png", 16, 16)).toEqual([0x33, 0x66, 0x99, 255]);
  });

  it("replaces no texture when the design paints nothing", async () => {
    const original = planeGlb({ texture: await plainPng(8, 8, [1, 2, 3, 255]) });
    const bench = await workbench([{ type: "fill", color: "#336699", visible: false }], original);
    const run = await bench.render("--out", "out.glb");
    expect(run.stdout).toContain("0 layers, no material");
    expect(readGlbJson(bench.read("out.glb"))).toEqual(readGlbJson(original));
  });
});

const UNPAINTABLE =
  'texelcast: plane.glb: --material: material 1 ("of no triangle") cannot be painted: there are no triangles to paint\n' +
  '  Choose one that can: 0 ("paint").\n';

describe("what texelcast render refuses", () => {
  it.each<[string, object[], string[], string]>([
    [
      "a material that the design names and the model lacks",
      [{ type: "fill", color: "#000000", material: 7 }],
      [],
      "design.json: layers[0].material: the model has no material 7, it has materials 0 to 1",
    ],
    [
      "a material in a list that the model lacks",
      [{ type: "fill", color: "#000000", material: [0, 7] }],
      [],
      "design.json: layers[0].material[1]: the model has no material 7, it has materials 0 to 1",
    ],
    [
      "a material of the command line that the model lacks",
      [],
      ["--material", "2"],
      "--material: the model has no material 2",
    ],
    ["a material without triangles", [], ["--material", "1"], UNPAINTABLE],
    ["a ground that is missing", [], ["--base", "ground.png"], "ground.png: there is no such file"],
    ["a ground that is no picture", [], ["--base", "design.json"], "design.json"],
    [
      "a decal whose picture is none",
      [{ type: "decal", asset: "notes", projector: middle }],
      [],
      "texelcast: The picture “design.json: assets.notes.uri: design.json” cannot be used: it is neither PNG",
    ],
    [
      "words in a font whose file is missing",
      [{ type: "text", text: "Ada", font: "serif", projector: middle }],
      [],
      'design.json: assets.serif.uri: "serif.ttf": there is no such file',
    ],
  ])("%s: exit code 3, nothing written, nothing on stdout", async (_what, layers, args, told) => {
    const bench = await workbench(layers);
    const run = await bench.render("--out", "out.png", ...args);
    expect(run.code).toBe(3);
    expect(run.stdout).toBe("");
    expect(run.stderr).toContain(told);
    expect(readdirSync(bench.folder).sort()).toEqual(["design.json", "logo.png", "plane.glb"]);
  });

  it("a model without texture coordinates", async () => {
    const bench = await workbench([], planeGlb({ withoutUvs: true }));
    const run = await bench.render("--out", "out.png");
    expect(run.code).toBe(3);
    expect(run.stderr).toContain("texture coordinates");
  });
});
