/** Addresses that a page gives: as text and as URL objects, with names and without. */
import { describe, expect, it } from "vitest";
import { pictureName } from "../../web/element/desk/placing.ts";
import { readZones } from "../../web/element/desk/prints.ts";
import { readDesign } from "../../web/element/desk/read-design.ts";
import type { DesignInput } from "../../web/element/element-api.ts";
import { english } from "../../web/element/words/english.ts";

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
