/** What `texelcast render` makes of a saved design's groups, masks, mirrors, parts, gradients, pixel layers and words. */
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { parseDesign, resolveLayers } from "../../web/editor/document/index.ts";
import { writeProjectFile } from "../../web/editor/document/project-file.ts";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { FACING_DOWN, planeGlb } from "./plane-model.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

const SIZE = 64;
/** The plane's own texels: the middle half of the texture. */
const [FIRST, LAST] = [16, 47];
const GROUND = "#204060";
const GROUND_TEXEL = [0x20, 0x40, 0x60, 255];

const ASSETS = {
  logo: { type: "image/png", uri: "logo.png" },
  pixels: { type: "image/png", uri: "pixels.png" },
  inter: { type: "font/ttf", uri: "texelcast:fonts/inter-700" },
};

/** Everywhere on the texture, a picture's pixel on each texel. */
const whole = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 };
/** Texels 24 to 39 both ways: its edges lie between texels. */
const middle = { kind: "uv", center: [0.5, 0.5], size: [0.25, 0.25], angle: 0 };
const isInMiddle = (i: number, j: number): boolean => i >= 24 && i < 40 && j >= 24 && j < 40;
/** Half the model's width to the left, over 8 by 16 texels. */
const aside = { kind: "planar", position: [-1, 0.5, 0], rotation: FACING_DOWN, size: [1, 1, 0.2] } as const;

const fill = (color: string, fields: object = {}) => ({ type: "fill", color, ...fields });
const decal = (projector: object, fields: object = {}) => ({
  type: "decal",
  asset: "logo",
  filter: "nearest",
  projector,
  ...fields,
});
const words = (fields: object = {}) => ({ type: "text", text: "Ab", font: "inter", projector: aside, ...fields });
const group = (layers: readonly object[], fields: object = {}) => ({ type: "group", layers, ...fields });
/** A mask that is opaque but for `hidden` of the middle. */
const middleHidden = (hidden = 1) => ({ layers: [decal(middle, { blend: "erase", opacity: hidden })] });

/** A picture without two pixels alike, some of them clear. */
function motley(size: number): Uint8Array {
  const rgba = new Uint8Array(size * size * 4);
  for (let at = 0; at < size * size; at++)
    rgba.set([at % 256, (at * 7) % 251, at >> 4, at % 5 === 0 ? 0 : 255], at * 4);
  return rgba;
}

interface Rendered {
  readonly png: Buffer;
  at(i: number, j: number): number[];
}

interface Bench {
  /** Runs the command on a design of these layers, written as a file. Throws what it wrote to stderr. */
  render(layers: readonly object[], args?: readonly string[]): Promise<Rendered>;
  /** Runs it on a file of the folder. */
  renderFile(file: string, args?: readonly string[]): Promise<Rendered>;
  put(name: string, bytes: Uint8Array | string): void;
  read(name: string): Uint8Array;
}

async function bench(): Promise<Bench> {
  const folder = temporaryFolder();
  const inFolder = (name: string): string => path.join(folder, name);
  const put = (name: string, bytes: Uint8Array | string): void => writeFileSync(inFolder(name), bytes);
  put("plane.glb", planeGlb());
  put("logo.png", await encodePng({ width: 2, height: 2, rgba: new Uint8Array(16).fill(255) }));
  put("pixels.png", await encodePng({ width: SIZE, height: SIZE, rgba: motley(SIZE) }));
  let count = 0;
  const renderFile: Bench["renderFile"] = async (file, args = []) => {
    count += 1;
    const out = `out-${count}.png`;
    const set = ["--out", out, "--base", GROUND, "--size", String(SIZE), ...args];
    const run = await texelcast(["render", "plane.glb", file, ...set], { cwd: folder });
    expect(run).toMatchObject({ code: 0, stderr: "" });
    const png = readFileSync(inFolder(out));
    const { width, rgba } = await decodePicture(png, out);
    return { png, at: (i, j) => Array.from(rgba.subarray(4 * (j * width + i), 4 * (j * width + i) + 4)) };
  };
  return {
    renderFile,
    put,
    read: (name) => readFileSync(inFolder(name)),
    render(layers, args) {
      put("design.json", JSON.stringify({ format: "texelcast-design", version: 1, assets: ASSETS, layers }));
      return renderFile("design.json", args);
    },
  };
}

/** Calls for each of the plane's texels. */
function everyTexel(check: (i: number, j: number) => void): void {
  for (let j = FIRST; j <= LAST; j++) for (let i = FIRST; i <= LAST; i++) check(i, j);
}

const same = (a: Rendered, b: Rendered): boolean => a.png.equals(b.png);

