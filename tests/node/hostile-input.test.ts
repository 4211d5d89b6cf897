import { mkdirSync, readdirSync, readFileSync, symlinkSync, truncateSync, writeFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { renderPrint } from "../../node/print.ts";
import { FACING_DOWN, plainPng, planeDocument, planeGlb } from "./plane-model.ts";
import { type Run, temporaryFolder, texelcast } from "./run-cli.ts";

const projector = { kind: "planar", position: [0, 0.5, 0], rotation: FACING_DOWN, size: [2, 1, 0.2] };

function design(fields: object, uri = "logo.png"): string {
  const assets = { logo: { type: "image/png", uri } };
  const layers = [{ type: "decal", asset: "logo", projector, ...fields }];
  return JSON.stringify({ format: "texelcast-design", version: 1, assets, layers });
}

/** A folder `work` with the files, beside a file that is none of anybody's business. */
function folderWith(files: Readonly<Record<string, string | Uint8Array>>): string {
  const root = temporaryFolder();
  const work = path.join(root, "work");
  mkdirSync(work);
  writeFileSync(path.join(root, "secret.png"), "secret");
  for (const [name, content] of Object.entries(files)) writeFileSync(path.join(work, name), content);
  return work;
}

/** Refused as an input, in words and not by a stack, with nothing written. */
function expectRefusal(run: Run, folder: string, before: number, ...told: string[]): void {
  expect(run.code).toBe(3);
  expect(run.stdout).toBe("");
  expect(run.stderr).toMatch(/^texelcast: /);
  expect(run.stderr).not.toMatch(/\n\s+at /);
  for (const words of told) expect(run.stderr).toContain(words);
  expect(readdirSync(folder)).toHaveLength(before);
}

describe("a design that cannot be used", () => {
  it.each<[string, string | Uint8Array, string[]]>([
    ["a broken JSON", '{"format": ', ["design.json: the design is not valid JSON"]],
    ["a picture", new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0xff, 0xfe]), ["design.json: the design is not UTF-8 text"]],
    ["a version of a later day", '{"format":"texelcast-design","version":2}', ["version: must be 1, is 2", "update"]],
    ["an unknown field", design({ glow: 1 }), ["layers[0].glow: is not a known field"]],
    [
      "a size below zero",
      design({ projector: { ...projector, size: [1, -3, 1] } }),
      ["layers[0].projector.size[1]: must be above 0, is -3"],
    ],
    [
      "a prototype as an asset",
      '{"format":"texelcast-design","version":1,"assets":{"__proto__":{"type":"image/png","uri":"a"}}}',
      ["__proto__"],
    ],
    [
      "a nest without a bottom",
      `${'{"a":'.repeat(100_000)}1${"}".repeat(100_000)}`,
      ['format: is missing: must be "texelcast-design"'],
    ],
    [
      "a picture from the web",
      design({}, "https://example.org/logo.png"),
      ["assets.logo.uri", "is a https: address", "download it"],
    ],
    ["a picture from the folder above", design({}, "../secret.png"), ["assets.logo.uri", "lies outside the folder"]],
    ["a picture by its absolute path", design({}, "/etc/passwd"), ["is an absolute path"]],
    ["a picture by a file address", design({}, "file:///etc/passwd"), ["is a file: address"]],
    ["a picture that is missing", design({}, "lost.png"), ["assets.logo.uri", "lost.png", "there is no such file"]],
    ["a picture that is a text", design({}, "design.json"), ["design.json"]],
    ["a picture that ends early", design({}, "cut.png"), ["cut.png"]],
    [
      "a data address that is broken",
      design({}, "data:image/png;base64,%%%"),
      ["assets.logo.uri: is not a valid data: address"],
    ],
    ["a data address of no picture", design({}, "data:image/png;base64,AAAA"), ["assets.logo.uri"]],
  ])("is refused: %s", async (_what, text, told) => {
    const cut = (await plainPng(64, 64, [1, 2, 3, 255])).slice(0, 60);
    const folder = folderWith({ "plane.glb": planeGlb(), "design.json": text, "cut.png": cut });
    const run = await texelcast(["render", "plane.glb", "design.json", "--out", "out.png", "--size", "16"], {
      cwd: folder,
    });
    expectRefusal(run, folder, 3, ...told);
  });

  it.each(["render", "print", "check"])(
    "is refused by %s by the field of a text that has too many letters",
    async (command) => {
      const text = (letters: string, fields: object = {}) => ({
        type: "text",
        text: letters,
        font: "inter",
        projector,
        ...fields,
      });
      const many = "W".repeat(9000);
      const content = {
        format: "texelcast-design",
        version: 1,
        assets: { inter: { type: "font/ttf", uri: "texelcast:fonts/inter-400" } },
        layers: [text(many, { visible: false }), { type: "group", layers: [text("W"), text(many)] }],
      };
      const folder = folderWith({ "plane.glb": planeGlb(), "design.json": JSON.stringify(content) });
      const out = command === "check" ? [] : ["--out", "out.png", "--size", "16"];
      const run = await texelcast([command, "plane.glb", "design.json", ...out], { cwd: folder });
      expectRefusal(run, folder, 2, "design.json: layers[1].layers[1].text: “WWWW", "too many points", "fewer words");
    },
  );

  it("is refused when its picture is a link to a file outside", async () => {
    const folder = folderWith({ "plane.glb": planeGlb(), "design.json": design({}) });
    symlinkSync("../secret.png", path.join(folder, "logo.png"));
    const run = await texelcast(["render", "plane.glb", "design.json", "--out", "out.png"], { cwd: folder });
    expectRefusal(run, folder, 3, "assets.logo.uri", "is a link that leads outside the folder");
  });
});

