import { existsSync, readdirSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { SHOP_LIMITS } from "../../web/storefront/api/shop-api.ts";
import { FACING_DOWN } from "../node/plane-model.ts";
import { pngChunk } from "../support/png-file.ts";
import { designWith, LOGO, openShop, SNAPSHOT, sha256 } from "./shop-fixture.ts";

const shop = await openShop();
const cart = await shop.cart();
const text = (content: string): Uint8Array => new TextEncoder().encode(content);
const dataAddress = (type: string, bytes: Uint8Array): string =>
  `data:${type};base64,${Buffer.from(bytes).toString("base64")}`;

/** A PNG whose header says what its pixels do not. */
function pngOfSize(width: number, height: number): Uint8Array {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 6, 0, 0, 0], 8);
  const chunks = [pngChunk("IHDR", header), pngChunk("IDAT", Buffer.alloc(8)), pngChunk("IEND", Buffer.alloc(0))];
  return new Uint8Array(Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), ...chunks]));
}

const WHOLE = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 };
const SMALL_FLAT = { ...WHOLE, size: [0.01, 0.01] };
/** Of a thumb's width, on a plane of a metre. */
const SMALL = { kind: "planar", position: [0.1, 0, 0.1], rotation: FACING_DOWN, size: [0.02, 0.02, 0.02] };
const BEFORE = {
  kind: "perspective",
  position: [0, 1, 0],
  rotation: FACING_DOWN,
  fov: 90,
  aspect: 1,
  near: 0.1,
  far: 2,
};
const strokeOf = (count: number, dab: object = WHOLE, more: object = {}): object => ({
  ...{ type: "stroke", material: 0, brush: { color: "#ff0000" }, ...more },
  dabs: Array.from({ length: count }, () => dab),
});

it.each([
  ["a missing body is told as the body", undefined, "body"],
  ["a name with a control character is refused", { name: "Ada\u0000Lovelace" }, "name"],
  ["a name that turns what is printed after it around is refused", { name: "Ada\u202eecalevoL" }, "name"],
  ["a name of nothing that is seen is refused", { name: "\u200b\u2060" }, "name"],
])("%s", async (_what, payload, field) => {
  const url = `/api/carts/${cart}/order`;
  const reply = await shop.app.inject({ method: "POST", url, ...(payload && { payload }) });
  expect(reply.statusCode).toBe(400);
  const { error } = reply.json();
  expect(error).toMatchObject({ code: "bad-request", field });
  expect(error.message.startsWith(`${field}: must`)).toBe(true);
});

it("a design that somebody has painted with the brush is taken", async () => {
  const layers = [strokeOf(3000, SMALL), strokeOf(1000, SMALL_FLAT)];
  const reply = await shop.addLine(cart, await shop.line({ design: { ...designWith(), layers }, unitPrice: 1000 }));
  expect(reply.json()).toMatchObject({ line: expect.anything() });
  expect(reply.statusCode).toBe(201);
});

it("a line that names an asset twice is refused by the second one, whichever file it names", async () => {
  const line = (await shop.line()) as { assets: object[] };
  for (const key of ["logo", "other"]) {
    const twice = { key, sha256: sha256(SNAPSHOT) };
    const assets = [...line.assets, { ...twice, key: "other" }, twice];
    const { error } = (await shop.addLine(cart, { ...line, assets })).json();
    expect(error).toMatchObject({ code: "bad-request", field: "assets[2].key" });
  }
});

