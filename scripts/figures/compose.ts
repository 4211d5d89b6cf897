/** Panels with their captions on one sheet, laid out by the browser. */
import type { Page } from "@playwright/test";

export interface Panel {
  /** File name in docs/figures, without ".png". */
  readonly name: string;
  readonly caption: string;
  readonly png: Uint8Array;
}

const HEIGHT = 300;

/** Rows of panels of one height. */
export async function composeSheet(page: Page, rows: readonly (readonly Panel[])[]): Promise<Uint8Array> {
  const figures = (row: readonly Panel[]): string =>
    row
      .map(
        ({ caption, png }) =>
          `<figure><img src="${dataUri(png, "image/png")}"><figcaption>${caption}</figcaption></figure>`,
      )
      .join("");
  await page.setContent(`<!doctype html><style>
    body { margin: 0; padding: 16px; width: max-content; background: #fff; }
    section { display: flex; gap: 14px; margin-block-end: 6px; }
    figure { margin: 0; text-align: center; font: 14px/2.1 system-ui, sans-serif; color: #3d434c; }
    img { display: block; height: ${HEIGHT}px; border-radius: 6px; background: #f1f2f4; }
  </style>${rows.map((row) => `<section>${figures(row)}</section>`).join("")}`);
  await page.waitForFunction(() => [...document.images].every((image) => image.complete));
  return page.locator("body").screenshot();
}

/** A picture in another size, for textures that are larger than a figure needs. */
export async function resized(page: Page, png: Uint8Array, side: number): Promise<Uint8Array> {
  return draw(page, `<img src="${dataUri(png, "image/png")}" style="display:block;width:${side}px;height:${side}px">`);
}

/** The mesh's edges in texture space. */
export async function drawUnfolded(page: Page, uvTriangles: Float32Array, side: number): Promise<Uint8Array> {
  const triangles: string[] = [];
  for (let at = 0; at < uvTriangles.length; at += 6) {
    const [a, b, c] = [0, 2, 4].map((corner) =>
      [0, 1].map((axis) => (uvTriangles[at + corner + axis] * side).toFixed(1)).join(" "),
    );
    triangles.push(`M${a}L${b}L${c}Z`);
  }
  const path = `<path d="${triangles.join("")}" fill="#eef2f7" stroke="#3553a4" stroke-width="0.35"/>`;
  return draw(page, `<svg width="${side}" height="${side}" style="display:block;background:#fff">${path}</svg>`);
}

async function draw(page: Page, element: string): Promise<Uint8Array> {
  await page.setContent(`<!doctype html><style>body { margin: 0; width: max-content; }</style>${element}`);
  await page.waitForFunction(() => [...document.images].every((image) => image.complete));
  return page.locator("body > *").screenshot({ omitBackground: true });
}

function dataUri(bytes: Uint8Array, type: string): string {
  return `data:${type};base64,${Buffer.from(bytes).toString("base64")}`;
}