describe("groups in texelcast render", () => {
  it("a group that lets through and hides nothing is its layers, one by one", async () => {
    const { render } = await bench();
    const inside = [fill("#808080", { blend: "multiply" }), decal(middle, { opacity: 0.5, blend: "screen" })];
    const grouped = await render([fill("#c0ff40"), group([inside[0] as object, group([inside[1] as object])])]);
    expect(same(grouped, await render([fill("#c0ff40"), ...inside]))).toBe(true);
  });

  it("a group's opacity is that of what its layers make together", async () => {
    const { render } = await bench();
    const inside = [fill("#c80000"), fill("#00c800", { opacity: 0.5 })];
    for (const isolated of [false, true]) {
      const { at } = await render([fill("#000000"), group(inside, { opacity: 0.5, isolated })]);
      expect(at(30, 30)).toEqual([50, 50, 0, 255]);
    }
  });

  it("an isolated group's layers are blended among themselves, another's with what is below", async () => {
    const { render } = await bench();
    const inside = [decal(middle, { blend: "multiply" }), fill("#808080", { blend: "multiply" })];
    const through = await render([fill("#646464"), group(inside)]);
    const isolated = await render([fill("#646464"), group(inside, { isolated: true })]);
    // 0x64 · 0x80 / 255 = 50.2; among themselves white, then grey, which is laid over the 0x64.
    expect(through.at(30, 30)).toEqual([50, 50, 50, 255]);
    expect(isolated.at(30, 30)).toEqual([0x80, 0x80, 0x80, 255]);
  });

  it("a hidden group, a hidden layer in one, and an empty group paint nothing", async () => {
    const { render } = await bench();
    const below = fill("#408020");
    const plain = await render([below]);
    const hidden = [
      group([fill("#ffffff")], { visible: false }),
      group([fill("#ffffff", { visible: false }), group([decal(middle)], { visible: false })], { isolated: true }),
      group([]),
    ];
    expect(same(plain, await render([below, ...hidden]))).toBe(true);
  });
});

describe("masks in texelcast render", () => {
  const inside = [fill("#ff8000"), decal(whole, { asset: "pixels", opacity: 0.5 })];

  it("a masked group equals its parts put together by hand: hidden where the mask erases, whole elsewhere", async () => {
    const { render } = await bench();
    const shown = await render([group(inside)]);
    const masked = await render([group(inside, { mask: middleHidden() })]);
    const inverted = await render([group(inside, { mask: { ...middleHidden(), invert: true } })]);
    everyTexel((i, j) => {
      expect(masked.at(i, j)).toEqual(isInMiddle(i, j) ? GROUND_TEXEL : shown.at(i, j));
      expect(inverted.at(i, j)).toEqual(isInMiddle(i, j) ? shown.at(i, j) : GROUND_TEXEL);
    });
  });

  it("a mask that hides a quarter of a layer is an opacity of three quarters there", async () => {
    const { render } = await bench();
    const masked = await render([fill("#ff8000", { mask: middleHidden(0.25) })]);
    const faded = await render([fill("#ff8000", { opacity: 0.75 })]);
    const solid = await render([fill("#ff8000")]);
    everyTexel((i, j) => expect(masked.at(i, j)).toEqual((isInMiddle(i, j) ? faded : solid).at(i, j)));
  });

  it("a mask's layer that is hidden hides nothing, and one on top shows again what is hidden below it", async () => {
    const { render } = await bench();
    const solid = await render([fill("#ff8000")]);
    const [erasing] = middleHidden().layers;
    const unseen = { layers: [{ ...erasing, visible: false }] };
    const mended = { layers: [erasing, decal(middle)] };
    for (const mask of [unseen, mended]) expect(same(solid, await render([fill("#ff8000", { mask })]))).toBe(true);
  });

  it("a group in a masked group hides by both masks", async () => {
    const { render } = await bench();
    const mask = middleHidden(0.5);
    const twice = await render([group([group([fill("#ffffff")], { mask })], { mask })]);
    const quarter = await render([fill("#ffffff", { mask: middleHidden(0.75) })]);
    everyTexel((i, j) => expect(twice.at(i, j)).toEqual(quarter.at(i, j)));
  });
});