describe("a file is refused", () => {
  it.each<[string, Uint8Array, string]>([
    ["that is a page", text("<!doctype html><script>alert(1)</script>"), "bad-picture"],
    ["that is a script", text("alert(1)"), "bad-picture"],
    ["that is empty", new Uint8Array(), "bad-picture"],
    ["that is a PNG cut short", LOGO.slice(0, 40), "bad-picture"],
    ["that claims more pixels than it may have", pngOfSize(60_000, 60_000), "bad-picture"],
    ["that is a drawing which grows beyond all measure", lolSvg(), "bad-picture"],
    [
      "that is a drawing with a script",
      text('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><script>alert(1)</script></svg>'),
      "unsafe-file",
    ],
    ["that is a font cut short", text("\0\x01\0\0\0\x10"), "bad-font"],
  ])("%s", async (_what, bytes, code) => {
    const reply = await shop.putFile(bytes);
    expect(reply.json().error.code).toBe(code);
    expect(reply.statusCode).toBeGreaterThanOrEqual(400);
    expect((await shop.app.inject(`/api/files/${sha256(bytes)}`)).statusCode).toBe(404);
  });

  it("whose address cannot be decoded, in the form of every refusal", async () => {
    const reply = await shop.app.inject("/api/files/%");
    expect(reply.statusCode).toBe(400);
    expect(reply.json().error).toMatchObject({ code: "bad-request", message: expect.stringMatching(/./) });
  });

  it("whose bytes are not those that its name says", async () => {
    const reply = await shop.putFile(LOGO, sha256(SNAPSHOT));
    expect(reply.statusCode).toBe(422);
    expect(reply.json().error).toMatchObject({ code: "hash-mismatch", field: "sha256" });
  });

  it("that has more bytes than the shop takes", async () => {
    const reply = await shop.putFile(new Uint8Array(SHOP_LIMITS.assetBytes + 1));
    expect(reply.statusCode).toBe(413);
    expect(reply.json().error.code).toBe("too-large");
  });

  it("when the shop has no more room, and what is there already is taken again", async () => {
    const full = await openShop({ storedBytes: LOGO.length });
    expect((await full.putFile(LOGO)).statusCode).toBe(201);
    const reply = await full.putFile(SNAPSHOT);
    expect(reply.statusCode).toBe(507);
    expect(reply.json().error.code).toBe("storage-full");
    expect((await full.putFile(LOGO)).statusCode).toBe(201);
  });

  it("never for room that nothing takes: sent many times at once, it takes its room once", async () => {
    const small = await openShop({ storedBytes: LOGO.length + SNAPSHOT.length });
    const replies = await Promise.all(Array.from({ length: 50 }, () => small.putFile(LOGO)));
    expect(replies.every(({ statusCode }) => statusCode === 201)).toBe(true);
    expect((await small.putFile(SNAPSHOT)).statusCode).toBe(201);
  });

  it("when others that come at the same time take the room", async () => {
    const full = await openShop({ storedBytes: Math.max(LOGO.length, SNAPSHOT.length) });
    const replies = await Promise.all([full.putFile(LOGO), full.putFile(SNAPSHOT)]);
    expect(replies.map(({ statusCode }) => statusCode).sort()).toEqual([201, 507]);
  });

  it.each(["../../shop.sqlite", "..%2f..%2fshop.sqlite", "%2e%2e/shop.sqlite", "....//shop.sqlite", "A".repeat(64)])(
    "whose name leads elsewhere: %s",
    async (name) => {
      expect((await shop.app.inject(`/api/files/${name}`)).statusCode).toBe(404);
      expect((await shop.putFile(LOGO, name)).statusCode).toBeGreaterThanOrEqual(400);
      expect(readdirSync(path.join(shop.folder, "files")).every((entry) => /^[0-9a-f]{2}$/.test(entry))).toBe(true);
    },
  );
});

