import { strToU8, unzipSync, type Zippable, zipSync } from "fflate";
import { describe, expect, it } from "vitest";
import type { TexelcastError } from "../../web/core/texelcast-error.ts";
import { type Design, parseDesign } from "../../web/editor/document/index.ts";
import { type ProjectToWrite, readProjectFile, writeProjectFile } from "../../web/editor/document/project-file.ts";

const PICTURES: Readonly<Record<string, Uint8Array>> = {
  "Logo.png": Uint8Array.of(1, 2, 3),
  "other/logo": Uint8Array.of(4, 5),
  "Übung?": Uint8Array.of(6),
};

function design(): Design {
  const projector = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] };
  const assets = Object.fromEntries(
    Object.keys(PICTURES).map((key) => [key, { type: "image/png", uri: "data:image/png;base64,AA==" }]),
  );
  return parseDesign({
    format: "texelcast-design",
    version: 1,
    assets,
    layers: [{ type: "decal", asset: "Logo.png", projector }],
  });
}

const project = (changes: Partial<ProjectToWrite> = {}): ProjectToWrite => ({
  name: "My cup",
  design: design(),
  assetBytes: (key) => PICTURES[key],
  targets: [{ material: 0, size: 512, gutter: null }],
  model: {
    title: "Cup.gltf",
    demo: null,
    source: {
      name: "things/Cup.gltf",
      bytes: strToU8("{}"),
      resources: new Map([["../up/cup%20data.bin", Uint8Array.of(7)]]),
    },
  },
  ...changes,
});

describe("a project in one file", () => {
  it("comes back whole: name, design, pictures, sizes, and the model with its side files", () => {
    const back = readProjectFile(writeProjectFile(project()), "cup.texelcast");
    expect(back.name).toBe("My cup");
    expect(back.targets).toEqual(project().targets);
    expect(back.design.layers).toEqual(design().layers);
    for (const [key, bytes] of Object.entries(PICTURES)) {
      const uri = back.design.assets[key]?.uri ?? "";
      expect(uri).toMatch(/^assets\/[^/]+\.png$/);
      expect(back.assetBytes(uri)).toEqual(bytes);
    }
    expect(back.model).toEqual({ ...project().model, source: { ...project().model.source } });
  });

  it("can leave the model out", () => {
    const model = { title: "Mug", demo: "mug", source: null };
    const bytes = writeProjectFile(project({ model }));
    expect(readProjectFile(bytes, "mug.texelcast").model).toEqual(model);
    expect(Object.keys(unzipSync(bytes)).some((name) => name.startsWith("model/"))).toBe(false);
  });

  it("can be read again whatever the length and the script of its names", () => {
    const long = "𠮷".repeat(2001);
    const odd = "x".repeat(59) + long;
    const assets = { [`${"x".repeat(59)}${"𠮷".repeat(100)}`]: { type: "image/png" as const, uri: "data:," } };
    const side = `../${"%E6%9C%A8/".repeat(200)}a.bin`;
    const source = {
      name: `${odd}.${"e".repeat(2000)}`,
      bytes: strToU8("{}"),
      resources: new Map([[side, Uint8Array.of(7)]]),
    };
    const bytes = writeProjectFile(
      project({
        name: `a${long}`,
        design: { ...design(), assets, layers: [] },
        assetBytes: () => Uint8Array.of(9),
        model: { title: long, demo: null, source },
      }),
    );
    const back = readProjectFile(bytes, "long.texelcast");
    expect(back.name).toBe(`a${"𠮷".repeat(999)}`);
    expect(back.model.title).toBe("𠮷".repeat(1000));
    expect(back.model.source?.resources).toEqual(source.resources);
    for (const { uri } of Object.values(back.design.assets)) expect(back.assetBytes(uri)).toEqual(Uint8Array.of(9));
    for (const name of Object.keys(unzipSync(bytes))) {
      expect(name).not.toContain("\ufffd");
      expect(Math.max(...name.split("/").map((part) => Buffer.byteLength(part)))).toBeLessThanOrEqual(255);
    }
  });

  it("is the same bytes each time", () => {
    expect(writeProjectFile(project())).toEqual(writeProjectFile(project()));
  });

  it("is a zip that other programs read, with names that any file system takes", () => {
    const names = Object.keys(unzipSync(writeProjectFile(project())));
    expect(names).toEqual([
      "project.json",
      "design.json",
      "assets/logo.png",
      "assets/logo-2.png",
      "assets/übung-.png",
      "model/cup.gltf",
      "model/cup-20data.bin",
    ]);
  });
});

