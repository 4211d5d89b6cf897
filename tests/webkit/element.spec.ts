import { readFileSync } from "node:fs";
import { afterAll, beforeAll, expect, test } from "vitest";
import { avifFile } from "../support/avif-file.ts";
import { exportMugInPage, mugPrintHash } from "../support/mug-print.ts";
import { openSiteInWebkit, type SiteInWebkit } from "./support/site-in-webkit.ts";

type Element = HTMLElementTagNameMap["texelcast-editor"];

let site: SiteInWebkit;

beforeAll(async () => {
  site = await openSiteInWebkit();
});

afterAll(async () => {
  await site?.close();
});

const drawing = `<svg xmlns="http://www.w3.org/2000/svg" width="120" height="60">
  <circle cx="30" cy="30" r="28" fill="#c2410c"/><text x="50" y="40" font-family="Lobster" font-size="30">Ahoy</text></svg>`;

async function gradient(): Promise<Uint8Array> {
  const rgba = Uint8Array.from({ length: 48 * 32 * 4 }, (_, at) => (at % 4 === 3 ? 255 : (at * 37) % 256));
  return avifFile({ width: 48, height: 32, rgba: rgba as Uint8Array<ArrayBuffer> }, 70);
}

test("a shop's element opens in WebKit, takes pictures of each kind and words, and prints the bytes that a server prints", async () => {
  await site.driver.get(`${site.address}element.html?locale=en&size=256&loading=lazy`);
  const pictures = [
    { name: "smiley.png", bytes: readFileSync(new URL("../../build/public/demo/decals/smiley.png", import.meta.url)) },
    { name: "ahoy.svg", bytes: Buffer.from(drawing) },
    { name: "gradient.avif", bytes: Buffer.from(await gradient()) },
  ];
  await site.evaluate(
    async (files) => {
      await customElements.whenDefined("texelcast-editor");
      const element = document.querySelector("texelcast-editor") as Element;
      for (const [place, { name, text }] of files.entries()) {
        const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
        await element.addDecal(new File([bytes], name), { position: [0, 0.03 + 0.02 * place, 0.04], width: 0.03 });
      }
      await element.addText("Moin שלום", { position: [0, 0.02, 0.04] });
    },
    pictures.map(({ name, bytes }) => ({ name, text: bytes.toString("base64") })),
  );
  const exported = await site.evaluate(exportMugInPage);
  expect(exported.design.layers).toHaveLength(4);
  expect(exported.sha256).toBe(await mugPrintHash(exported));
  expect(await site.faults()).toEqual([]);
});