describe("a design is refused", () => {
  it.each<[string, object, string, string]>([
    ["with an unknown field", designWith({ onload: "alert(1)" }), "bad-design", "layers[0].onload"],
    ["for a material that is not printed", designWith({ material: 1 }), "bad-design", "layers[0].material"],
    ["of a size without end", designWith({ opacity: 1e300 }), "bad-design", "layers[0].opacity"],
    ["whose asset is on the web", named("https://example.org/logo.png"), "bad-design", "assets.other.uri"],
    ["whose asset is a file of the server's", named("file:///etc/passwd"), "bad-design", "assets.other.uri"],
    ["whose asset is in the folder above", named("../../shop.sqlite"), "bad-design", "assets.other.uri"],
    ["whose asset leads out of the files", named("/api/files/../products"), "bad-design", "assets.other.uri"],
    [
      "whose data address says PNG and holds a page",
      named(dataAddress("image/png", text("<html><script>alert(1)</script></html>"))),
      "bad-picture",
      "",
    ],
    [
      "whose data address says PNG and holds a drawing",
      named(dataAddress("image/png", text('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>'))),
      "bad-design",
      "assets.other.uri",
    ],
    ["whose data address is broken", named("data:image/png;base64,%%%"), "bad-design", "assets.other.uri"],
    [
      "whose asset is of another type than it says",
      designWith({}, { type: "image/jpeg" }),
      "bad-design",
      "assets.logo.type",
    ],
    [
      "of too many layers",
      { ...designWith(), layers: manyLayers(SHOP_LIMITS.layersPerDesign + 1) },
      "too-large",
      "design.layers",
    ],
    [
      "of a stroke that would keep the press from everybody else",
      { ...designWith(), layers: [strokeOf(SHOP_LIMITS.layersPerDesign + 1)] },
      "too-large",
      "design.layers",
    ],
    [
      "of a stroke that looks at the whole product with each dab",
      { ...designWith(), layers: [strokeOf(SHOP_LIMITS.layersPerDesign + 1, BEFORE)] },
      "too-large",
      "design.layers",
    ],
    [
      "of a stroke whose twins are too many",
      {
        ...designWith(),
        layers: [strokeOf(SHOP_LIMITS.layersPerDesign - 1, BEFORE, { mirror: { axis: "x" } })],
      },
      "too-large",
      "design.layers",
    ],
    [
      "of more small dabs than anybody paints",
      { ...designWith(), layers: [strokeOf(60 * SHOP_LIMITS.layersPerDesign, SMALL_FLAT)] },
      "too-large",
      "design.layers",
    ],
  ])("%s", async (_what, design, code, field) => {
    const reply = await shop.addLine(cart, await shop.line({ design }));
    expect(reply.json().error).toMatchObject({ code, ...(field && { field }) });
    expect(reply.statusCode).toBeLessThan(500);
  });

  it("that nests without a bottom", async () => {
    const nest = `"layers":${"[".repeat(1e5)}${"]".repeat(1e5)}`;
    const line = JSON.stringify(await shop.line({ design: { ...designWith(), layers: [] } })).replace(
      '"layers":[]',
      nest,
    );
    const reply = await shop.addLine(cart, line);
    expect(reply.statusCode).toBeGreaterThanOrEqual(400);
    expect(reply.statusCode).toBeLessThan(500);
  });

  it.each(["__proto__", "constructor"])("with %s in it", async (key) => {
    const line = JSON.stringify(await shop.line()).replace(
      '"assets":{',
      `"assets":{"${key}":{"prototype":{"type":"image/png"}},`,
    );
    const reply = await shop.addLine(cart, line);
    expect(reply.statusCode).toBeGreaterThanOrEqual(400);
    expect(reply.statusCode).toBeLessThan(500);
    expect(({} as { type?: string }).type).toBeUndefined();
  });

  it("with a file that was never sent", async () => {
    const missing = "ab".repeat(32);
    const reply = await shop.addLine(cart, await shop.line({ assets: [{ key: "logo", sha256: missing }] }));
    expect(reply.json().error).toMatchObject({ code: "not-found", value: missing });
  });

  it("in a request of too many bytes", async () => {
    const design = { ...designWith(), note: "x".repeat(SHOP_LIMITS.jsonBytes) };
    const reply = await shop.addLine(cart, await shop.line({ design }));
    expect(reply.statusCode).toBe(413);
    expect(reply.json().error.code).toBe("too-large");
  });
});

