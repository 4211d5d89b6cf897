import { strFromU8, strToU8, type Zippable, zipSync } from "fflate";
import { afterEach, describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { writeGlb } from "../../web/engine/gltf-container.ts";
import { unzipModel } from "../../web/engine/zipped-model.ts";
import { buildModel, plane } from "../support/model-builder.ts";
import { endHosts, startHost } from "../support/painted-plane.ts";
import { solidPng } from "../support/png-file.ts";

afterEach(endHosts);

const SKIN = solidPng(4, 4, [200, 0, 0, 255]);

/** A model in three files, as libraries give it. */
function parts(): Zippable {
  const { json, binary } = buildModel({
    meshes: [plane(1, 0)],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }],
    more: { images: [{ uri: "textures/skin.png" }] },
  });
  json.buffers = [{ byteLength: binary.length, uri: "scene.bin" }];
  return { "scene.gltf": strToU8(JSON.stringify(json)), "scene.bin": binary, "textures/skin.png": SKIN };
}

function glb(): Uint8Array {
  const { json, binary } = buildModel({ meshes: [plane()] });
  return writeGlb(json, binary);
}

function refusal(bytes: Uint8Array, name = "pack.zip"): TexelcastError {
  try {
    unzipModel({ name, bytes });
  } catch (thrown) {
    if (thrown instanceof TexelcastError) return thrown;
    throw thrown;
  }
  throw new Error("the archive was read without complaint");
}

/** The directory's record of an archive's one entry. */
function directoryOf(bytes: Uint8Array): DataView {
  const at = new DataView(bytes.buffer).getUint32(bytes.length - 6, true);
  return new DataView(bytes.buffer, at);
}

describe("a zip given for a model", () => {
  it("is the model in it, with the files that it names and nothing else, painted on its own texture", async () => {
    const bytes = zipSync({ ...parts(), "source/scene.fbx": strToU8("x"), "__MACOSX/._scene.gltf": strToU8("x") });
    const engine = startHost();
    const info = await engine.loadModel({ name: "robot.zip", bytes });
    expect(info).toMatchObject({ name: "robot.zip#scene.gltf", triangles: 2 });
    expect(info.materials[0]?.textureSize).toEqual([4, 4]);
    expect([...(unzipModel({ name: "robot.zip", bytes }).resources?.keys() ?? [])]).toEqual([
      "scene.bin",
      "textures/skin.png",
    ]);
  });

  it.each(["skín ü.png", "日本/ガ.png"])("has the file %s by its letters, in parts as on Macs or whole", (path) => {
    for (const [named, packed] of [
      ["NFC", "NFD"],
      ["NFD", "NFC"],
    ] as const) {
      const model = { ...parts() };
      const json = JSON.parse(strFromU8(model["scene.gltf"] as Uint8Array)) as { images: { uri: string }[] };
      const address = encodeURI(path.normalize(named));
      json.images = [{ uri: address }];
      const { "textures/skin.png": _, ...rest } = model;
      const files = { ...rest, "scene.gltf": strToU8(JSON.stringify(json)), [path.normalize(packed)]: SKIN };
      expect(unzipModel({ name: "mac.zip", bytes: zipSync(files) }).resources?.get(address)).toEqual(SKIN);
    }
  });

  it("says by name what a .gltf in it needs and the archive lacks", async () => {
    const { "scene.bin": _, ...rest } = parts();
    await expect(startHost().loadModel({ name: "robot.zip", bytes: zipSync(rest) })).rejects.toMatchObject({
      code: "missing-file",
      subject: "robot.zip#scene.gltf",
      value: "scene.bin",
    });
  });

  it("of several models names them and says how one is chosen; by its path it is", () => {
    const bytes = zipSync({ "a/one.glb": glb(), "b/two.glb": glb() });
    expect(refusal(bytes)).toMatchObject({
      code: "bad-archive",
      subject: "pack.zip",
      message: "“pack.zip” holds 2 models: “a/one.glb”, “b/two.glb”.",
      hint: "Choose one by its path behind a “#”, as in “pack.zip#a/one.glb”.",
    });
    expect(unzipModel({ name: "pack.zip#b/two.glb", bytes }).name).toBe("pack.zip#b/two.glb");
    expect(refusal(bytes, "pack.zip#two.glb").message).toBe(
      "“pack.zip” holds no model “two.glb”, but “a/one.glb”, “b/two.glb”.",
    );
  });

  it("is refused without a model, and names no more than eight of a whole library", () => {
    expect(refusal(zipSync({ "robot.fbx": strToU8("x") })).message).toBe("“pack.zip” holds no model.");
    const library = Object.fromEntries(Array.from({ length: 12 }, (_, index) => [`${index}.glb`, glb()]));
    expect(refusal(zipSync(library)).message).toMatch(/^“pack.zip” holds 12 models: .*“7.glb” and 4 more\.$/);
  });
});

describe("a hostile zip given for a model", () => {
  const one = (change: (record: DataView) => void): Uint8Array => {
    const bytes = zipSync({ "scene.glb": glb() });
    change(directoryOf(bytes));
    return bytes;
  };

  it.each<[string, Uint8Array, RegExp]>([
    ["leads out of itself", zipSync({ "../scene.glb": glb() }), /"\.\.\/scene\.glb" is not a path inside the archive/],
    ["goes up and comes back", zipSync({ "a/../scene.glb": glb() }), /"a\/\.\.\/scene\.glb" is not a path inside/],
    ["has a folder above", zipSync({ "a.glb": glb(), "../": new Uint8Array() }), /"\.\.\/" is not a path inside/],
    ["has an absolute path", zipSync({ "/etc/scene.glb": glb() }), /is not a path inside the archive/],
    ["names a file twice", zipSync({ "a.glb": glb(), "A.GLB": glb() }), /stands twice in the archive/],
    ["is encrypted", one((record) => record.setUint16(8, 1, true)), /"scene\.glb" is encrypted/],
    [
      "has 64-bit sizes",
      one((record) => record.setUint32(24, 0xffffffff, true)),
      /has a 64-bit size, which is not read/,
    ],
    ["is packed by another method", one((record) => record.setUint16(10, 14, true)), /is compressed by method 14/],
    [
      "says it inflates beyond all measure",
      one((record) => record.setUint32(24, 2 ** 30, true)),
      /says it inflates from \d+ to 1073741824 bytes, which is not possible/,
    ],
    [
      "inflates to more than it says",
      one((record) => record.setUint32(24, 100, true)),
      /inflates to more than the 100 bytes/,
    ],
    [
      "has a link for a model",
      one((record) => {
        record.setUint8(5, 3);
        record.setUint16(40, 0o120777, true);
      }),
      /"scene\.glb" is a link to another file, and links are not followed/,
    ],
    ["is cut off", zipSync({ "scene.glb": glb() }).subarray(0, 60), /is no zip archive, or it is cut off/],
  ])("is refused in words that name archive and entry where it %s", (_what, bytes, words) => {
    const error = refusal(bytes);
    expect(error).toMatchObject({ code: "bad-archive", subject: "pack.zip", hint: expect.any(String) });
    expect(error.message).toMatch(words);
  });

  it("holds what it inflates for one model to a gibibyte", () => {
    const bytes = zipSync({ "scene.glb": new Uint8Array(1_100_000) }, { level: 0 });
    const record = directoryOf(bytes);
    record.setUint16(10, 8, true);
    record.setUint32(24, 1_100_000_000, true);
    expect(refusal(bytes).message).toMatch(/inflates to 1100000000 bytes, the limit there is 1073741824/);
  });
});
