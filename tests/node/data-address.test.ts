/** Pictures that stand in the design itself, as `data:` addresses. */
import { afterEach, expect, it, vi } from "vitest";
import { renderPrint } from "../../node/print.ts";
import { planeGlb } from "./plane-model.ts";

const projector = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 };
const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" width="8" height="8"><title>für 5 €</title><path fill="#f00" d="M0 0h8v4z"/></svg>`;
const FILE = new TextEncoder().encode(DRAWING);

/** The print's hash. `bytes` are those of a file beside the design. */
async function printOf(uri: string, bytes?: Uint8Array): Promise<string> {
  const assets = { drawing: { type: "image/svg+xml", uri } };
  const design = {
    format: "texelcast-design",
    version: 1,
    assets,
    layers: [{ type: "decal", asset: "drawing", projector }],
  };
  const files = bytes === undefined ? [] : [{ name: uri, bytes }];
  return (await renderPrint({ model: planeGlb(), design, assets: files, size: 16 })).sha256;
}

afterEach(() => {
  vi.unstubAllGlobals();
});

it.each([
  [
    "as it is written, with signs of addresses in it and letters that no address has",
    `data:image/svg+xml;utf8,${DRAWING}`,
  ],
  ["by the numbers of its letters", `data:image/svg+xml,${encodeURIComponent(DRAWING)}`],
  ["in base64", `data:image/svg+xml;base64,${Buffer.from(FILE).toString("base64")}`],
])("a drawing is printed as the file of the same letters: %s", async (_what, uri) => {
  expect(await printOf(uri)).toBe(await printOf("drawing.svg", FILE));
});

it("is read where a server has no `fetch`, or one of its own that knows the network alone", async () => {
  const uri = `data:image/svg+xml;base64,${Buffer.from(FILE).toString("base64")}`;
  const sha256 = await printOf(uri);
  const fetch = vi.fn(() => Promise.reject(new TypeError("Only HTTP(S) protocols are supported")));
  vi.stubGlobal("fetch", fetch);
  expect(await printOf(uri)).toBe(sha256);
  expect(fetch).not.toHaveBeenCalled();
});
