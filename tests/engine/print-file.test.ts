import { createHash } from "node:crypto";
import { afterEach, describe, expect, it } from "vitest";
import type { EngineLayer } from "../../web/engine/engine-api.ts";
import type { EngineHost } from "../../web/engine/engine-host.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { NO_ZONES, type PrintZone } from "../../web/engine/print-zones.ts";
import { decal, FRONT } from "../support/layers.ts";
import { buildGlb, plane } from "../support/model-builder.ts";
import { CHART, endHosts, LOGO, startHost, texturedPlane } from "../support/painted-plane.ts";
import { paintPng } from "../support/png-file.ts";
import { LEFT_HALF, zones } from "../support/zones.ts";

afterEach(endHosts);

const ZONES = zones({}, { printScale: 0.1 });

const QUARTERS = paintPng(64, 64, (x, y) => [x < 32 ? 255 : 0, y < 32 ? 255 : 0, 0, 255]);
const LOGO_LAYER = decal("logo", "logo", { projector: { ...FRONT, size: [0.6, 0.6, 0.5] }, occlusion: "none" });

async function printable(
  layers: readonly EngineLayer[] = [LOGO_LAYER],
  bytes = buildGlb(texturedPlane),
): Promise<EngineHost> {
  const engine = startHost();
  await engine.loadModel({ name: "plane.glb", bytes });
  await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
  await engine.setAsset("quarters", { name: "quarters.png", bytes: QUARTERS });
  engine.setLayers(layers, 1);
  return engine;
}

function chunks(png: Uint8Array): { type: string; data: Uint8Array }[] {
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
  const found: { type: string; data: Uint8Array }[] = [];
  for (let at = 8; at < png.length; at += view.getUint32(at) + 12) {
    const type = String.fromCharCode(...png.subarray(at + 4, at + 8));
    found.push({ type, data: png.subarray(at + 8, at + 8 + view.getUint32(at)) });
  }
  return found;
}

const pixels = async (bytes: Uint8Array) => decodePicture(bytes, "print.png");

