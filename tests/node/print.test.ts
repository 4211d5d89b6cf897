import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { checkPrint, renderPrint } from "../../node/print.ts";
import { parseDesign, resolveLayers } from "../../web/editor/document/index.ts";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { FACING_DOWN, plainPng, planeGlb } from "./plane-model.ts";
import { temporaryFolder, texelcast } from "./run-cli.ts";

/** The plane is 4 m wide and 2 m deep, in the middle half of its texture. */
const decal = (fields: object = {}) => ({
  type: "decal",
  id: "logo",
  asset: "logo",
  projector: { kind: "planar", position: [0, 0.5, 0], rotation: FACING_DOWN, size: [1, 1, 0.2] },
  ...fields,
});
const design = (layers: readonly object[]) => ({
  format: "texelcast-design",
  version: 1,
  assets: { logo: { type: "image/png", uri: "logo.png" } },
  layers,
});
const zone = (fields: object = {}) => ({
  id: "left",
  shape: {
    kind: "uv",
    polygon: [
      [0.25, 0.25],
      [0.5, 0.25],
      [0.5, 0.75],
      [0.25, 0.75],
    ],
  },
  ...fields,
});
/** One to a hundred: the logo of 100 pixels is a square centimetre of print. */
const zones = (list: readonly object[]) => ({ texelcastZones: 1, printScale: 0.01, zones: list });
const LOGO = await plainPng(100, 100, [255, 0, 0, 255]);

async function workbench(layers: readonly object[], zonesFile: unknown = zones([zone()])) {
  const folder = temporaryFolder();
  writeFileSync(path.join(folder, "plane.glb"), planeGlb());
  writeFileSync(path.join(folder, "logo.png"), LOGO);
  writeFileSync(path.join(folder, "design.json"), JSON.stringify(design(layers)));
  writeFileSync(path.join(folder, "zones.json"), JSON.stringify(zonesFile));
  const run = (command: string, ...args: string[]) =>
    texelcast([command, "plane.glb", "design.json", ...args], { cwd: folder });
  return { folder, run };
}

const inLeft = { ...decal().projector, position: [-1, 0.5, 0] };