/** A mesh of zeros, which need no bytes, in 200 places: 37 GiB from a few kB. */
function inTooManyPlaces(gltf: Record<string, unknown>): void {
  const { accessors, meshes } = gltf as { accessors: object[]; meshes: object[] };
  const POSITION = accessors.push({
    componentType: 5126,
    type: "VEC3",
    count: 5_000_000,
    min: [0, 0, 0],
    max: [0, 0, 0],
  });
  meshes[0] = { primitives: [{ attributes: { POSITION: POSITION - 1 }, material: 0 }] };
  gltf.nodes = Array.from({ length: 200 }, () => ({ mesh: 0 }));
  gltf.scenes = [{ nodes: Array.from({ length: 200 }, (_, i) => i) }];
  delete gltf.animations;
}

describe("a model that cannot be used", () => {
  const glb = planeGlb();
  it.each<[string, string | Uint8Array, string[]]>([
    ["an empty file", "", ["model.glb"]],
    ["a text named .glb", "solid as a rock", ["model.glb"]],
    ["a file cut inside its header", glb.slice(0, 10), ["model.glb"]],
    ["a file cut inside its text", glb.slice(0, 200), ["model.glb"]],
    ["a file cut inside its numbers", glb.slice(0, glb.length - 40), ["model.glb"]],
    [
      "indices out of range",
      planeGlb({ edit: (gltf) => Object.assign((gltf.accessors as object[])[3] as object, { bufferView: 0 }) }),
      ["model.glb"],
    ],
    [
      "a position that is no number",
      planeGlb({ edit: (gltf) => Object.assign((gltf.nodes as object[])[0] as object, { scale: [1e30, 1e30, 1e30] }) }),
      ["model.glb"],
    ],
    [
      "a mesh in more places than memory holds",
      planeGlb({ edit: inTooManyPlaces }),
      ["model.glb", "reading the model needs 37830 MiB", "Simplify the model."],
    ],
  ])("is refused by inspect and bake: %s", async (_what, content, told) => {
    const folder = folderWith({ "model.glb": content });
    expectRefusal(await texelcast(["inspect", "model.glb"], { cwd: folder }), folder, 1, ...told);
    expectRefusal(await texelcast(["bake", "model.glb", "--out", "maps"], { cwd: folder }), folder, 1, ...told);
  });
});