describe("a print file", () => {
  it("holds the texels that the exported texture has, whatever is open", async () => {
    const engine = await printable();
    const closed = await engine.exportPrint({ size: 64 });
    await engine.openTarget({ material: 0, width: 64, height: 64 });
    const texture = await decodePicture(await engine.exportPng(0), "texture.png");
    const open = await engine.exportPrint({ size: 64 });
    expect(open.sha256).toBe(closed.sha256);
    expect(await pixels(open.bytes)).toEqual(texture);
  });

  it("is refused where a layer, a hidden one too, names a material that the model lacks: no server would print it", async () => {
    for (const visible of [true, false]) {
      const engine = await printable([LOGO_LAYER, { ...LOGO_LAYER, id: "other", material: [0, 7], visible }]);
      await expect(engine.exportPrint({ size: 64 })).rejects.toMatchObject({ code: "no-material" });
    }
  });

  it("has the material's own size where none is asked for, sRGB, and the density of its texels as pHYs", async () => {
    const engine = await printable();
    await engine.setZones({ ...NO_ZONES, printScale: 0.1 });
    const print = await engine.exportPrint();
    expect([print.width, print.height]).toEqual([64, 64]);
    expect(print.dpi[0]).toBeCloseTo(64 / 0.1 / 39.3700787, 3);
    expect(chunks(print.bytes).map(({ type }) => type)).toEqual(["IHDR", "sRGB", "pHYs", "IDAT", "IEND"]);
    const size = chunks(print.bytes)[2]?.data as Uint8Array;
    expect([...size]).toEqual([0, 0, 2, 128, 0, 0, 2, 128, 1]);
  });

  it("is named by the SHA-256 of its bytes", async () => {
    const { bytes, sha256 } = await (await printable()).exportPrint({ size: 32 });
    expect(sha256).toBe(createHash("sha256").update(bytes).digest("hex"));
  });

  it("is as large as its DPI ask for, in powers of two", async () => {
    const engine = await printable();
    await engine.setZones({ ...NO_ZONES, printScale: 0.1 });
    const print = await engine.exportPrint({ dpi: 100 });
    expect(print.width).toBe(512);
    expect(print.dpi[0]).toBeGreaterThanOrEqual(100);
    await expect(engine.exportPrint({ dpi: 9000 })).rejects.toMatchObject({ code: "bad-size", field: "dpi" });
  });

  it("is painted by windows to the very bytes of the whole", async () => {
    const engine = await printable([
      LOGO_LAYER,
      decal("q", "quarters", { projector: { ...FRONT, position: [0.3, -0.3, 0] } }),
    ]);
    const whole = await engine.exportPrint({ size: [320, 304] });
    const windows = await engine.prints.file({ size: [320, 304] }, undefined, undefined, 96);
    expect(windows.sha256).toBe(whole.sha256);
  });

  it.each<[number, number]>([
    [16384, 32],
    [24, 10000],
  ])(
    "is painted by windows where it is longer than a target may be, however few texels it has: %i × %i",
    async (width, height) => {
      const engine = await printable();
      const print = await engine.exportPrint({ size: [width, height] });
      expect(print).toMatchObject({ width, height });
      const others = await engine.prints.file({ size: [width, height] }, undefined, undefined, 4096);
      expect(others.sha256).toBe(print.sha256);
    },
  );

  it("shows a zone alone, clear outside of it and its bleed", async () => {
    const engine = await printable();
    await engine.setZones({ ...ZONES, zones: [{ ...LEFT_HALF, policy: "warn", bleed: 10 }] });
    const print = await engine.exportPrint({ size: 100, zone: "left" });
    expect(print.height).toBe(100);
    const { rgba, width } = await pixels(print.bytes);
    const alphaAt = (x: number): number => rgba[(50 * width + x) * 4 + 3] ?? -1;
    expect([alphaAt(0), alphaAt(59), alphaAt(60)]).toEqual([255, 255, 0]);
    const windows = await engine.prints.file({ size: 100, zone: "left" }, undefined, undefined, 48);
    expect(windows.sha256).toBe(print.sha256);
  });

  it("lies on nothing where its base is to be left out", async () => {
    const engine = await printable();
    const { rgba } = await pixels((await engine.exportPrint({ size: 64, base: "none" })).bytes);
    expect([...rgba.subarray(0, 4)]).toEqual([0, 0, 0, 0]);
    expect(rgba[(32 * 64 + 32) * 4 + 3]).toBe(200);
  });

  it.each<[string, object, string]>([
    ["a zone that is not there", { zone: "right" }, "zone"],
    ["flat art of no zone", { flattened: true }, "flattened"],
    ["a zone of another material", { zone: "left", material: 1 }, "material"],
    ["no DPI", { dpi: 0 }, "dpi"],
    ["DPI of text", { dpi: "300" }, "dpi"],
    ["a zone of a number", { zone: 1 }, "zone"],
    ["another base", { base: "white" }, "base"],
    ["an option that there is not", { dip: 300 }, "dip"],
    ["DPI beside a size, which has said how many texels there are", { size: 64, dpi: 300 }, "dpi"],
  ])("is refused for %s, by name", async (_what, options, field) => {
    const engine = await printable();
    await engine.setZones(ZONES);
    await expect(engine.exportPrint(options)).rejects.toMatchObject({ code: "bad-argument", field });
  });

  it("is refused where none of its texels lies on the model, which is named with what to do", async () => {
    const whole = plane(1, 0);
    const corner = { ...whole, uvs: whole.uvs?.map((value) => value / 10) ?? [] };
    const engine = await printable([], buildGlb({ ...texturedPlane, meshes: [corner] }));
    await expect(engine.exportPrint({ size: 2 })).rejects.toMatchObject({
      code: "bad-zones",
      message: "Material 0 of “plane.glb” has no surface to print at 2 × 2 texels.",
      subject: "plane.glb",
      field: "material",
      value: "0",
      hint: expect.stringContaining("larger texture"),
    });
  });

  it("is refused in a size that there is not, and can be cancelled", async () => {
    const engine = await printable();
    for (const [size, value] of [
      [20_000, "20000"],
      ["64", '"64"'],
      [[64], "[64]"],
      [{ width: 64 }, "an object"],
    ] as const) {
      const refusal = { code: "bad-size", field: "size", value };
      await expect(engine.exportPrint({ size: size as number })).rejects.toMatchObject(refusal);
    }
    const cancel = new AbortController();
    cancel.abort();
    await expect(engine.exportPrint({ size: 64 }, undefined, cancel.signal)).rejects.toMatchObject({
      code: "cancelled",
    });
  });
});