describe("texelcast check", () => {
  it("exits with 0 where all may be printed, and tells the numbers", async () => {
    const { run } = await workbench([decal({ projector: inLeft })]);
    const { code, stdout, stderr } = await run("check", "--zones", "zones.json");
    expect(stderr).toBe("");
    expect(stdout).toContain("may be printed");
    expect(stdout).toMatch(/logo\s+254\s+254\s+0 %\s+0\.0 %/);
    expect(code).toBe(0);
  });

  it("exits with 3 where something must not be printed, and names layer and zone", async () => {
    const { run } = await workbench([decal()], zones([zone({ policy: "warn" })]));
    const { code, stdout } = await run("check", "--zones", "zones.json", "--json");
    expect(code).toBe(3);
    const report = JSON.parse(stdout);
    expect(report.layers[0].outsideZones).toBeCloseTo(0.5, 2);
    expect(report.violations).toEqual([
      expect.objectContaining({ code: "outside-zones", layer: "logo", zone: "left", value: 50 }),
    ]);
  });

  it("exits with 3 where something must not be printed, though its reader has gone", async () => {
    const { folder } = await workbench([decal()], zones([zone({ policy: "warn" })]));
    const args = ["check", "plane.glb", "design.json", "--zones", "zones.json"];
    expect(await texelcast(args, { cwd: folder, stdout: "closed pipe" })).toMatchObject({ code: 3, stderr: "" });
  });

  it("exits with 3 for a zone on a material that the model lacks, and names both and the materials there are", async () => {
    const { run } = await workbench([decal()], zones([zone({ material: 7 })]));
    const { code, stdout } = await run("check", "--zones", "zones.json");
    expect(code).toBe(3);
    expect(stdout).toContain("VIOLATION zone-without-material, zone left: The zone “left” is on material 7");
    expect(stdout).toMatch(/Give it one of the model's: 0\b/);
  });

  it("exits with 3 for a zones file that it cannot read, and with 2 where it is used wrongly", async () => {
    const { run } = await workbench([decal()], zones([zone({ bleed: "3mm" })]));
    const refused = await run("check", "--zones", "zones.json");
    expect(refused.code).toBe(3);
    expect(refused.stderr).toContain("zones[0].bleed: must be a number from 0 to 10000 millimetres");
    expect((await run("check", "--zone", "left")).code).toBe(2);
  });
});

describe("texelcast print", () => {
  it("writes the zone flat, at its size in print, and prints the hash of the file", async () => {
    const { folder, run } = await workbench([decal()]);
    const args = ["--zones", "zones.json", "--zone", "left", "--flattened", "--dpi", "254", "--out", "left.png"];
    const { code, stdout, stderr } = await run("print", ...args);
    expect(stderr).toBe("");
    expect(code).toBe(0);
    const bytes = readFileSync(path.join(folder, "left.png"));
    const { width, height } = await decodePicture(bytes, "left.png");
    expect([width, height]).toEqual([200, 200]);
    expect(stdout).toContain(`sha256 ${createHash("sha256").update(bytes).digest("hex")}`);
  });

  it("refuses a zone that is not there as wrong usage, and names the zones file and the option", async () => {
    const { run } = await workbench([decal()]);
    const { code, stderr } = await run("print", "--zones", "zones.json", "--zone", "right", "--out", "x.png");
    expect(code).toBe(2);
    expect(stderr).toBe(
      "texelcast: zones.json: --zone: There is no zone “right”: there are “left”.\n" +
        "  Check the id; upper and lower case differ.\n",
    );
  });

  it("refuses a material that the zones file says the zone is not on with exit code 3, and names the file and the option", async () => {
    const { folder, run } = await workbench([decal()]);
    const args = ["--zones", "zones.json", "--zone", "left", "--material", "1", "--out", "x.png"];
    const { code, stdout, stderr } = await run("print", ...args);
    expect(stderr).toBe(
      "texelcast: zones.json: --material: The zone “left” is one of material 0, not of 1.\n" +
        "  Leave --material out: the zone's own is taken.\n",
    );
    expect(code).toBe(3);
    expect(stdout).toBe("");
    expect(existsSync(path.join(folder, "x.png"))).toBe(false);
  });

  it("prints a zone whose own material is named beside it", async () => {
    const { run } = await workbench([decal()]);
    const args = ["--zones", "zones.json", "--zone", "left", "--material", "0", "--size", "16", "--out", "x.png"];
    expect(await run("print", ...args)).toMatchObject({ code: 0, stderr: "" });
  });

  it("names the model and the option where it has no such material", async () => {
    const { run } = await workbench([decal()]);
    expect(await run("print", "--material", "2", "--out", "x.png")).toMatchObject({
      code: 3,
      stdout: "",
      stderr:
        "texelcast: plane.glb: --material: the model has no material 2, it has materials 0 to 1\n" +
        "  `texelcast inspect` lists the materials of a model.\n",
    });
  });

  it("exits with 3 for a material that cannot be painted, and names what asks for it", async () => {
    const { run } = await workbench([decal()], zones([zone({ material: 1 })]));
    const why = 'material 1 ("of no triangle") cannot be painted: there are no triangles to paint\n';
    const how = '  Choose one that can: 0 ("paint").\n';
    expect(await run("print", "--material", "1", "--out", "x.png")).toMatchObject({
      code: 3,
      stderr: `texelcast: plane.glb: --material: ${why}${how}`,
    });
    expect(await run("print", "--zones", "zones.json", "--zone", "left", "--out", "x.png")).toMatchObject({
      code: 3,
      stderr: `texelcast: zones.json: zones[0].material: ${why}${how}`,
    });
  });

  it("refuses two sizes of one texture as wrong usage, and takes both where the art is laid out flat", async () => {
    const { run } = await workbench([decal()]);
    expect(await run("print", "--size", "16", "--dpi", "300", "--out", "x.png")).toEqual({
      code: 2,
      signal: null,
      stdout: "",
      stderr:
        "texelcast: --dpi: --size has said already how many texels are printed, so 300 DPI cannot be kept\n" +
        "  Give one of the two.\n",
    });
    const flat = ["--zones", "zones.json", "--zone", "left", "--flattened"];
    expect(await run("print", ...flat, "--size", "16", "--dpi", "100", "--out", "x.png")).toMatchObject({ code: 0 });
  });

  it("says to look at the print scale where by it no DPI at all can be printed", async () => {
    const { run } = await workbench([decal()], { ...zones([zone()]), printScale: 1000 });
    const { code, stderr } = await run(
      "print",
      "--zones",
      "zones.json",
      "--zone",
      "left",
      "--flattened",
      "--out",
      "x.png",
    );
    expect(stderr).toContain("300 DPI would need a texture larger than");
    expect(stderr).toMatch(/print scale: 1000 /);
    expect(code).toBe(3);
  });

  it("names the option whose DPI no texture has, and the zones file whose zone lies on nothing", async () => {
    const { run } = await workbench(
      [decal()],
      zones([
        zone({
          shape: {
            kind: "uv",
            polygon: [
              [0, 0],
              [0.1, 0],
              [0.1, 0.1],
            ],
          },
        }),
      ]),
    );
    const dense = await run("print", "--dpi", "10000", "--out", "x.png");
    expect(dense.stderr).toMatch(
      /^texelcast: --dpi: 10000 DPI would need a texture larger than 16384 × 16384 texels\.\n {2}Ask for \d+ DPI/,
    );
    expect(dense.code).toBe(3);
    const empty = await run("print", "--zones", "zones.json", "--zone", "left", "--out", "x.png");
    expect(empty.stderr).toMatch(/^texelcast: zones\.json: The zone “left” has no surface to print\.\n {2}[A-Z]/);
    expect(empty.code).toBe(3);
  });

  it("refuses a zones file that is no UTF-8, whose letters would stand for others", async () => {
    const { folder, run } = await workbench([decal()]);
    writeFileSync(
      path.join(folder, "zones.json"),
      Buffer.from(JSON.stringify(zones([zone({ id: "Größe" })])), "latin1"),
    );
    for (const [command, ...more] of [["check"], ["print", "--out", "x.png"]] as const) {
      expect(await run(command, "--zones", "zones.json", ...more)).toEqual({
        code: 3,
        signal: null,
        stdout: "",
        stderr:
          "texelcast: zones.json: the zones file is not UTF-8 text\n  A zones file is a JSON file: save it as UTF-8.\n",
      });
    }
  });

  it("refuses a zone or flat art as wrong usage where no file or no zone is named", async () => {
    const { run } = await workbench([decal()]);
    const withoutFile = await run("print", "--zone", "left", "--out", "x.png");
    expect(withoutFile).toMatchObject({ code: 2, stdout: "" });
    expect(withoutFile.stderr).toBe(
      'texelcast: --zone: there is no zone "left" without a zones file\n  Name that file with --zones.\n',
    );
    const withoutZone = await run("print", "--zones", "zones.json", "--flattened", "--out", "x.png");
    expect(withoutZone).toMatchObject({ code: 2, stdout: "" });
    expect(withoutZone.stderr).toBe(
      "texelcast: --flattened: only a zone can be laid out flat\n" +
        "  Name the zones file with --zones and one of its zones with --zone.\n",
    );
  });
});

describe("a design for another model", () => {
  const fill = (fields: object) => ({ type: "fill", color: "#ff0000", ...fields });
  const there = decal();
  const OTHERS: [string, object[], string][] = [
    ["a layer", [there, decal({ id: "b", material: 7 })], "layers[1].material"],
    ["a hidden layer", [decal({ visible: false, material: 7 })], "layers[0].material"],
    ["one of a layer's materials", [decal({ material: [0, 7] })], "layers[0].material[1]"],
    ["a layer in a group", [{ type: "group", layers: [decal({ material: 7 })] }], "layers[0].layers[0].material"],
    ["a layer of a mask", [decal({ mask: { layers: [fill({ material: 7 })] } })], "layers[0].mask.layers[0].material"],
  ];

  it.each(OTHERS)(
    "is refused by print and check where %s is on a material that is not there",
    async (_what, layers, field) => {
      const { folder, run } = await workbench(layers);
      for (const args of [["print", "--out", "x.png"], ["check"]] as const) {
        const [command, ...rest] = args;
        const { code, stdout, stderr } = await run(command, ...rest);
        expect(stderr).toBe(
          `texelcast: design.json: ${field}: the model has no material 7, it has materials 0 to 1\n` +
            "  `texelcast inspect` lists the materials of a model.\n",
        );
        expect(code).toBe(3);
        expect(stdout).toBe("");
      }
      expect(existsSync(path.join(folder, "x.png"))).toBe(false);
    },
  );

  it.each(OTHERS)(
    "is refused by renderPrint where %s is on a material that is not there",
    async (_what, layers, field) => {
      const subject = { model: planeGlb(), design: design(layers), assets: [{ name: "logo.png", bytes: LOGO }] };
      await expect(renderPrint({ ...subject, size: 16 })).rejects.toMatchObject({
        code: "no-material",
        field,
        value: "7",
      });
    },
  );

  it.each([
    ["faces", { kind: "faces", faces: [0, 99] }, "layers[0].parts.faces[1]", 99],
    ["charts", { kind: "charts", charts: [2] }, "layers[0].parts.charts[0]", 2],
  ] as const)("is refused as a bad design where a fill's %s are not there", async (_what, parts, field, value) => {
    const { folder, run } = await workbench([fill({ parts })]);
    for (const [command, ...rest] of [["render", "--out", "x.png"], ["print", "--out", "x.png"], ["check"]] as const) {
      const { code, stdout, stderr } = await run(command, ...rest);
      expect(stderr).toBe(
        `texelcast: design.json: ${field}: is ${value}, but material 0 has 2 triangles, counted from 0\n` +
          "  The fill was made for another model, or for another material: choose its parts anew.\n",
      );
      expect(code).toBe(3);
      expect(stdout).toBe("");
    }
    expect(existsSync(path.join(folder, "x.png"))).toBe(false);
  });
});

describe("renderPrint and checkPrint", () => {
  const subject = { model: planeGlb(), design: design([decal()]), zones: zones([zone()]) };

  it("take a design and zones as the bytes of their files, and refuse bytes that are no text", async () => {
    const files = { ...subject, assets: [{ name: "logo.png", bytes: LOGO }], size: 16 };
    const bytesOf = (data: object): Uint8Array => Buffer.from(JSON.stringify(data));
    const { sha256 } = await renderPrint(files);
    const read = { ...files, design: bytesOf(files.design), zones: bytesOf(files.zones) };
    expect((await renderPrint(read)).sha256).toBe(sha256);
    const wrong = Uint8Array.of(0xff, 0xfe);
    await expect(renderPrint({ ...files, design: wrong })).rejects.toMatchObject({ code: "bad-design" });
    await expect(checkPrint({ ...subject, zones: wrong })).rejects.toMatchObject({ code: "bad-zones" });
  });

  it("say of a path in a design's or a zones file's place that what is in the file is wanted", async () => {
    for (const [given, code] of [
      [{ design: "orders/design.json" }, "bad-design"],
      [{ zones: "mug.zones.json" }, "bad-zones"],
    ] as const) {
      const refusal = expect(renderPrint({ ...subject, ...given })).rejects;
      await refusal.toMatchObject({ code, hint: expect.stringContaining("readFile(") });
    }
    await expect(renderPrint({ ...subject, design: "{ format:" })).rejects.toMatchObject({
      hint: expect.stringContaining("commas"),
    });
  });

  it("name a model that is not there in the message alone, which is what a server logs", async () => {
    await expect(renderPrint({ ...subject, model: "no-such.glb" })).rejects.toMatchObject({
      code: "missing-file",
      subject: "no-such.glb",
      message: "“no-such.glb”: there is no such file",
    });
  });

  it("say that a model's side files come as a Map", async () => {
    const model = { name: "plane.gltf", bytes: planeGlb(), resources: {} };
    const message = /^model: must be .* resources a Map of addresses to bytes/;
    await expect(checkPrint({ ...subject, model: model as never })).rejects.toThrow(message);
  });
  const assets = [{ name: "logo.png", bytes: LOGO }];

  it("gives the bytes that the engine of the page exports", async () => {
    const print = await renderPrint({ ...subject, assets, size: 128, zone: "left" });
    const { parseZones } = await import("../../web/editor/document/zones.ts");
    const engine = createEngineHost();
    await engine.loadModel({ name: "another-name.glb", bytes: subject.model });
    await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
    await engine.setZones(parseZones(subject.zones));
    await engine.openTarget({ material: 0, width: 32, height: 32, mipmaps: true });
    engine.setLayers(resolveLayers(parseDesign(subject.design)), 7);
    const page = await engine.exportPrint({ size: 128, zone: "left" });
    engine.dispose();
    expect(page.sha256).toBe(print.sha256);
    expect(page.bytes).toEqual(print.bytes);
  });

  it("asks for the design's files by their addresses", async () => {
    const asked: string[] = [];
    const read = (uri: string): Uint8Array => {
      asked.push(uri);
      return LOGO;
    };
    const print = await renderPrint({ ...subject, assets: read, size: 64 });
    expect(asked).toEqual(["logo.png"]);
    expect(print.sha256).toBe((await renderPrint({ ...subject, assets, size: 64 })).sha256);
    await expect(renderPrint({ ...subject, size: 64 })).rejects.toMatchObject({
      code: "missing-file",
      field: "assets.logo",
    });
  });

  const usual = { ...subject, assets, size: 16 };
  const NO_MODEL: [string, object, string][] = [
    null,
    3,
    {},
    new ArrayBuffer(4),
    new URL("file:///x"),
    { name: "x.glb", bytes: "x" },
  ].map((model) => [`a model that is ${JSON.stringify(model)}`, { model }, "model"]);

  it.each<[string, object, string]>([
    ...NO_MODEL,
    ["assets that are an object", { assets: {} }, "assets"],
    ["assets that are a map", { assets: new Map() }, "assets"],
    ["an asset without bytes", { assets: [{ name: "logo.png" }] }, "assets[0].bytes"],
    ["an asset that is null", { assets: [null] }, "assets[0]"],
    ["assets read as text", { assets: () => "text" }, "assets"],
    ["assets read as an ArrayBuffer", { assets: () => new ArrayBuffer(3) }, "assets"],
    ["assets read as a list", { assets: async () => [1, 2] }, "assets"],
    ["a size of null", { size: null }, "size"],
    ["a size that is text", { size: "64" }, "size"],
    ["progress that is a number", { onProgress: 3 }, "onProgress"],
    ["a signal that is none", { signal: 3 }, "signal"],
    ["a zone that is a number", { zone: 3 }, "zone"],
    ["a base that is unknown", { base: "white" }, "base"],
  ])("refuse %s by argument and value", async (_what, fields, field) => {
    const error = await renderPrint({ ...usual, ...fields } as never).catch((thrown: unknown) => thrown);
    expect(error).toMatchObject({ name: "TexelcastError", code: "bad-argument", field });
    expect((error as { value: string }).value).toMatch(/./);
  });

  it("refuses DPI beside a size as the command line does, before anything is read", async () => {
    const both = { ...usual, model: "no-such.glb", dpi: 300 };
    await expect(renderPrint(both)).rejects.toMatchObject({ code: "bad-argument", field: "dpi", value: "300" });
    const flat = await renderPrint({ ...usual, zone: "left", flattened: true, dpi: 100 });
    expect(flat.dpi).toEqual([100, 100]);
  });

  it("refuse an option that there is not by its name and value, and the print's report alike", async () => {
    const told = { code: "bad-argument", value: "300", hint: expect.stringContaining("docs/guides/server.md") };
    for (const print of [renderPrint, checkPrint]) {
      const slip = { ...usual, dip: 300 };
      await expect(print(slip)).rejects.toMatchObject({ ...told, field: "dip", message: "dip: is no option, is 300" });
    }
    await expect(checkPrint({ ...usual, dpi: 300 } as never)).rejects.toMatchObject({ ...told, field: "dpi" });
  });

  it('take the files as the element\'s "submit" gives them, hashes and all', async () => {
    const assets = [{ key: "logo", type: "image/png", name: "logo.png", sha256: "0", bytes: LOGO }];
    const print = await renderPrint({ ...usual, design: design([decal()]), assets, zones: undefined });
    expect(print.sha256).toMatch(/^[0-9a-f]{64}$/);
  });

  it("name the option and the materials there are for one that cannot be painted", async () => {
    const plain = { design: design([]), size: 16 };
    const model = planeGlb();
    await expect(renderPrint({ ...plain, model, material: 1 })).rejects.toMatchObject({
      ...{ code: "no-triangles", subject: "model.glb", field: "material", value: "1" },
      message: 'material: material 1 ("of no triangle") cannot be painted: there are no triangles to paint',
      hint: 'Choose one that can: 0 ("paint").',
    });
    await expect(renderPrint({ ...plain, model, material: 7 })).rejects.toMatchObject({
      ...{ code: "no-material", field: "material", value: "7" },
    });
    for (const [material, code] of [
      [1, "no-triangles"],
      [9, "no-material"],
    ] as const) {
      const zoned = { ...plain, model, zones: zones([zone({ material })]), zone: "left" };
      await expect(renderPrint(zoned)).rejects.toMatchObject({ code, subject: "zones", field: "zones[0].material" });
    }
    await expect(renderPrint({ ...plain, model: planeGlb({ withoutUvs: true }) })).rejects.toMatchObject({
      ...{ code: "no-uvs", field: "material", value: "0", hint: expect.stringMatching(/^Unwrap the model/) },
    });
  });

  it("measures at a size what it measures without: what cannot be painted is a finding and no fault", async () => {
    const fill = { ...design([{ type: "fill", color: "#ff0000" }]), assets: {} };
    const bare = { model: planeGlb({ withoutUvs: true }), design: fill };
    const found = [expect.objectContaining({ code: "not-printable" }), expect.anything()];
    expect((await checkPrint(bare)).violations).toEqual(found);
    expect((await checkPrint({ ...bare, size: 64 })).violations).toEqual(found);
    for (const size of [0, 64.5, 8193, Number.NaN, "64"]) {
      const refusal = { code: "bad-argument", field: "size", value: expect.stringContaining(String(size)) };
      await expect(checkPrint({ ...bare, size: size as number })).rejects.toMatchObject(refusal);
    }
  });

  it("refuse to be called without anything", async () => {
    for (const call of [renderPrint, checkPrint] as const) {
      const nothing = call as (options?: unknown) => Promise<unknown>;
      await expect(nothing()).rejects.toMatchObject({ code: "bad-argument", field: "options" });
      await expect(nothing({})).rejects.toMatchObject({ code: "bad-argument", field: "model" });
    }
    const broken = { ...usual, size: null } as never;
    await expect(checkPrint(broken)).rejects.toMatchObject({ code: "bad-argument", field: "size", value: "null" });
  });

  it("refuse, as the element does, files that are not what the design says, and drawings that would run something", async () => {
    const svg = (inner: string): Uint8Array =>
      Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">${inner}</svg>`);
    const given = (type: string, bytes: Uint8Array) => ({
      ...usual,
      design: { ...design([decal()]), assets: { logo: { type, uri: "logo.png" } } },
      assets: [{ name: "logo.png", bytes }],
    });
    const liar = { code: "bad-design", field: "assets.logo.type" };
    for (const call of [
      renderPrint,
      (options: Parameters<typeof renderPrint>[0]) => checkPrint({ ...options, size: 16 }),
    ]) {
      await expect(call(given("image/png", svg("")))).rejects.toMatchObject({ ...liar, value: "image/png" });
      await expect(call(given("image/svg+xml", LOGO))).rejects.toMatchObject({ ...liar, value: "image/svg+xml" });
      const unsafe = given("image/svg+xml", svg("<script>alert(1)</script>"));
      await expect(call(unsafe)).rejects.toMatchObject({ code: "unsafe-file", subject: "logo.png" });
      const data = `data:image/png;base64,${Buffer.from(svg("")).toString("base64")}`;
      const inside = { ...usual, design: { ...design([decal()]), assets: { logo: { type: "image/png", uri: data } } } };
      await expect(call(inside)).rejects.toMatchObject(liar);
      await expect(call(given("image/svg+xml", svg('<path d="M0 0h9v9z"/>')))).resolves.toBeDefined();
    }
  });

  it("take a customer's broken data: address for a fault of the design", async () => {
    const broken = { ...design([decal()]), assets: { logo: { type: "image/png", uri: "data:image/png;base64,@@@@" } } };
    await expect(renderPrint({ ...usual, design: broken })).rejects.toMatchObject({
      code: "bad-design",
      subject: "design",
      field: "assets.logo.uri",
    });
  });

  it("measures what the command line measures", async () => {
    const report = await checkPrint({ ...subject, assets, size: 256 });
    expect(report.layers[0]?.dpi?.mean).toBeCloseTo(254, 1);
    expect(report.warnings).toEqual([
      expect.objectContaining({ code: "low-dpi" }),
      expect.objectContaining({ code: "outside-zones", zone: "left" }),
    ]);
  });
});
