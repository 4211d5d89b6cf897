/** What drawings may have that browsers draw and the renderer does not know: docs/design-document.md tells of it. */
import { describe, expect, it } from "vitest";
import { readSvgFile, svgFonts } from "../../web/engine/svg-file.ts";
import { renderSvg } from "../../web/engine/svg-renderer.ts";

async function draw(body: string): Promise<Uint8Array> {
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">${body}</svg>`;
  const file = await readSvgFile(new TextEncoder().encode(svg), "beyond.svg");
  return renderSvg(file.svg, 64, svgFonts([])).rgba;
}

const LINE = '<path d="M20 80L80 20" stroke="#05a" stroke-width="4" marker-end="url(#m)"/>';
const arrow = (orient: string): string =>
  `<marker id="m" viewBox="0 0 10 10" refX="5" refY="5" orient=${orient}><path d="M0 0L10 5L0 10Z"/></marker>${LINE}`;
const BOX = 'd="M30 30h40v20h-40z"';

describe("a drawing", () => {
  it.each(['"auto-start-reverse"', "'auto-start-reverse'"])(
    "has arrowheads that point as its lines go, as Inkscape writes them: orient=%s",
    async (orient) => {
      expect(await draw(arrow(orient))).toEqual(await draw(arrow('"auto"')));
      expect(await draw(arrow(orient))).not.toEqual(await draw(arrow('"0"')));
    },
  );

  it.each([
    ["CSS transform", `<path ${BOX} style="transform:rotate(45deg)"/>`, `<path ${BOX}/>`],
    [
      "transform-origin",
      `<path ${BOX} transform="rotate(9)" style="transform-origin:50px 40px"/>`,
      `<path ${BOX} transform="rotate(9)"/>`,
    ],
    ["var()", `<style>:root{--c:#c06}</style><path ${BOX} style="fill:var(--c)"/>`, `<path ${BOX}/>`],
    ["@media", `<style>@media (min-width:1px){path{fill:#00f}}</style><path ${BOX}/>`, `<path ${BOX}/>`],
    ["colours with spaces", `<path ${BOX} fill="rgb(0 128 0 / 50%)"/>`, `<path ${BOX}/>`],
    ["clip-path's shapes", `<path ${BOX} style="clip-path:circle(9px at 50px 40px)"/>`, `<path ${BOX}/>`],
    [
      "pathLength",
      `<path ${BOX} stroke="#f00" pathLength="9" stroke-dasharray="25"/>`,
      `<path ${BOX} stroke="#f00" stroke-dasharray="25"/>`,
    ],
    [
      "vector-effect",
      `<path ${BOX} stroke="#f00" transform="scale(.5)" vector-effect="non-scaling-stroke"/>`,
      `<path ${BOX} stroke="#f00" transform="scale(.5)"/>`,
    ],
  ])("is drawn as if it did not have what the renderer does not know: %s", async (_what, svg, without) => {
    expect(await draw(svg)).toEqual(await draw(without));
  });
});
