/** What an element on the demo's page (`element.html`) exports, and what a server prints of it, whichever browser it is in. */
import { readFileSync } from "node:fs";
import { renderPrint } from "../../node/print.ts";
import type { ExportedDesign } from "../../web/element/element-api.ts";

/** What can be sent from a page: bytes are numbers. */
export interface ExportedMug {
  /** Of the texture, as it is printed. */
  readonly sha256: string;
  readonly design: ExportedDesign["design"];
  readonly assets: readonly { readonly name: string; readonly bytes: readonly number[] }[];
}

/** For the driver's `page.evaluate`: runs in the page, so it uses nothing from outside itself. */
export async function exportMugInPage(): Promise<ExportedMug> {
  const element = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
  const { sha256 } = await element.exportTexture();
  const { design, assets } = await element.exportDesign();
  return { sha256, design, assets: assets.map(({ name, bytes }) => ({ name, bytes: [...bytes] })) };
}

/** The hash of the server's print, 256 texels a side. */
export async function mugPrintHash({ design, assets }: ExportedMug): Promise<string> {
  const model = new Uint8Array(readFileSync(new URL("../../build/public/demo/mug.glb", import.meta.url)));
  const files = assets.map(({ name, bytes }) => ({ name, bytes: Uint8Array.from(bytes) }));
  return (await renderPrint({ model, design, assets: files, size: 256 })).sha256;
}
