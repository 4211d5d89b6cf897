import { describe, expect, it } from "vitest";
import { canDraw } from "../../web/engine/svg-cost.ts";
import { readSvgFile, type SvgFile, svgFonts } from "../../web/engine/svg-file.ts";
import { renderSvg } from "../../web/engine/svg-renderer.ts";

const read = (svg: string): Promise<SvgFile> => readSvgFile(new TextEncoder().encode(svg), "beside.svg");
const documentOf = (body: string, attributes = 'viewBox="0 0 100 100"'): string =>
  `<svg xmlns="http://www.w3.org/2000/svg" ${attributes}>${body}</svg>`;
const draw = async (svg: string): Promise<Uint8Array> => {
  const file = await read(svg);
  return renderSvg(file.svg, 64, svgFonts([])).rgba;
};

const ON_PAGE = '<path d="M10 20h50v30z" fill="#f80" opacity="0.7"/>';
const LETTER = '<path d="M0 0h9v9z"/>';
const far = (attributes: string, x = 300, y = 0): string =>
  `<g ${attributes} transform="translate(${x} ${y})">${LETTER}</g>`;
const PICTURE = `<image width="9" height="9" href="data:image/svg+xml,${encodeURIComponent(documentOf(LETTER))}"/>`;
const MARKER =
  '<marker id="m" markerWidth="4" markerHeight="4" refX="2" refY="2"><circle cx="2" cy="2" r="2"/></marker>';

describe("what lies far beside a drawing's page", () => {
  it.each([
    ["translucent, on the right", far('opacity="0.5"')],
    ["translucent, on the left", far('opacity="0.5"', -300)],
    ["translucent, below", far('opacity="0.5"', 0, 300)],
    ["translucent, in a translucent group on the page", `<g opacity="0.9">${far('opacity="0.5"')}</g>`],
    ["of a blend mode", far('style="mix-blend-mode:multiply"')],
    ["clipped", `<clipPath id="c"><rect width="9" height="9"/></clipPath>${far('clip-path="url(#c)"')}`],
    ["masked", `<mask id="c"><rect width="9" height="9"/></mask>${far('mask="url(#c)"')}`],
    ["a picture", far('opacity="0.5"').replace(LETTER, PICTURE)],
    ["markers", `${MARKER}<path d="M0 500${"l9 9".repeat(400)}" stroke="#000" marker-mid="url(#m)"/>`],
  ])("leaves the page as it is: %s", async (_what, beside) => {
    expect(await draw(documentOf(ON_PAGE + beside))).toEqual(await draw(documentOf(ON_PAGE)));
  });

  it("is told by the page's own place and proportions", async () => {
    const page = 'viewBox="900 900 100 100" width="400" height="100"';
    const moved = (body: string): string => `<g transform="translate(900 900)">${body}</g>`;
    const there = await draw(documentOf(moved(ON_PAGE), page));
    expect(there.some((byte) => byte > 0)).toBe(true);
    expect(await draw(documentOf(moved(ON_PAGE + far('opacity="0.5"', 2000)), page))).toEqual(there);
    // The page is four times as wide as its view box, which lies in its middle.
    const beside = moved(ON_PAGE + far('opacity="0.5"', 230));
    expect(await draw(documentOf(beside, page))).not.toEqual(there);
  });

  it("stays where a filter may bring it back", async () => {
    const filter =
      '<filter id="f" filterUnits="userSpaceOnUse" x="-999" width="1999" height="99"><feOffset dx="-290"/>';
    const svg = documentOf(`${filter}</filter><g filter="url(#f)">${far('opacity="0.5"')}</g>`);
    expect((await read(svg)).svg).toBe(svg);
  });

  it("does not change how a drawing without it is read", async () => {
    const svg = documentOf(ON_PAGE + far('opacity="0.5"', 150));
    expect((await read(svg)).svg).toBe(svg);
  });
});

describe("a drawing's cost on a page away from its units' origin", () => {
  it("is the same as on one that begins there", async () => {
    const body = '<rect width="100" height="100" fill-opacity="0.5"/>'.repeat(100);
    const { cost } = await read(documentOf(body));
    const elsewhere = await read(
      documentOf(`<g transform="translate(5000 -700)">${body}</g>`, 'viewBox="5000 -700 100 100"'),
    );
    expect(elsewhere.cost).toEqual(cost);
    expect(canDraw(cost, 4096, 4096)).toBe(canDraw(elsewhere.cost, 4096, 4096));
  });
});

describe("a drawing at which the renderer stops", () => {
  /** What is beside the page only within a mask is not told beforehand. */
  const TRAP = documentOf(
    `<mask id="m" maskUnits="userSpaceOnUse" width="999" height="999">${LETTER}${far('opacity="0.5"')}</mask><g mask="url(#m)">${LETTER}</g>`,
  );

  it("leaves the renderer able to draw the next, many times over", async () => {
    await readSvgFile(new TextEncoder().encode(documentOf(ON_PAGE)), "first.svg");
    const before = await draw(documentOf(ON_PAGE));
    for (let time = 0; time < 20; time++) {
      expect(() => renderSvg(TRAP, 64)).toThrow();
      expect(await draw(documentOf(ON_PAGE))).toEqual(before);
    }
  });

  it.each([
    ["mask", "mask"],
    ["pattern", "fill"],
  ])(
    "is refused by name where it is of parts too deep in one another, and leaves the renderer as well: %s",
    async (kind, asks) => {
      const levels = Array.from(
        { length: 2000 },
        (_, level) =>
          `<${kind} id="n${level + 1}" width="1" height="1"><rect width="9" height="9" ${asks}="url(#n${level})"/></${kind}>`,
      );
      const deep = documentOf(`${levels.join("")}<rect width="9" height="9" ${asks}="url(#n2000)"/>`);
      const before = await draw(documentOf(ON_PAGE));
      for (let time = 0; time < 5; time++) {
        await expect(read(deep)).rejects.toMatchObject({
          code: "bad-picture",
          reason: "undrawable",
          message: expect.stringMatching(/beside\.svg.*deep in one another/),
          hint: expect.stringMatching(/PNG/),
        });
      }
      expect(await draw(documentOf(ON_PAGE))).toEqual(before);
    },
  );
});
