import { strToU8, type Zippable, zipSync } from "fflate";
import { describe, expect, it } from "vitest";
import { emptyDesign, writeProjectFile } from "../../web/editor/document/index.ts";
import { unzipFiles } from "../../web/editor/files/archive-files.ts";
import { sortFiles } from "../../web/editor/files/file-intake.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { writeGlb } from "../../web/engine/gltf-container.ts";
import { loadModelFile } from "../../web/engine/model-loader.ts";
import { buildModel, plane } from "../support/model-builder.ts";
import { solidPng } from "../support/png-file.ts";

const PICTURE = solidPng(2, 2, [255, 0, 0, 255]);
const TEXT = strToU8("words");

/** A model in three parts, as libraries of models give it. */
function parts(): Record<"scene.gltf" | "scene.bin" | "textures/skin.png", Uint8Array> {
  const { json, binary } = buildModel({
    meshes: [plane(1, 0)],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }],
    more: { images: [{ uri: "textures/skin.png" }], buffers: [{ byteLength: 0, uri: "scene.bin" }] },
  });
  json.buffers = [{ byteLength: binary.length, uri: "scene.bin" }];
  return { "scene.gltf": strToU8(JSON.stringify(json)), "scene.bin": binary, "textures/skin.png": PICTURE };
}

const zip = (files: Zippable): Uint8Array<ArrayBuffer> => zipSync(files) as Uint8Array<ArrayBuffer>;
const pathsIn = (files: Zippable, path = "robot.zip"): string[] =>
  unzipFiles(zip(files), path).map((file) => file.path);

/** What the page makes of an archive. */
function intake(files: Zippable, name = "robot.zip") {
  const collected = unzipFiles(zip(files), name).map(({ path, bytes }) => ({
    path,
    file: new File([bytes], path.slice(path.lastIndexOf("/") + 1)),
  }));
  return sortFiles(collected, stringsIn("en"));
}

/** The bytes with each pattern of `from` in them replaced. */
function replaced(bytes: Uint8Array<ArrayBuffer>, from: Uint8Array, to: Uint8Array): Uint8Array<ArrayBuffer> {
  const copy = bytes.slice();
  for (let at = 0; at + from.length <= copy.length; at++) {
    if (from.every((byte, i) => copy[at + i] === byte)) copy.set(to, at);
  }
  return copy;
}

describe("a zip with a model in it", () => {
  it("is the model, with the files that it names, and none of them a decal", async () => {
    const { model, title, pictures } = await intake({ ...parts(), "license.txt": TEXT });
    expect(title).toBe("robot");
    expect(pictures).toEqual([]);
    if (model === undefined) throw new Error("no model");
    expect(await loadModelFile(model)).toMatchObject({ name: "scene.gltf" });
  });

  it("is called as the model's file where that has a name of its own", async () => {
    const { json, binary } = buildModel({ meshes: [plane()] });
    expect((await intake({ "fox.glb": writeGlb(json, binary) }, "pack.zip")).title).toBe("fox.glb");
  });

  it("is called as the folder in it that the model lies in", async () => {
    const inFolder = Object.fromEntries(Object.entries(parts()).map(([name, bytes]) => [`Fox 2/${name}`, bytes]));
    expect((await intake(inFolder)).title).toBe("Fox 2");
  });

  it("is opened without what other systems and programs have put beside it", () => {
    const beside = ["__MACOSX/._scene.gltf", ".DS_Store", "source/robot.fbx", "source/robot.zip", "about.json"];
    const files = { ...parts(), ...Object.fromEntries(beside.map((name) => [name, TEXT])), "big.design.json": TEXT };
    expect(pathsIn(files)).toEqual([
      "robot/scene.gltf",
      "robot/scene.bin",
      "robot/textures/skin.png",
      "robot/big.design.json",
    ]);
  });

  it("has files whose names are in the PC's old letters", () => {
    const utf8 = strToU8("größen.glb");
    const old = Uint8Array.from([..."gr"].map((letter) => letter.charCodeAt(0)).concat(0x94, 0xe1));
    const bytes = zip({ "grxxen.glb": TEXT });
    expect(utf8.length).toBe(12);
    const renamed = replaced(bytes, strToU8("grxx"), old);
    expect(unzipFiles(renamed, "a.zip").map(({ path }) => path)).toEqual(["a/größen.glb"]);
  });
});

describe("a zip of pictures", () => {
  it("is the pictures, to be put on the model", async () => {
    const { pictures } = await intake({ "stickers/a.png": PICTURE, "stickers/b.svg": TEXT, "read me.md": TEXT });
    expect(pictures.map(({ path }) => path)).toEqual(["robot/stickers/a.png", "robot/stickers/b.svg"]);
  });
});

describe("a project that is called .zip", () => {
  it("is a project", async () => {
    const model = { title: "mug.glb", demo: "mug", source: null };
    const bytes = writeProjectFile({
      ...{ name: "Mug", design: emptyDesign(), assetBytes: () => undefined, targets: [], model },
    }) as Uint8Array<ArrayBuffer>;
    const unzipped = unzipFiles(bytes, "inbox/mug.zip");
    expect(unzipped).toEqual([{ path: "inbox/mug.texelcast", bytes }]);
  });
});

describe("a zip that cannot be opened", () => {
  it("is refused by its name when it is none", () => {
    expect(() => unzipFiles(strToU8("hello") as Uint8Array<ArrayBuffer>, "x/y.zip")).toThrowError(
      expect.objectContaining({ code: "bad-archive", subject: "y.zip" }),
    );
  });

  it("is refused by the entry that leads out of it", () => {
    expect(() => unzipFiles(zip({ "../evil.glb": TEXT }), "y.zip")).toThrowError(
      expect.objectContaining({ code: "bad-archive", field: "../evil.glb", hint: expect.stringContaining("Unpack") }),
    );
  });

  it("is refused before anything is inflated when it would fill the memory", () => {
    const bytes = zipSync({ "a.glb": new Uint8Array(1_100_000) }, { level: 0 }) as Uint8Array<ArrayBuffer>;
    const view = new DataView(bytes.buffer);
    const entry = bytes.length - 22 - (46 + "a.glb".length);
    view.setUint16(entry + 10, 8, true);
    view.setUint32(entry + 24, 1_100_000_000, true);
    expect(() => unzipFiles(bytes, "y.zip")).toThrowError(
      expect.objectContaining({ code: "bad-archive", value: "1050 MiB" }),
    );
    const many = Object.fromEntries(Array.from({ length: 2001 }, (_, i) => [`${i}.png`, TEXT]));
    expect(() => unzipFiles(zip(many), "y.zip")).toThrowError(
      expect.objectContaining({ code: "bad-archive", value: "2001 files" }),
    );
  });

  it("has nothing to give when nothing in it is of use here", () => {
    expect(pathsIn({ "robot.fbx": TEXT, "notes/read.txt": TEXT })).toEqual([]);
  });
});
