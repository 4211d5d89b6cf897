import { describe, expect, it } from "vitest";
import { sortFiles } from "../../web/editor/files/file-intake.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { writeGlb } from "../../web/engine/gltf-container.ts";
import { buildModel } from "../support/model-builder.ts";

const { json, binary } = buildModel({ meshes: [], materials: [] });
const WHOLE = writeGlb(json, binary);
const NAMING = writeGlb({ ...json, images: [{ uri: "textures/skin%20a.png" }] }, binary);

/** The paths of what would be added to the design, of files that came together with that model. */
async function added(model: Uint8Array, ...paths: readonly string[]): Promise<string[]> {
  const files = ["model.glb", ...paths].map((path) => {
    const name = path.slice(path.lastIndexOf("/") + 1);
    return { path, file: new File([path.endsWith(".glb") ? new Uint8Array(model) : "bytes"], name) };
  });
  const { pictures, fonts } = await sortFiles(files, stringsIn("en"));
  return [...pictures, ...fonts].map(({ path }) => path);
}

describe("what comes together with a model", () => {
  it("is for decals and texts where the model does not name it", async () => {
    expect(await added(WHOLE, "logo.png", "Hand.ttf")).toEqual(["logo.png", "Hand.ttf"]);
  });

  it("is the model's own where it names it", async () => {
    expect(await added(NAMING, "logo.png", "skin a.png")).toEqual(["logo.png"]);
  });

  it.each([
    ["with backslashes", "maps\\skin a.png"],
    ["by a path of another computer", "D:\\work\\maps\\skin a.png"],
    ["in capitals", "maps/SKIN A.PNG"],
  ])("is the model's own where it names it %s", async (_, uri) => {
    expect(await added(writeGlb({ ...json, images: [{ uri }] }, binary), "logo.png", "skin a.png")).toEqual([
      "logo.png",
    ]);
  });

  it("is taken by its name's very letters before others that differ in their case", async () => {
    const model = writeGlb({ ...json, images: [{ uri: "maps/Skin.png" }] }, binary);
    expect(await added(model, "skin.png", "Skin.png")).toEqual(["skin.png"]);
  });

  it("is left alone in a folder, where pictures of the model lie beside it", async () => {
    expect(await added(WHOLE, "model/preview.png")).toEqual([]);
  });

  it("is the design's where one came, too", async () => {
    expect(await added(WHOLE, "work.design.json", "logo.png")).toEqual([]);
  });
});

describe("what is of no use", () => {
  const useless = async (...paths: readonly string[]): Promise<readonly string[]> => {
    const files = paths.map((path) => ({ path, file: new File(["bytes"], path) }));
    return (await sortFiles(files, stringsIn("en"))).useless;
  };

  it("is named where it came beside a picture", async () => {
    expect(await useless("logo.png", "notes.txt", "Hand.ttf")).toEqual(["notes.txt"]);
  });

  it("is nobody's business in a folder of pictures, or beside a design", async () => {
    expect(await useless("art/logo.png", "art/notes.txt")).toEqual([]);
    expect(await useless("work.design.json", "notes.txt")).toEqual([]);
  });
});

describe("a model whose files did not come with it", () => {
  const naming = (...uris: readonly string[]) => {
    const model = writeGlb({ ...json, images: uris.map((uri) => ({ uri })) }, binary);
    return [{ path: "model.glb", file: new File([new Uint8Array(model)], "model.glb") }];
  };

  it("is refused with all of them at once, as people write their names", async () => {
    const uris = ["textures/skin%20a.png", "textures/metal.png"];
    const refused = sortFiles(naming(...uris), stringsIn("en"));
    await expect(refused).rejects.toMatchObject({
      code: "missing-file",
      message: "model.glb needs files that did not come with it: textures/skin a.png, textures/metal.png.",
    });
    await expect(sortFiles(naming(...uris), stringsIn("de"))).rejects.toThrow(
      "nicht dabei sind: textures/skin a.png, ",
    );
  });

  it("is refused with some of them where they are many, and how many more there are", async () => {
    const uris = Array.from({ length: 9 }, (_, i) => `${i}.png`);
    await expect(sortFiles(naming(...uris), stringsIn("en"))).rejects.toThrow("5.png, and 3 more.");
  });

  it("is the engine's to refuse where one is missing", async () => {
    expect((await sortFiles(naming("one.png"), stringsIn("en"))).model?.name).toBe("model.glb");
  });
});

describe("a picture", () => {
  it("is one that cannot be read where it came alone, so that what it is instead is told", async () => {
    const others = ["logo.pdf", "logo.ai", "logo.eps", "layers.psd", "cat.gif", "scan.tif", "photo.HEIC"];
    const files = others.map((name) => ({ path: name, file: new File(["bytes"], name) }));
    const { pictures } = await sortFiles(files, stringsIn("en"));
    expect(pictures.map(({ path }) => path)).toEqual(others);
    expect(await added(WHOLE, ...others)).toEqual([]);
  });

  it("is one by any of the endings that programs give it", async () => {
    for (const name of ["a.png", "a.jpg", "a.JPEG", "a.jfif", "a.webp", "a.avif", "a.svg", "a.svgz"]) {
      expect(await added(WHOLE, name)).toEqual([name]);
    }
  });
});

describe("a palette", () => {
  const file = (name: string) => ({ path: name, file: new File(["bytes"], name) });

  it("is taken by itself, and beside what else came", async () => {
    for (const names of [["warm.gpl"], ["logo.png", "Warm.GPL"]]) {
      const { palette } = await sortFiles(names.map(file), stringsIn("en"));
      expect(palette?.path).toMatch(/warm\.gpl/i);
    }
  });
});