describe("mirrors in texelcast render", () => {
  const mirror = { axis: "x" };
  const [x, y, z, w] = FACING_DOWN as [number, number, number, number];
  const twin = { ...aside, position: [1, 0.5, 0], rotation: [x, -y, -z, w] };

  it("a mirrored decal is two decals, the other one's left and right exchanged", async () => {
    const { render } = await bench();
    const fields = { asset: "pixels", filter: "linear" };
    const mirrored = await render([decal(aside, { ...fields, mirror })]);
    const two = await render([decal(aside, fields), decal(twin, { ...fields, flipX: true })]);
    expect(same(mirrored, two)).toBe(true);
    const readable = await render([decal(aside, { ...fields, mirror: { ...mirror, readable: true } })]);
    expect(same(readable, await render([decal(aside, fields), decal(twin, fields)]))).toBe(true);
    expect(same(readable, mirrored)).toBe(false);
  });

  it("mirrored words that stay readable are two texts", async () => {
    const { render } = await bench();
    const mirrored = await render([words({ mirror: { ...mirror, readable: true } })]);
    expect(same(mirrored, await render([words(), words({ projector: twin })]))).toBe(true);
  });

  it("a mirrored stroke paints its dabs on both sides, by its own mirror or by its paint layer's", async () => {
    const { render } = await bench();
    const brush = { color: "#ffcc00", hardness: 0.5, flow: 0.5 };
    const dabs = [aside, { ...aside, position: [-0.5, 0.5, 0.5] }, { ...aside, position: [-0.5, 0.5, 0.5] }];
    const twins = dabs.map((dab) => ({ ...dab, position: [-dab.position[0], ...dab.position.slice(1)] }));
    const stroke = (own: readonly object[], fields: object = {}) => ({ type: "stroke", brush, dabs: own, ...fields });
    const both = await render([stroke(dabs.flatMap((dab, at) => [dab, twins[at] as object]))]);
    expect(same(both, await render([stroke(dabs, { mirror })]))).toBe(true);
    const paint = { type: "paint", strokes: [stroke(dabs)], mirror };
    expect(same(both, await render([paint]))).toBe(true);
    expect(same(both, await render([{ ...paint, strokes: [stroke(dabs, { mirror })] }]))).toBe(true);
  });

  it("does not build up where a decal and its twin overlap", async () => {
    const { render } = await bench();
    const centred = { ...aside, position: [0, 0.5, 0] };
    const once = await render([decal(centred, { opacity: 0.5 })]);
    expect(same(once, await render([decal(centred, { opacity: 0.5, mirror })]))).toBe(true);
  });
});

describe("parts and gradients in texelcast render", () => {
  it("a fill of one face leaves the other face's bytes, and with that one it is the whole", async () => {
    const { render } = await bench();
    const none = await render([]);
    const ofParts = (parts: object) => render([fill("#ff8000", { parts })]);
    const first = await ofParts({ kind: "faces", faces: [0] });
    const second = await ofParts({ kind: "faces", faces: [1] });
    const both = await ofParts({ kind: "faces", faces: [0, 1] });
    const chart = await ofParts({ kind: "charts", charts: [1] });
    const painted = [255, 128, 0, 255];
    let ofFirst = 0;
    everyTexel((i, j) => {
      const isFirst = first.at(i, j)[0] === 255;
      ofFirst += Number(isFirst);
      expect(first.at(i, j)).toEqual(isFirst ? painted : none.at(i, j));
      expect(second.at(i, j)).toEqual(isFirst ? none.at(i, j) : painted);
      expect(both.at(i, j)).toEqual(painted);
      expect(chart.at(i, j)).toEqual(painted);
    });
    // The square's diagonal: every texel is one face's, and about half of them the first's.
    expect(Math.abs(ofFirst - 512)).toBeLessThanOrEqual(16);
  });

  it("a linear gradient goes from its first colour to its last by the place on the model", async () => {
    const { render } = await bench();
    const stops = [
      { offset: 0, color: "#000000" },
      { offset: 1, color: "#ffffff" },
    ];
    const gradient = { kind: "linear", from: [-1, 0, 0], to: [1, 0, 0], stops };
    const { at } = await render([fill("#ff0000", { gradient })]);
    everyTexel((i, j) => {
      const share = Math.min(1, Math.max(0, 4 * ((i + 0.5) / SIZE - 0.5) + 0.5));
      const [red = -1, green, blue, alpha] = at(i, j);
      expect(Math.abs(red - 255 * share)).toBeLessThanOrEqual(1);
      expect([green, blue, alpha]).toEqual([red, red, 255]);
    });
  });

  it("a radial gradient lies in rings about its centre, on the parts alone that it is given", async () => {
    const { render } = await bench();
    const stops = [
      { offset: 0, color: "#ffffff" },
      { offset: 1, color: "#000000" },
    ];
    const gradient = { kind: "radial", center: [0, 0.5, 0], radius: 1, stops };
    const everywhere = await render([fill("#ff0000", { gradient })]);
    const half = await render([fill("#ff0000", { gradient, parts: { kind: "faces", faces: [0] } })]);
    const isOne = (texel: number[], among: number[][]): boolean => among.some((one) => String(one) === String(texel));
    everyTexel((i, j) => {
      const distance = Math.hypot(8 * ((i + 0.5) / SIZE - 0.5), 4 * ((j + 0.5) / SIZE - 0.5));
      const [red = -1] = everywhere.at(i, j);
      expect(Math.abs(red - 255 * Math.max(0, 1 - distance))).toBeLessThanOrEqual(1);
      expect(isOne(half.at(i, j), [everywhere.at(i, j), GROUND_TEXEL])).toBe(true);
    });
    expect(half.at(FIRST + 1, LAST - 1)).not.toEqual(half.at(LAST - 1, FIRST + 1));
  });
});