describe("a request is refused", () => {
  it.each<[string, object, string]>([
    ["for a product that is not sold", { product: "__proto__" }, "not-found"],
    ["for no pieces", { quantity: 0 }, "bad-request"],
    ["for half a piece", { quantity: 0.5 }, "bad-request"],
    ["with a price of its own", { unitPrice: 1 }, "price-changed"],
    ["with a price below nothing", { unitPrice: -1 }, "bad-request"],
    ["with an approved hash that is none", { approved: { sha256: "<script>", width: 1, height: 1 } }, "bad-request"],
    ["with a snapshot that is no picture", { snapshot: "0".repeat(64) }, "not-found"],
  ])("%s", async (_what, changes, code) => {
    const reply = await shop.addLine(cart, await shop.line(changes));
    expect(reply.json().error.code).toBe(code);
  });

  it("that is no JSON, without telling of the server's inside", async () => {
    const reply = await shop.addLine(cart, "{");
    expect(reply.statusCode).toBe(400);
    expect(reply.body).not.toMatch(/node_modules|at .*\.ts/);
    expect(reply.json().error.code).toBe("bad-request");
  });

  it.each(["text/plain", "application/x-www-form-urlencoded"])(
    "with a body of another type, as %s, which any page can send from its visitors' browsers",
    async (type) => {
      const url = `/api/carts/${cart}/lines`;
      const payload = JSON.stringify(await shop.line());
      const reply = await shop.app.inject({ method: "POST", url, headers: { "content-type": type }, payload });
      expect(reply.statusCode).toBe(415);
      expect(reply.json().error.code).toBe("bad-request");
    },
  );

  it("when the cart is full", async () => {
    const full = await shop.cart();
    const line = await shop.line();
    for (let count = 0; count < SHOP_LIMITS.linesPerCart; count++) await shop.addLine(full, line);
    expect((await shop.addLine(full, line)).json().error.code).toBe("too-large");
  });

  it("of two that come at once for the last place in a cart", async () => {
    const almostFull = await shop.cart();
    const line = await shop.line();
    for (let count = 1; count < SHOP_LIMITS.linesPerCart; count++) await shop.addLine(almostFull, line);
    const replies = await Promise.all([line, line].map((each) => shop.addLine(almostFull, each)));
    expect(replies.map(({ statusCode }) => statusCode).sort()).toEqual([201, 413]);
    const { lines } = (await shop.app.inject(`/api/carts/${almostFull}`)).json();
    expect(lines).toHaveLength(SHOP_LIMITS.linesPerCart);
  });
});

describe("what the server sends", () => {
  it("lets no script run but the shop's own", async () => {
    const { headers } = await shop.app.inject("/index.html");
    expect(headers["content-security-policy"]).toContain("script-src 'self' 'wasm-unsafe-eval';");
    expect(headers["content-security-policy"]).toContain("default-src 'none'");
    expect(headers["x-content-type-options"]).toBe("nosniff");
  });

  it("makes a drawing a download that may run nothing", async () => {
    const drawing = text('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><path d="M0 0h9v9z"/></svg>');
    expect((await shop.putFile(drawing)).statusCode).toBe(201);
    const { headers } = await shop.app.inject(`/api/files/${sha256(drawing)}`);
    expect(headers["content-security-policy"]).toBe("default-src 'none'; sandbox");
    expect(headers["content-disposition"]).toBe("attachment");
  });

  it("says with a typed error that an address leads nowhere, and gives nothing from beside the pages", async () => {
    for (const url of ["/nothing", "/../shop.sqlite", "/%2e%2e/shop.sqlite", "/..%5cshop.sqlite"]) {
      const reply = await shop.app.inject(url);
      expect(reply.statusCode).toBeGreaterThanOrEqual(400);
      expect(reply.json().error.code).toMatch(/^(not-found|bad-request)$/);
    }
    expect(existsSync(path.join(shop.folder, "shop.sqlite"))).toBe(true);
  });

  it("never told its log of a fault that nobody expected", () => {
    expect(shop.reported).toEqual([]);
  });
});

/** A design with an asset that came without a file. */
function named(uri: string): object {
  const design = designWith() as { assets: object };
  return { ...design, assets: { ...design.assets, other: { type: "image/png", uri } } };
}

function manyLayers(count: number): object[] {
  const [layer] = (designWith() as { layers: object[] }).layers;
  return Array.from({ length: count }, (_, index) => ({ ...layer, id: `layer-${index}` }));
}

function lolSvg(): Uint8Array {
  const entities = Array.from({ length: 9 }, (_, i) => `<!ENTITY l${i + 1} "${`&l${i};`.repeat(10)}">`).join("");
  return text(
    `<!DOCTYPE svg [<!ENTITY l0 "lol">${entities}]><svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><text>&l9;</text></svg>`,
  );
}
