/** Addresses that a page gives: as text and as URL objects, with names and without. */
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { afterEach, describe, expect, it, vi } from "vitest";
import { readBytes } from "../../web/core/read-bytes.ts";
import { pictureName } from "../../web/element/desk/placing.ts";
import { readZones } from "../../web/element/desk/prints.ts";
import { readDesign } from "../../web/element/desk/read-design.ts";
import { fetchBytes } from "../../web/element/desk/read-model.ts";
import type { DesignInput } from "../../web/element/element-api.ts";
import { english } from "../../web/element/words/english.ts";
import { german } from "../../web/element/words/german.ts";
import { worded } from "../../web/element/words/worded.ts";

const BASE = "https://shop.example/product.html";
const fetching = { words: english, signal: new AbortController().signal };
const json = (data: object): URL => new URL(`data:application/json,${encodeURIComponent(JSON.stringify(data))}`);

describe("an address", () => {
  it("of zones may be a URL object, as that of a picture may", async () => {
    const address = json({ texelcastZones: 1, printScale: 2, zones: [] });
    expect(await readZones(address, BASE, fetching)).toEqual(await readZones(address.href, BASE, fetching));
    expect((await readZones(address, BASE, fetching)).printScale).toBe(2);
  });

  it("of a design may be a URL object", async () => {
    const address = json({ format: "texelcast-design", version: 1, layers: [{ type: "fill", color: "#ff0000" }] });
    // A design without files asks nothing of the engine.
    const reading = { ...fetching, base: BASE, limits: {}, library: { release: () => undefined } };
    const read = (input: DesignInput) => readDesign(input, reading as unknown as Parameters<typeof readDesign>[1]);
    expect(await read(address)).toEqual(await read(address.href));
    expect((await read(address)).layers).toHaveLength(1);
  });

  it("that holds a picture, or stands for one in the page, gives it no name out of its letters", () => {
    const named = (address: string): string => pictureName(new URL(address, BASE));
    expect(named("data:image/png;base64,iVBORw0KGgo/AAAA/SUhEUg==")).toBe("picture");
    expect(named("blob:https://shop.example/591989e5-8580-48c6-9806-e932d38fb3e6")).toBe("picture");
    expect([named("/logos/moon%20cat.png?v=2"), named("logo.webp")]).toEqual(["moon cat.png", "logo.webp"]);
  });
});

describe("what cannot be fetched", () => {
  afterEach(() => vi.unstubAllGlobals());

  /** Gives what a server that answers with a status makes of a call, and what one that does not answer at all makes of it. */
  async function askedOf<T>(call: (address: URL) => Promise<T>): Promise<readonly [answered: T, silent: T]> {
    const server = createServer((_request, response) => response.writeHead(404).end("Not here."));
    await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
    const address = new URL(`http://127.0.0.1:${(server.address() as AddressInfo).port}/mug.glb`);
    const answered = await call(address);
    await new Promise((resolve) => server.close(resolve));
    return [answered, await call(address)];
  }
  const thrownBy = (work: Promise<unknown>): Promise<unknown> =>
    work.then(
      () => "fetched",
      (thrown: unknown) => thrown,
    );

  it("says which status the server answered with, or that there was no answer that the page may read", async () => {
    for (const words of [english, german]) {
      const [answered, silent] = await askedOf((url) => thrownBy(fetchBytes(url, { ...fetching, words })));
      const hint = words.errors.unreachableHint;
      expect(answered).toMatchObject({ code: "missing-file", reason: "http-404" });
      expect(answered).toMatchObject({ hint: `${hint} (HTTP 404)` });
      expect(silent).toMatchObject({ code: "missing-file", reason: "not-answered", hint });
    }
  });

  it("says the same of a shop's own words", async () => {
    vi.stubGlobal("document", { baseURI: BASE });
    const [answered, silent] = await askedOf(
      (url) => new Promise((resolve) => void worded(english, url.href, (error) => resolve(error))),
    );
    expect(answered).toMatchObject({ code: "missing-file", reason: "http-404" });
    expect(silent).toMatchObject({ code: "missing-file", reason: "not-answered" });
  });

  it("says the same in Node, where the system's own reason is known", async () => {
    const [answered, silent] = await askedOf((url) => thrownBy(readBytes(url, "The engine's WebAssembly")));
    expect((answered as Error).message).toContain("the server answered 404 Not Found");
    expect((silent as Error).message).toContain("ECONNREFUSED");
  });
});

describe("an answer without an end", () => {
  it("is given up once it is larger than what is taken, with a piece that shows that it is", async () => {
    const sent = { bytes: 0 };
    let onEnd = (): void => undefined;
    const ended = new Promise<void>((resolve) => {
      onEnd = resolve;
    });
    const server = createServer((_request, response) => {
      response.on("close", onEnd);
      const more = (): void => {
        sent.bytes += 16_384;
        if (response.write(Buffer.alloc(16_384))) setImmediate(more);
      };
      response.on("drain", more);
      more();
    });
    await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
    const address = new URL(`http://127.0.0.1:${(server.address() as AddressInfo).port}/endless.png`);
    const bytes = await fetchBytes(address, { ...fetching, most: 100_000 });
    expect(bytes.length).toBeGreaterThan(100_000);
    // The server is told, too, and does not go on.
    await ended;
    expect(bytes.length).toBeLessThanOrEqual(sent.bytes);
    await new Promise((resolve) => server.close(resolve));
  });
});