describe("a text that is longer than JavaScript holds", () => {
  /** Half a gibibyte, and on the disk a letter. */
  function folderWithLongText(name: string, files: Readonly<Record<string, string>> = {}): string {
    const folder = folderWith({ ...files, [name]: "{" });
    truncateSync(path.join(folder, name), 2 ** 29);
    return folder;
  }
  const design = JSON.stringify({ format: "texelcast-design", version: 1, layers: [] });

  it("is refused as a model by its name, and what to do is told", async () => {
    const folder = folderWithLongText("model.gltf");
    const run = await texelcast(["inspect", "model.gltf"], { cwd: folder });
    expectRefusal(run, folder, 1, "“model.gltf” is not a sound glTF file: its JSON is longer than", "Save it as .glb");
  });

  it("is refused as a model whose bytes are given", async () => {
    const folder = folderWithLongText("model.gltf");
    const model = { name: "model.gltf", bytes: readFileSync(path.join(folder, "model.gltf")) };
    const message = expect.stringContaining("its JSON is longer than");
    await expect(renderPrint({ model, design })).rejects.toMatchObject({ code: "bad-container", message });
  });

  it("is refused as a zones file, and not for its letters", async () => {
    const folder = folderWithLongText("zones.json", { "design.json": design });
    const run = await texelcast(["check", "model.glb", "design.json", "--zones", "zones.json"], { cwd: folder });
    expectRefusal(run, folder, 2, "zones.json: has 536870912 bytes, the limit is 268435456");
  });
});

describe("a .gltf with side files", () => {
  function gltfWith(uri: string, files: Readonly<Record<string, Uint8Array>> = {}): string {
    const { gltf, bin } = planeDocument();
    gltf.buffers = [{ byteLength: bin.length, uri }];
    return folderWith({ "plane.gltf": JSON.stringify(gltf), "my plane.bin": bin, ...files });
  }

  it("reads those that lie beside it, percent-encoded or not", async () => {
    for (const uri of ["my%20plane.bin", "my plane.bin", "./my plane.bin"]) {
      const run = await texelcast(["inspect", "plane.gltf"], { cwd: gltfWith(uri) });
      expect(run).toMatchObject({ code: 0, stderr: "" });
    }
  });

  it("renders to a GLB that holds them", async () => {
    const folder = gltfWith("my%20plane.bin");
    writeFileSync(
      path.join(folder, "design.json"),
      '{"format":"texelcast-design","version":1,"layers":[{"type":"fill","color":"#00ff00"}]}',
    );
    const run = await texelcast(["render", "plane.gltf", "design.json", "--out", "out.glb", "--size", "8"], {
      cwd: folder,
    });
    expect(run).toMatchObject({ code: 0, stderr: "" });
    expect((await texelcast(["inspect", "out.glb"], { cwd: folder })).stdout).toContain("8 x 8");
  });

  it.each([
    ["above its folder", "../secret.png", "lies outside the folder"],
    ["above its folder in disguise", "%2e%2e/secret.png", "lies outside the folder"],
    ["by an absolute path", "/etc/passwd", "is an absolute path"],
    ["by a file address", "file:///etc/passwd", "is a file: address"],
    ["on the web", "http://example.org/plane.bin", "is a http: address"],
    ["that is missing", "lost.bin", "there is no such file"],
  ])("is refused when it names one %s", async (_what, uri, told) => {
    const folder = gltfWith(uri);
    expectRefusal(await texelcast(["inspect", "plane.gltf"], { cwd: folder }), folder, 2, "plane.gltf", told);
  });

  it("is refused when a link beside it leads out", async () => {
    const folder = gltfWith("link.bin");
    symlinkSync("../secret.png", path.join(folder, "link.bin"));
    const run = await texelcast(["inspect", "plane.gltf"], { cwd: folder });
    expectRefusal(run, folder, 3, "is a link that leads outside the folder");
  });
});
