import { afterEach, describe, expect, it } from "vitest";
import { canFilter, filterUses } from "../../web/engine/svg-cost.ts";
import { readSvgFile } from "../../web/engine/svg-file.ts";
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
const SHADOW =
  '<feGaussianBlur stdDeviation="2"/><feOffset dx="1" dy="1"/><feMerge><feMergeNode/><feMergeNode in="SourceGraphic"/></feMerge>';

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
  ])("are refused by the file's name where they would take for ever: %s", async (_what, primitives, drawn) => {
    await expect(readSvgFile(filtered(primitives, drawn), "evil.svg")).rejects.toMatchObject({
      code: "bad-picture",
      message: expect.stringMatching(/evil\.svg.*filters would take too long/),
    });
  });

  it("that drawings have pass, and the more they are the fewer pixels they get", async () => {
    const one = await readSvgFile(filtered(SHADOW), "one.svg");
    expect(canFilter(one.filters, 2048, 2048)).toBe(true);
    const many = await readSvgFile(
      filtered(SHADOW, '<rect width="9" height="9" filter="url(#f)"/>'.repeat(50)),
      "many",
    );
    expect(canFilter(many.filters, 2048, 2048)).toBe(false);
    expect(canFilter(many.filters, 256, 256)).toBe(true);
    expect((await readSvgFile(svgOf('<rect width="9" height="9"/>'), "plain.svg")).filters).toEqual([]);
  });

  it("count as often as a pattern with them is used", () => {
    const size = { width: 100, height: 100 };
    const of = (uses: number): string =>
      `<svg><defs><filter id="f"><feFlood/></filter><pattern id="p"><g filter="url(#f)"></g></pattern></defs>${'<path fill="url(#p)"/>'.repeat(uses)}</svg>`;
    const weigh = (uses: number): number =>
      filterUses(of(uses), size).reduce((sum, { weight, times }) => sum + weight * times, 0);
    expect(weigh(9) / weigh(1)).toBe(5);
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
