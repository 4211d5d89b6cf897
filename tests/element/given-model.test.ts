import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Run, type RunParts } from "../../web/element/element-run.ts";
import { english } from "../../web/element/words/english.ts";
import type { ModelSource } from "../../web/engine/engine-api.ts";

const opened: ModelSource[] = [];
vi.mock("../../web/element/shop/shop-mode.ts", () => ({
  openMode: () => ({ desk: null, open: async (source: ModelSource) => opened.push(source), close: () => undefined }),
}));

/** Addresses that were asked for. */
const asked: string[] = [];
beforeEach(() => {
  opened.length = 0;
  asked.length = 0;
  vi.stubGlobal("fetch", async (address: URL) => {
    asked.push(address.href);
    return new Response(Uint8Array.of(9));
  });
});
afterEach(() => vi.unstubAllGlobals());

async function openedOf(src: unknown): Promise<ModelSource | undefined> {
  const host = { made: async () => undefined, hooks: {} };
  const design = { given: null, kept: null, keptFirst: false };
  const parts = { kind: "shop", src, design, zones: null, base: "http://shop/", words: english, limits: {}, host };
  await new Run({ ...parts, progress: () => undefined } as unknown as RunParts).open();
  return opened[0];
}

const BYTES = Uint8Array.of(1, 2, 3);

describe("a model that a page gives its element", () => {
  it.each<[string, unknown, string]>([
    ["bytes", BYTES, "src"],
    ["a view of other numbers", new DataView(Uint8Array.of(0, 1, 2, 3).buffer, 1), "src"],
    ["a buffer", BYTES.buffer, "src"],
    ["a blob", new Blob([BYTES]), "src"],
    ["a file", new File([BYTES], "mug.glb"), "mug.glb"],
    ["a name and bytes", { name: "mug.glb", bytes: BYTES }, "mug.glb"],
    ["bytes without a name", { bytes: BYTES.buffer }, "src"],
    ["a name and a blob", { name: "mug.glb", bytes: new Blob([BYTES]) }, "mug.glb"],
  ])("is taken as %s, and nothing is fetched", async (_what, src, name) => {
    expect(await openedOf(src)).toEqual({ name, bytes: BYTES });
    expect(asked).toEqual([]);
  });

  it("keeps the files beside it", async () => {
    const resources = new Map([["mug.bin", BYTES]]);
    expect(await openedOf({ name: "mug.gltf", bytes: BYTES, resources })).toEqual({
      ...{ name: "mug.gltf", bytes: BYTES },
      resources,
    });
  });

  it.each([
    ["text", "mug.glb"],
    ["a URL", new URL("http://shop/mug.glb")],
    ["a link of another window's", { href: "http://shop/mug.glb" }],
  ])("is fetched from an address that is %s", async (_what, src) => {
    expect(await openedOf(src)).toEqual({ name: "mug.glb", bytes: Uint8Array.of(9) });
    expect(asked).toEqual(["http://shop/mug.glb"]);
  });

  it.each<[string, unknown, string, string]>([
    ["an object without bytes", { data: BYTES }, "src", "object"],
    ["an object that has no text", Object.create(null), "src", "object"],
    ["a list", [1, 2, 3], "src", "1,2,3"],
    ["a number", 7, "src", "7"],
    ["a function", () => BYTES, "src", "() => BYTES"],
    ["bytes that are text", { name: "mug.glb", bytes: "glTF" }, "src.bytes", "glTF"],
    ["a name that is none", { name: 7, bytes: BYTES }, "src.name", "7"],
    ["files beside it that are no map", { name: "mug.gltf", bytes: BYTES, resources: {} }, "src.resources", "object"],
  ])(
    "is refused as %s, by the field and with what may be given, and nothing is fetched",
    async (_what, src, field, value) => {
      await expect(openedOf(src)).rejects.toMatchObject({
        ...{ code: "bad-argument", field, value },
        message: english.errors.badOption(field),
        hint: expect.stringMatching(/Uint8Array, ArrayBuffer, Blob, \{ name, bytes, resources: Map \}/),
      });
      expect(asked).toEqual([]);
    },
  );
});
