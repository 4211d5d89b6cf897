import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { listSideFiles, readContainer, writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { packGltf } from "../../web/engine/gltf-packer.ts";
import { buildGlb, buildModel, plane } from "../support/model-builder.ts";
import { solidPng } from "../support/png-file.ts";

const encode = (text: string): Uint8Array => new TextEncoder().encode(text);
const gltfText = (json: JsonObject): Uint8Array => encode(JSON.stringify(json));
const name = "model.glb";

function problemOf(read: () => unknown): TexelcastError {
  try {
    read();
  } catch (error) {
    if (error instanceof TexelcastError) return error;
    throw error;
  }
  throw new Error("nothing was wrong");
}

/** A GLB whose header or chunk lengths can be lied about. */
function glbOf(
  json: Uint8Array,
  lies: { version?: number; total?: number; jsonLength?: number; type?: number } = {},
): Uint8Array {
  const bytes = new Uint8Array(20 + json.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, 0x46546c67, true);
  view.setUint32(4, lies.version ?? 2, true);
  view.setUint32(8, lies.total ?? bytes.length, true);
  view.setUint32(12, lies.jsonLength ?? json.length, true);
  view.setUint32(16, lies.type ?? 0x4e4f534a, true);
  bytes.set(json, 20);
  return bytes;
}

describe("a GLB", () => {
  it("comes back with its JSON, its BIN and chunks of unknown types", () => {
    const json = { asset: { version: "2.0" }, extras: { note: "grüße" } };
    const extra = { type: 0x12345678, bytes: Uint8Array.of(1, 2, 3, 4) };
    const glb = writeGlb(json, Uint8Array.of(9, 8, 7, 6, 5), [extra]);
    expect(glb.length % 4).toBe(0);
    const container = readContainer({ name, bytes: glb });
    expect(container.json).toEqual(json);
    expect(container.binary?.slice(0, 5)).toEqual(Uint8Array.of(9, 8, 7, 6, 5));
    expect(container.extraChunks).toEqual([extra]);
  });

  it("is read where its names are not UTF-8, as some exporters write them: what cannot be told is a sign for that", () => {
    const before = encode('{"asset":{"version":"2.0"},"materials":[{"name":"Gr');
    const bytes = glbOf(Uint8Array.of(...before, 0xfc, ...encode('n"}]}')));
    expect(readContainer({ name, bytes }).json.materials).toEqual([{ name: "Gr\ufffdn" }]);
  });

  it.each([
    ["a text file", encode("I am a text file named model.glb"), /neither as a GLB/],
    ["an empty file", new Uint8Array(), /it is empty/],
    ["a PNG", solidPng(1, 1, [0, 0, 0, 0]), /seems to be a PNG picture/],
    ["a ZIP", encode("PK\x03\x04rest"), /ZIP archive/],
    ["a web page", encode("<!doctype html>"), /HTML or XML page/],
    ["only the magic", encode("glTF"), /ends inside its header/],
    ["a GLB of version 1", glbOf(encode("{}"), { version: 1 }), /container has version 1/],
    ["a file that was cut short", buildGlb({ meshes: [plane()] }).subarray(0, 300), /was cut short/],
    ["a chunk longer than the file", glbOf(encode("{}  "), { jsonLength: 0xfffffff0 }), /its chunk 0 says/],
    ["no chunk at all", glbOf(encode("{}  "), { total: 12 }), /first chunk is not JSON/],
    ["a first chunk that is not JSON", glbOf(encode("{}  "), { type: 0x004e4942 }), /first chunk is not JSON/],
    ["JSON that is no text", glbOf(Uint8Array.of(0x7b, 0xff, 0xfe, 0x7d)), /cannot be parsed/],
    ["broken JSON", glbOf(encode('{"asset": ')), /cannot be parsed/],
    ["JSON that is a list", glbOf(encode("[1,2]   ")), /not an object/],
    ["no version", glbOf(encode('{"asset":{}}')), /does not say its version/],
    ["glTF 1.0", glbOf(encode('{"asset":{"version":"1.0"}}')), /only glTF 2\.0/],
    [
      "JSON nested without end",
      glbOf(encode(`{"asset":{"version":"2.0"},"extras":${"[".repeat(1e5)}`)),
      /nested deeper/,
    ],
  ])("is refused with a clear error when it is %s", (_, bytes, message) => {
    const error = problemOf(() => readContainer({ name, bytes }));
    expect(error.message).toMatch(message);
    expect(error).toMatchObject({ code: "bad-container", subject: name });
  });

  it("is refused at whatever byte it was cut", () => {
    const whole = buildGlb({
      meshes: [plane()],
      images: [{ bytes: solidPng(2, 2, [1, 2, 3, 4]), mimeType: "image/png" }],
    });
    for (let length = 0; length < whole.length; length += 7) {
      const error = problemOf(() => readContainer({ name, bytes: whole.subarray(0, length) }));
      expect(error.code).toBe("bad-container");
    }
  });

  it("may lie anywhere in a larger buffer", () => {
    const glb = buildGlb({ meshes: [plane()] });
    const within = new Uint8Array(glb.length + 7);
    within.set(glb, 7);
    expect(readContainer({ name, bytes: within.subarray(7) }).json).toEqual(readContainer({ name, bytes: glb }).json);
  });

  it("cannot reach JavaScript's prototypes", () => {
    const text =
      '{"asset":{"version":"2.0"},"__proto__":{"buffers":[{"byteLength":8}]},"constructor":{"prototype":{"x":1}}}';
    const packed = packGltf(readContainer({ name, bytes: glbOf(encode(text)) }));
    expect(packed.binary).toBeNull();
    expect(({} as Record<string, unknown>).buffers).toBeUndefined();
    expect(({} as Record<string, unknown>).x).toBeUndefined();
    expect(JSON.stringify(packed.json)).toBe(text);
  });
});

describe("a .gltf with side files", () => {
  const { json, binary } = buildModel({
    meshes: [plane()],
    images: [{ bytes: solidPng(3, 2, [1, 2, 3, 255]), mimeType: "image/png" }],
  });
  const picture = solidPng(5, 4, [9, 8, 7, 255]);
  const external = (uris: { buffer: string; image: string }): Uint8Array =>
    gltfText({
      ...json,
      buffers: [{ byteLength: binary.length, uri: uris.buffer, name: "geometry" }],
      images: [{ uri: uris.image }],
    });

  it("lists the files that it needs, each once, as they are written in it", () => {
    const twice = {
      asset: { version: "2.0" },
      images: [{ uri: "a%20b.png" }, { uri: "a%20b.png" }, { uri: "data:,x" }],
    };
    expect(listSideFiles({ name, bytes: gltfText(twice) })).toEqual(["a%20b.png"]);
    expect(listSideFiles({ name, bytes: external({ buffer: "x/y.bin", image: "z.jpg" }) })).toEqual([
      "x/y.bin",
      "z.jpg",
    ]);
    expect(listSideFiles({ name, bytes: buildGlb({ meshes: [plane()] }) })).toEqual([]);
  });

  it("is packed into one buffer, its picture's type told by content", () => {
    const bytes = external({ buffer: "m.bin", image: "p.jpg" });
    const resources = new Map([
      ["m.bin", binary],
      ["p.jpg", picture],
    ]);
    const packed = packGltf(readContainer({ name, bytes, resources }));
    const views = packed.json.bufferViews as JsonObject[];
    expect(packed.json.buffers).toEqual([{ byteLength: packed.binary?.length, name: "geometry" }]);
    expect(packed.json.images).toEqual([{ bufferView: views.length - 1, mimeType: "image/png" }]);
    const { byteOffset = 0, byteLength = 0 } = views.at(-1) as { byteOffset?: number; byteLength?: number };
    expect(packed.binary?.slice(byteOffset, byteOffset + byteLength)).toEqual(picture);
    expect(packed.binary?.slice(0, binary.length)).toEqual(binary);
  });

  it("finds a file under its percent-encoded name, its plain name, and with ./ in front", () => {
    for (const [written, given] of [
      ["my%20model.bin", "my model.bin"],
      ["./m.bin", "m.bin"],
      ["d\\m.bin", "d/m.bin"],
      ["50%.bin", "50%.bin"],
    ] as const) {
      const resources = new Map([
        [given, binary],
        ["p", picture],
      ]);
      const packed = packGltf(readContainer({ name, bytes: external({ buffer: written, image: "p" }), resources }));
      expect(packed.binary?.slice(0, binary.length)).toEqual(binary);
    }
  });

  it("takes data addresses, base64 or percent-encoded", () => {
    const base64 = `data:application/octet-stream;base64,${Buffer.from(binary).toString("base64")}`;
    const percent = `data:image/png,${[...picture].map((byte) => `%${byte.toString(16).padStart(2, "0")}`).join("")}`;
    const packed = packGltf(readContainer({ name, bytes: external({ buffer: base64, image: percent }) }));
    const view = (packed.json.bufferViews as { byteOffset: number }[]).at(-1);
    expect(packed.binary?.slice(0, binary.length)).toEqual(binary);
    expect(packed.binary?.slice(view?.byteOffset)).toEqual(picture);
  });

  it("takes them whatever the capitals of their scheme, and asks nobody for their files", () => {
    const base64 = `DATA:Application/Octet-Stream;Base64,${Buffer.from(binary).toString("base64")}`;
    const percent = `Data:image/png,${[...picture].map((byte) => `%${byte.toString(16).padStart(2, "0")}`).join("")}`;
    const bytes = external({ buffer: base64, image: percent });
    expect(listSideFiles({ name, bytes })).toEqual([]);
    expect(packGltf(readContainer({ name, bytes })).binary?.slice(0, binary.length)).toEqual(binary);
  });

  it("names the file that is missing, and does not download anything", () => {
    const missing = problemOf(() =>
      packGltf(readContainer({ name, bytes: external({ buffer: "gone.bin", image: "p" }) })),
    );
    expect(missing).toMatchObject({ code: "missing-file", value: "gone.bin", field: "buffers[0].uri", subject: name });
    const remote = external({ buffer: "m.bin", image: "https://example.org/p.png" });
    const resources = new Map([["m.bin", binary]]);
    const away = problemOf(() => packGltf(readContainer({ name, bytes: remote, resources })));
    expect(away).toMatchObject({ code: "missing-file", value: "https://example.org/p.png" });
    expect(away.hint).toMatch(/Nothing is downloaded/);
    const windows = external({ buffer: "m.bin", image: "D:\\work\\p.png" });
    const elsewhere = problemOf(() => packGltf(readContainer({ name, bytes: windows, resources })));
    expect(elsewhere.hint).toMatch(/^Give “D:\\work\\p.png” together with the model/);
  });

  it.each([
    ["a buffer shorter than it says", { buffers: [{ byteLength: 8, uri: "data:,abc" }] }, "buffers[0].byteLength"],
    ["a buffer without a length", { buffers: [{ uri: "data:,abc" }] }, "buffers[0].byteLength"],
    ["a buffer of negative length", { buffers: [{ byteLength: -1, uri: "data:,abc" }] }, "buffers[0].byteLength"],
    ["a buffer without data", { buffers: [{ byteLength: 3 }] }, "buffers[0]"],
    ["broken base64", { buffers: [{ byteLength: 3, uri: "data:;base64,$$$" }] }, "buffers[0].uri"],
    ["a data address without data", { buffers: [{ byteLength: 0, uri: "data:" }] }, "buffers[0].uri"],
    [
      "a view beyond its buffer",
      { buffers: [{ byteLength: 3, uri: "data:,abc" }], bufferViews: [{ buffer: 0, byteOffset: 2, byteLength: 2 }] },
      "bufferViews[0].byteLength",
    ],
    ["a view of no buffer", { bufferViews: [{ buffer: 0, byteLength: 1 }] }, "bufferViews[0].buffer"],
    [
      "a view with half an offset",
      { buffers: [{ byteLength: 3, uri: "data:,abc" }], bufferViews: [{ buffer: 0, byteOffset: 0.5, byteLength: 1 }] },
      "bufferViews[0].byteOffset",
    ],
    ["buffers that are no list", { buffers: { length: 1e9 } }, "buffers"],
    ["a buffer that is no object", { buffers: [null] }, "buffers[0]"],
    ["images that are no list", { images: "all" }, "images"],
  ] as [string, JsonObject, string][])("is refused with %s, naming the place", (_, members, field) => {
    const bytes = gltfText({ asset: { version: "2.0" }, ...members });
    expect(problemOf(() => packGltf(readContainer({ name, bytes })))).toMatchObject({ code: "bad-container", field });
  });
});