describe("flat art", () => {
  const whole: PrintZone = {
    ...LEFT_HALF,
    id: "all",
    shape: {
      kind: "uv",
      polygon: [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
      ],
    },
  };
  const zones = { ...NO_ZONES, printScale: 0.1, zones: [whole] };
  const art = { zone: "all", flattened: true, dpi: 50, size: 256, base: "none" } as const;
  const QUARTERS_LAYER = decal("q", "quarters", { projector: { ...FRONT, size: [1, 1, 1] }, occlusion: "none" });

  const cornersOf = async (bytes: Uint8Array): Promise<number[][]> => {
    const { width, height, rgba } = await pixels(bytes);
    const at = (x: number, y: number): number[] => {
      const from = (Math.floor(y * height) * width + Math.floor(x * width)) * 4;
      return [...rgba.subarray(from, from + 4)];
    };
    return [at(0.25, 0.25), at(0.75, 0.25), at(0.25, 0.75), at(0.75, 0.75)];
  };
  const YELLOW = [255, 255, 0, 255];
  const GREEN = [0, 255, 0, 255];
  const RED = [255, 0, 0, 255];
  const BLACK = [0, 0, 0, 255];

  it("has the zone's true size at its DPI, and says it", async () => {
    const engine = await printable([QUARTERS_LAYER]);
    await engine.setZones(zones);
    const print = await engine.exportPrint(art);
    expect([print.width, print.height]).toEqual([197, 197]);
    expect(print.dpi).toEqual([50, 50]);
    expect(await cornersOf(print.bytes)).toEqual([YELLOW, GREEN, RED, BLACK]);
  });

  it.each<[string, (u: number, v: number) => [number, number]]>([
    ["turned on its side", (u, v) => [1 - v, u]],
    ["turned upside down", (u, v) => [1 - u, 1 - v]],
    ["mirrored", (u, v) => [1 - u, v]],
    ["mirrored and turned", (u, v) => [v, u]],
    ["pressed together", (u, v) => [u / 2, v]],
  ])("comes out upright and readable from a texture that lies %s", async (_how, place) => {
    const mesh = plane(1, 0);
    const uvs = Array.from(mesh.uvs ?? []);
    for (let i = 0; i < uvs.length; i += 2) [uvs[i], uvs[i + 1]] = place(uvs[i] as number, uvs[i + 1] as number);
    const turned = buildGlb({ meshes: [{ ...mesh, uvs }], materials: [{ name: "m" }] });
    const engine = await printable([QUARTERS_LAYER], turned);
    await engine.setZones(zones);
    const print = await engine.exportPrint(art);
    expect([print.width, print.height]).toEqual([197, 197]);
    expect(await cornersOf(print.bytes)).toEqual([YELLOW, GREEN, RED, BLACK]);
  });

  it.each([
    ["straight", 0, 0],
    ["a share of a texel further", 0, 0.00137],
    ["turned in the texture", 30, 0],
    ["turned the other way, and a share of a texel further", -10, 0.0007],
  ])(
    "has the millimetres of its zone to the pixel, wherever the edges lie among the texels: %s",
    async (_how, degrees, further) => {
      const angle = (degrees * Math.PI) / 180;
      const turned = (u: number, v: number): [number, number] => {
        const [x, y] = [0.6 * (u - 0.5), 0.6 * (v - 0.5)];
        return [0.5 + Math.cos(angle) * x - Math.sin(angle) * y, 0.5 + Math.sin(angle) * x + Math.cos(angle) * y];
      };
      const mesh = plane(1, 0);
      const uvs = [0, 1, 2, 3].flatMap((corner) =>
        turned(mesh.uvs?.[corner * 2] ?? 0, mesh.uvs?.[corner * 2 + 1] ?? 0),
      );
      const engine = await printable(
        [QUARTERS_LAYER],
        buildGlb({ meshes: [{ ...mesh, uvs }], materials: [{ name: "m" }] }),
      );
      const [left, top] = [0.1 + further, 0.2 + further];
      const corners = [
        turned(left, top),
        turned(left + 0.4, top),
        turned(left + 0.4, top + 0.6),
        turned(left, top + 0.6),
      ];
      // 40 × 60 mm, ten pixels a millimetre.
      await engine.setZones({ ...zones, zones: [{ ...whole, shape: { kind: "uv", polygon: corners } }] });
      const { width, height } = await engine.exportPrint({ ...art, dpi: 254, size: 1024 });
      expect([width, height]).toEqual([400, 600]);
    },
  );

  it("is refused before a texel is held where the zone takes more of them than can be laid out at once", async () => {
    const engine = await printable([QUARTERS_LAYER]);
    await engine.setZones(zones);
    await expect(engine.exportPrint({ ...art, size: 16_384 })).rejects.toMatchObject({
      code: "out-of-budget",
      field: "size",
      value: "16384 × 16384",
    });
  });
});

it("keeps the model's own picture under the print", async () => {
  const engine = await printable([]);
  expect(await pixels((await engine.exportPrint()).bytes)).toEqual(await decodePicture(CHART, "chart.png"));
});
