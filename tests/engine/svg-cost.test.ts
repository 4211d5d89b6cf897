import { gzipSync } from "node:zlib";
import { afterEach, describe, expect, it } from "vitest";
import { canFilter, costOf, type SvgCost } from "../../web/engine/svg-cost.ts";
import { elementsOf } from "../../web/engine/svg-elements.ts";
import { readSvgFile } from "../../web/engine/svg-file.ts";
import { NO_SHAPES } from "../../web/engine/svg-shapes.ts";
import { decal } from "../support/layers.ts";
import { allTexels, endHosts, paintablePlane } from "../support/painted-plane.ts";

afterEach(endHosts);

const svgOf = (body: string): Uint8Array =>
  new TextEncoder().encode(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">${body}</svg>`);
const filtered = (primitives: string, drawn = '<rect width="90" height="90" filter="url(#f)"/>'): Uint8Array =>
  svgOf(`<filter id="f">${primitives}</filter>${drawn}`);
const matrix = (order: number): string =>
  `<feConvolveMatrix order="${order}" kernelMatrix="${Array(order * order)
    .fill(1)
    .join(" ")}"/>`;
const NOISE = '<feTurbulence baseFrequency="1" numOctaves="3"/>';
const FILTERED_RECT = '<rect width="90" height="90" filter="url(#f)"/>';
const FAR = `<filter id="far" x="-100" y="-100" width="201" height="201">${NOISE}</filter>`;
const drawingInside = (drawing: Uint8Array): Uint8Array =>
  svgOf(`<image width="9" height="9" href="data:image/svg+xml;base64,${Buffer.from(drawing).toString("base64")}"/>`);
const SHADOW =
  '<feGaussianBlur stdDeviation="2"/><feOffset dx="1" dy="1"/><feMerge><feMergeNode/><feMergeNode in="SourceGraphic"/></feMerge>';

const filtersOf = (simplified: string): SvgCost["filters"] => costOf(elementsOf(simplified), () => NO_SHAPES).filters;

describe("the filters of a drawing", () => {
  it.each([
    ["a hundred million octaves of noise", '<feTurbulence baseFrequency="1" numOctaves="100000000"/>', undefined],
    [
      "noise by a style, many times over",
      '<feTurbulence baseFrequency="1" numOctaves="5000"/>',
      "<style>.a{filter:url(#f)}</style>".concat('<rect class="a" width="90" height="90"/>'.repeat(100)),
    ],
    ["a great many passes", SHADOW.repeat(2000), undefined],
    ["a huge matrix", matrix(200).repeat(10), undefined],
    [
      "a window that a transform makes as large as the picture",
      '<feMorphology operator="dilate" radius="1"/>'.repeat(100),
      '<g transform="scale(100)"><rect width="1" height="1" filter="url(#f)"/></g>',
    ],
    ["noise far around a small thing", NOISE, `<rect width="90" height="90" filter="url(#far)"/>${FAR}`],
    [
      "noise over a rectangle of its own units",
      NOISE,
      `<rect width="9" height="9" filter="url(#u)"/><filter id="u" filterUnits="userSpaceOnUse" width="99999" height="99999">${NOISE}</filter>`,
    ],
    ["noise that a transform enlarges", NOISE, `<g transform="rotate(9) scale(300)">${FILTERED_RECT}</g>`],
    ["noise on what is far larger than the picture", NOISE, '<path d="M0 0h30000v30000z" filter="url(#f)"/>'],
    ["noise behind huge words", NOISE, '<text font-size="20000" filter="url(#f)">WW</text>'],
    [
      "noise in a mask that is enlarged where it is asked for",
      NOISE,
      `<mask id="m" maskUnits="userSpaceOnUse" width="9" height="9">${FILTERED_RECT}</mask><g transform="scale(300)" mask="url(#m)"><rect width="9" height="9"/></g>`,
    ],
    [
      "noise in a pattern of one unit",
      NOISE,
      `<pattern id="p" width="1" height="1" viewBox="0 0 0.1 0.1">${FILTERED_RECT}</pattern><rect width="90" height="90" fill="url(#p)"/>`,
    ],
  ])("are refused by the file's name where they would take for ever: %s", async (_what, primitives, drawn) => {
    await expect(readSvgFile(filtered(primitives, drawn), "evil.svg")).rejects.toMatchObject({
      code: "bad-picture",
      message: expect.stringMatching(/evil\.svg.*filters would take too long/),
    });
  });

  it("that drawings have pass, and the more they are the fewer pixels they get", async () => {
    const one = await readSvgFile(filtered(SHADOW), "one.svg");
    expect(canFilter(one.cost, 2048, 2048)).toBe(true);
    const many = await readSvgFile(filtered(SHADOW, FILTERED_RECT.repeat(50)), "many");
    expect(canFilter(many.cost, 2048, 2048)).toBe(false);
    expect(canFilter(many.cost, 256, 256)).toBe(true);
    expect((await readSvgFile(svgOf('<rect width="9" height="9"/>'), "plain.svg")).cost.filters).toEqual([]);
  });

  it("count by the pixels that they go over, in the picture and beside it", async () => {
    const areas = async (body: string): Promise<number[]> =>
      (await readSvgFile(svgOf(`<filter id="f">${NOISE}</filter>${FAR}${body}`), "a")).cost.filters.map(
        ({ area }) => area,
      );
    expect(await areas('<rect width="9" height="9" filter="url(#f)"/>')).toEqual([expect.closeTo(0.09 * 0.09 * 1.44)]);
    expect(await areas('<rect width="900" height="500" filter="url(#f)"/>')).toEqual([expect.closeTo(9 * 5 * 1.44)]);
    expect(await areas('<path d="M8 8l2 1-1 2z" filter="url(#far)"/>')).toEqual([expect.closeTo(4.02 * 6.03)]);
    expect(
      await areas(
        '<g filter="url(#f)"><g transform="translate(500)"><rect width="100" height="100"/></g><rect width="1" height="1"/></g>',
      ),
    ).toEqual([expect.closeTo(6 * 1.44)]);
  });

  it("are found however they are spelled", async () => {
    const { cost } = await readSvgFile(
      svgOf('<g style="f&#105;lter:blur(4px)"><path d="M0 0h9v9z"/></g>'),
      "spelled.svg",
    );
    expect(cost.filters).toHaveLength(1);
  });

  it.each([
    ["has them", `<filter id="f">${NOISE}</filter>${FILTERED_RECT}`],
    ["hides them", '<g style="f&#105;lter:blur(4px)"><path d="M0 0h9v9z"/></g>'],
  ])("are refused in a drawing inside that %s", async (_what, body) => {
    await expect(readSvgFile(drawingInside(svgOf(body)), "outer.svg")).rejects.toMatchObject({
      code: "bad-picture",
      message: expect.stringMatching(/outer\.svg.*drawing inside it has filters/),
    });
  });

  it("are not taken for granted in a drawing inside, but where it is packed", async () => {
    const plain = svgOf('<rect width="9" height="9"/>');
    expect((await readSvgFile(drawingInside(plain), "outer.svg")).cost.filters).toEqual([]);
    await expect(readSvgFile(drawingInside(gzipSync(plain)), "outer.svg")).rejects.toMatchObject({
      code: "bad-picture",
    });
  });

  it("are weighed beside any number of patterns", () => {
    const patterns = '<pattern id="q"></pattern>'.repeat(200_000);
    const document = `<svg viewBox="0 0 100 100"><defs><filter id="f"><feFlood/></filter>${patterns}</defs><g filter="url(#f)"></g></svg>`;
    expect(filtersOf(document)).toHaveLength(1);
  });

  it("count as often as a pattern with them is used", () => {
    const of = (uses: number): string =>
      `<svg viewBox="0 0 100 100"><defs><filter id="f"><feFlood/></filter><pattern id="p"><g filter="url(#f)"></g></pattern></defs>${'<path fill="url(#p)"/>'.repeat(uses)}</svg>`;
    const weigh = (uses: number): number =>
      filtersOf(of(uses)).reduce((sum, { weight, times }) => sum + weight * times, 0);
    expect(weigh(9) / weigh(1)).toBe(9);
  });

  it("are drawn smaller where the full size would take too long", async () => {
    const { engine } = await paintablePlane();
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    const before = await allTexels(engine);
    await engine.setAsset("shadows", {
      name: "shadows.svg",
      bytes: filtered(SHADOW, '<rect width="80" height="80" fill="#f00" filter="url(#f)"/>'.repeat(60)),
    });
    engine.setLayers([decal("d", "shadows")], 1);
    await engine.idle();
    expect(errors).toEqual([]);
    expect(await allTexels(engine)).not.toEqual(before);
  });
});