describe("pixel layers and words in texelcast render", () => {
  it("a pixel layer's every pixel is a texel's, and a clear one leaves what is below", async () => {
    const { render } = await bench();
    const { at } = await render([decal(whole, { asset: "pixels" })]);
    const pixels = motley(SIZE);
    everyTexel((i, j) => {
      const pixel = Array.from(pixels.subarray(4 * (j * SIZE + i), 4 * (j * SIZE + i) + 4));
      expect(at(i, j)).toEqual(pixel[3] === 0 ? GROUND_TEXEL : pixel);
    });
  });

  it("words keep to their box, in a font that comes with Texelcast, and hidden ones paint nothing", async () => {
    const { render } = await bench();
    const none = await render([]);
    const written = await render([words({ color: "#ffffff" })]);
    let lettered = 0;
    everyTexel((i, j) => {
      const isInBox = i >= 20 && i < 28 && j >= 24 && j < 40;
      const isGround = String(written.at(i, j)) === String(GROUND_TEXEL);
      if (isInBox && !isGround) lettered += 1;
      // A texel around it may take part in the box's edge.
      if (i < 19 || i > 28 || j < 23 || j > 40) expect(isGround).toBe(true);
    });
    expect(lettered).toBeGreaterThan(16);
    expect(same(none, await render([words({ visible: false })]))).toBe(true);
    expect(same(written, await render([group([words({ color: "#ffffff" })])]))).toBe(true);
  });
});

describe("a saved design with all of them", () => {
  const mirror = { axis: "x" };
  const stops = [
    { offset: 0, color: "#ff0000" },
    { offset: 1, color: "#0000ff80" },
  ];
  const dabs = [aside, { ...aside, position: [-0.7, 0.5, 0.3], flow: 0.4 }];
  const layers = [
    fill("#808080", {
      gradient: { kind: "linear", from: [-1, 0, 0], to: [1, 0, 1], stops },
      parts: { kind: "faces", faces: [1] },
    }),
    group(
      [
        decal(whole, { asset: "pixels", opacity: 0.7, blend: "overlay" }),
        group([words({ mirror: { ...mirror, readable: true }, color: "#ffee00" })], {
          isolated: true,
          blend: "difference",
        }),
      ],
      { opacity: 0.8, mask: { ...middleHidden(0.6), invert: true } },
    ),
    { type: "paint", strokes: [{ type: "stroke", brush: { color: "#00ff88", flow: 0.6 }, dabs }], mirror },
  ];

  it.each([64, 96])(
    "comes out as the page's engine draws it, from a .json and a .texelcast, at %i texels",
    async (size) => {
      const { render, renderFile, put, read } = await bench();
      const args = ["--size", String(size)];
      const rendered = await render(layers, args);
      const design = parseDesign({ format: "texelcast-design", version: 1, assets: ASSETS, layers });
      const project = writeProjectFile({
        name: "all",
        design,
        assetBytes: (_key, { type, uri }) => (type === "image/png" ? read(uri) : undefined),
        targets: [],
        model: { title: "plane.glb", demo: null, source: null },
      });
      put("all.texelcast", project);
      expect(same(rendered, await renderFile("all.texelcast", args))).toBe(true);

      const engine = createEngineHost();
      await engine.loadModel({ name: "plane.glb", bytes: planeGlb() });
      const base = [0x20 / 255, 0x40 / 255, 0x60 / 255, 1] as const;
      await engine.openTarget({ material: 0, width: size, height: size, base });
      for (const key of ["logo", "pixels"]) await engine.setAsset(key, { name: key, bytes: read(`${key}.png`) });
      engine.setLayers(resolveLayers(design), 1);
      await engine.idle();
      expect(rendered.png.equals(Buffer.from(await engine.exportPng(0)))).toBe(true);
      engine.dispose();
    },
  );
});