const GOOD = unzipSync(writeProjectFile(project()));

function refusal(bytes: Uint8Array): TexelcastError {
  try {
    const file = readProjectFile(bytes, "bad.texelcast");
    for (const { uri } of Object.values(file.design.assets)) file.assetBytes(uri);
  } catch (thrown) {
    return thrown as TexelcastError;
  }
  throw new Error("The file was read.");
}

const withFiles = (files: Zippable): Uint8Array => zipSync({ ...GOOD, ...files });

/** A change of the archive's bytes at each place where `signature` begins; `change` is given a view from there. */
function patched(bytes: Uint8Array, signature: number, change: (view: DataView) => void): Uint8Array {
  const copy = bytes.slice();
  const view = new DataView(copy.buffer);
  for (let at = 0; at + 4 <= copy.length; at++) {
    if (view.getUint32(at, true) === signature) change(new DataView(copy.buffer, at));
  }
  return copy;
}
const DIRECTORY = 0x02014b50;

describe("a hostile project file", () => {
  it("is refused when it is no zip, or cut off, by its name", () => {
    const bytes = writeProjectFile(project());
    for (const broken of [strToU8("hello"), new Uint8Array(0), bytes.subarray(0, bytes.length - 30)]) {
      expect(refusal(broken)).toMatchObject({ code: "bad-project", subject: "bad.texelcast" });
    }
  });

  it.each(["../evil.png", "/etc/passwd", "a/../../b", "C:/x", "a\\b", "a//b", "./a"])(
    "is refused for the name %s, which leads out of it",
    (name) => {
      expect(refusal(withFiles({ [name]: strToU8("x") }))).toMatchObject({
        code: "bad-project",
        subject: "bad.texelcast",
        field: name,
      });
    },
  );

  it("is refused when a name stands twice, also in another case", () => {
    expect(refusal(withFiles({ "DESIGN.json": strToU8("{}") }))).toMatchObject({ field: "DESIGN.json" });
    const twice = strToU8("assets/logo.png");
    const again = patched(withFiles({ "assets/logx.png": strToU8("x") }), DIRECTORY, (view) => {
      const name = new Uint8Array(view.buffer, view.byteOffset + 46, twice.length);
      if (new TextDecoder().decode(name) === "assets/logx.png") name.set(twice);
    });
    expect(refusal(again)).toMatchObject({ code: "bad-project", field: "assets/logo.png" });
  });

  it("is refused before it is inflated when an entry says that it is too large", () => {
    const zeros = zipSync({ ...GOOD, "project.json": new Uint8Array(2 << 20) });
    expect(refusal(zeros)).toMatchObject({ code: "bad-project", field: "project.json", value: "2097152 bytes" });
  });

  it("is refused when its entries together would fill the memory", () => {
    const bomb = patched(zipSync(GOOD, { level: 0 }), DIRECTORY, (view) => {
      view.setUint16(10, 8, true);
      view.setUint32(24, view.getUint32(20, true) * 1032, true);
    });
    const huge = patched(bomb, DIRECTORY, (view) => view.setUint32(20, 4_000_000, true));
    expect(refusal(huge).code).toBe("bad-project");
  });

  it("is refused when an entry inflates to more than it says, or to less", () => {
    for (const difference of [-1, 1]) {
      const lying = patched(writeProjectFile(project()), DIRECTORY, (view) => {
        if (view.getUint16(10, true) === 8) view.setUint32(24, view.getUint32(24, true) + difference, true);
      });
      expect(refusal(lying)).toMatchObject({ code: "bad-project", field: "project.json" });
    }
  });

  it("stops inflating a bomb that lies about its size", () => {
    const bomb = patched(zipSync({ ...GOOD, "project.json": new Uint8Array(20 << 20) }), DIRECTORY, (view) => {
      if (view.getUint32(24, true) === 20 << 20) view.setUint32(24, 1000, true);
    });
    expect(refusal(bomb).message).toContain("inflates to more than the 1000 bytes");
  });

  it("is refused for an entry that was changed on its way", () => {
    const damaged = patched(writeProjectFile(project()), DIRECTORY, (view) => {
      if (view.getUint16(10, true) === 0) view.setUint32(16, 1, true);
    });
    expect(refusal(damaged).message).toContain("checksum");
  });

  it("is refused for encryption, other compressions and 64-bit sizes", () => {
    const bytes = writeProjectFile(project());
    expect(refusal(patched(bytes, DIRECTORY, (view) => view.setUint16(8, 1, true))).message).toContain("encrypted");
    expect(refusal(patched(bytes, DIRECTORY, (view) => view.setUint16(10, 93, true))).message).toContain("method 93");
    expect(refusal(patched(bytes, DIRECTORY, (view) => view.setUint32(24, 0xffffffff, true))).message).toContain("64");
  });

  it("is refused without a design, or with a broken one, and says which", () => {
    const { "design.json": _design, ...without } = GOOD;
    expect(refusal(zipSync(without)).message).toContain("design.json");
    expect(refusal(withFiles({ "design.json": strToU8("{") }))).toMatchObject({
      code: "bad-design",
      subject: "bad.texelcast: design.json",
    });
    expect(refusal(withFiles({ "design.json": Uint8Array.of(0xff, 0xfe) }))).toMatchObject({ field: "design.json" });
  });

  it("is refused for another format, and for a version that is newer", () => {
    const manifest = JSON.parse(new TextDecoder().decode(GOOD["project.json"]));
    const changed = (fields: object): Uint8Array =>
      withFiles({ "project.json": strToU8(JSON.stringify({ ...manifest, ...fields })) });
    expect(refusal(changed({ format: "psd" }))).toMatchObject({ field: "project.json", value: '"psd"' });
    const newer = refusal(changed({ version: 2 }));
    expect(newer.message).toContain("newer Texelcast");
    // The page that made it would make the same again.
    expect(newer).toMatchObject({ field: "project.json", value: "2", hint: "Update to open it." });
    expect(refusal(changed({ version: "1" })).message).toContain("unknown version");
    expect(refusal(changed({ targets: [{ material: -1 }] })).message).toContain("targets[0]");
    expect(refusal(withFiles({ "project.json": strToU8("nope") })).message).toContain("not valid JSON");
  });

  it("is refused with a key that stands twice in one object of its manifest, by the path", () => {
    const manifest = new TextDecoder().decode(GOOD["project.json"]);
    const twice = manifest.replace('"title":', '"title": "Another cup",\n    "title":');
    expect(twice).not.toBe(manifest);
    expect(refusal(withFiles({ "project.json": strToU8(twice) }))).toMatchObject({
      code: "bad-project",
      field: "project.json",
      message: expect.stringContaining("model.title twice in one object"),
    });
  });

  it("is refused when it names a picture or a model that it does not hold", () => {
    const { "assets/logo.png": _logo, ...withoutPicture } = GOOD;
    expect(refusal(zipSync(withoutPicture))).toMatchObject({ code: "bad-project", value: "assets/logo.png" });
    const { "model/cup.gltf": _model, ...withoutModel } = GOOD;
    expect(refusal(zipSync(withoutModel))).toMatchObject({ field: "project.json: model.file" });
  });
});
