import { describe, expect, it } from "vitest";
import { canDraw } from "../../web/engine/svg-cost.ts";
import { readSvgFile, type SvgFile } from "../../web/engine/svg-file.ts";
import { growthOf } from "../../web/engine/svg-growth.ts";
import { checkGrowth } from "../../web/engine/svg-limits.ts";
import { renderSvg } from "../../web/engine/svg-renderer.ts";
import { cleanSvg } from "../../web/engine/svg-safety.ts";

const documentOf = (body: string, before = ""): string =>
  `${before}<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 100 100">${body}</svg>`;
const read = (svg: string): Promise<SvgFile> => readSvgFile(new TextEncoder().encode(svg), "bomb.svg");
/** What is said of it. */
const refusalOf = (svg: string): Promise<string> =>
  read(svg).then(
    () => "it is taken",
    (thrown: unknown) => `${(thrown as { code?: string }).code}: ${(thrown as Error).message}`,
  );

const zigzag = (points: number): string =>
  `M${Array.from({ length: points }, (_, index) => `${index % 100} ${(index * 37) % 100}`).join(" ")}z`;
const CIRCLE = '<circle cx="50" cy="50" r="40" fill="none" stroke="red" stroke-width="5"';
const FULL = '<path id="a" d="M0 0h100v100H0z" fill="red" fill-opacity="0.5"/>';
const BIG = `<defs><path id="a" d="${zigzag(20_000)}"/></defs>`;
const USE = '<use xlink:href="#a"/>';

/** One in another, each ten times in the next. */
function nested(kind: "mask" | "pattern" | "clipPath", depth: number): string {
  const asks = { mask: "mask", pattern: "fill", clipPath: "clip-path" }[kind];
  const size = kind === "pattern" ? ' width="50" height="50" patternUnits="userSpaceOnUse"' : "";
  const of = (level: number): string => (level === 0 ? "" : ` ${asks}="url(#n${level - 1})"`);
  const levels = Array.from({ length: depth }, (_, level) => {
    const inside = `<rect width="90" height="90"${of(level)}/>`.repeat(10);
    return `<${kind} id="n${level}"${size}>${inside}</${kind}>`;
  });
  return documentOf(`${levels.join("")}<rect width="90" height="90"${of(depth)}/>`);
}

/** With rules of style in place of what attributes ask for. */
function styled(svg: string): string {
  let rules = "";
  const body = svg.replace(/ (mask)="(url\(#(n\d+)\))"/g, (_whole, name, value, id) => {
    rules += `g .${id}, .x{${name}:${value}}`;
    return ` class="a ${id}"`;
  });
  return body.replace(/(<svg[^>]*>)/, `$1<style>${[...new Set(rules.split("}"))].join("}")}</style>`);
}

describe("a drawing that would take for ever", () => {
  it.each([
    ["a circle of half a million dashes", documentOf(`${CIRCLE} stroke-dasharray="0.0002"/>`)],
    ["a circle of more dashes than are drawn at all", documentOf(`${CIRCLE} stroke-dasharray="0.00002"/>`)],
    ["masks in masks", nested("mask", 6)],
    ["patterns in patterns", nested("pattern", 6)],
    ["clip paths in clip paths", nested("clipPath", 6)],
    [
      "sixty thousand groups over the whole picture",
      documentOf('<g opacity="0.5"><path d="M0 0h99v99z"/></g>'.repeat(60_000)),
    ],
    ["a path of very many edges across the picture", documentOf(`<path d="${zigzag(800_000)}"/>`)],
    [
      "a drawing inside it of half a million dashes",
      documentOf(
        `<image width="9" height="9" href="data:image/svg+xml;base64,${btoa(documentOf(`${CIRCLE} stroke-dasharray="0.0002"/>`))}"/>`,
      ),
    ],
  ])("is refused by the file's name: %s", async (_what, svg) => {
    expect(await refusalOf(svg)).toMatch(/^bad-picture: .*bomb\.svg.*it would take too long to draw/);
  });

  it.each([
    ["a long path used many times", documentOf(BIG + USE.repeat(20_000))],
    ["the same, after a comment", documentOf(`<!-- ${"<g>'".repeat(3)} -->${BIG}${USE.repeat(20_000)}`)],
    ["the same, by an entity", documentOf(BIG + "&use;".repeat(20_000), `<!DOCTYPE svg [<!ENTITY use '${USE}'>]>`)],
    [
      "the same, after a document's type that ends late",
      documentOf(BIG + USE.repeat(20_000), "<!DOCTYPE svg PUBLIC '[' 'x' [ ]  >"),
    ],
    [
      "uses of uses",
      documentOf(
        `<g id="u0"><path d="M0 0h9v9z"/></g>${[1, 2, 3, 4, 5, 6, 7].map((level) => `<g id="u${level}">${`<use href="#u${level - 1}"/>`.repeat(10)}</g>`).join("")}`,
      ),
    ],
    ["masks in masks, and so on", nested("mask", 20)],
    ["the same, by styles", styled(nested("mask", 20))],
    ["patterns in patterns, and so on", nested("pattern", 20)],
    [
      "a marker on every point",
      documentOf(
        `<marker id="m"><path d="${zigzag(5000)}"/></marker><g style="m&#97;rker-mid:url(#m)"><path d="${zigzag(5000)}"/></g>`,
      ),
    ],
    [
      "markers on the points of markers",
      documentOf(
        `${[0, 1, 2].map((level) => `<marker id="m${level}"><path d="${zigzag(150)}" marker-mid="url(#m${level - 1})"/></marker>`).join("")}<path d="${zigzag(150)}" marker-mid="url(#m2)"/>`,
      ),
    ],
    [
      "dashes that many paths inherit",
      documentOf(`<g stroke-dasharray="${"1 ".repeat(50_000)}">${'<path d="M0 0h9"/>'.repeat(5000)}</g>`),
    ],
    [
      "a drawing inside it, packed as bytes",
      documentOf(`<image href="data:image/svg+xml;base64,${btoa(nested("mask", 20))}"/>`),
    ],
    [
      "a drawing inside it, as text",
      documentOf(`<image href="data:text/plain,${encodeURIComponent(nested("mask", 20))}"/>`),
    ],
    [
      "a drawing inside it, with references",
      documentOf(
        `<image href='data:image/svg+xml,${nested("mask", 20).replaceAll("<", "&lt;").replaceAll('"', "&#34;")}'/>`,
      ),
    ],
    ["a book's words", documentOf(`<text>${"word ".repeat(40_000)}</text>`)],
    [
      "stops of a gradient that many others take",
      documentOf(
        `<linearGradient id="g">${'<stop offset="0"/>'.repeat(5000)}</linearGradient>${'<linearGradient xlink:href="#g"/>'.repeat(5000)}`,
      ),
    ],
  ])("is refused before it is read where it grows beyond all measure: %s", async (_what, svg) => {
    expect(await refusalOf(svg)).toMatch(/^bad-picture: .*bomb\.svg.*beyond all measure/);
  });

  const many = (count: number, of: (index: number) => string): string =>
    Array.from({ length: count }, (_, index) => of(index)).join("");
  it.each([
    [
      "rules of style for very many elements",
      `<style>${many(20_000, (index) => `.a${index}{fill:red}`)}</style>${many(20_000, () => '<g class="b"/>')}`,
    ],
    ["very many rules for one element", `<style>${".a{fill:red}".repeat(60_000)}</style><g class="a"/>`],
    ["very many declarations", `<g style="${"fill:red;".repeat(60_000)}"/>`],
    ["very many attributes", `<g ${many(60_000, (index) => `a${index}=""`)}/>`],
    [
      "uses among very many elements",
      `${many(60_000, (index) => `<g id="i${index}"/>`)}${many(60_000, (index) => `<use href="#i${index}"/>`)}`,
    ],
    ["stops of one gradient", `<linearGradient id="g">${'<stop offset="0"/>'.repeat(100_000)}</linearGradient>`],
    ["words of very many runs of style", `<text>${"<tspan>a</tspan>".repeat(3000)}</text>`],
    [
      "the same, less of it and reused",
      `<defs><text id="a">${"<tspan>a</tspan>".repeat(1000)}</text></defs>${'<use href="#a"/>'.repeat(20)}`,
    ],
    [
      "letters on a path",
      `<path id="p" d="M0 0h9"/><text><textPath href="#p">${"a".repeat(100_000)}</textPath></text>`,
    ],
    [
      "letters on a path, after some that are not",
      `<path id="p" d="M0 0h9"/><text>a<textPath href="#p">a<tspan>${"a".repeat(100_000)}</tspan></textPath>a</text>`,
    ],
    ["comments and the like", `<desc>${"<![CDATA[a]]>".repeat(200_000)}</desc>`],
  ])("is refused before it is read where that would take as long: %s", async (_what, body) => {
    expect(await refusalOf(documentOf(body))).toMatch(
      /^bad-picture: .*bomb\.svg.*(too long to read|beyond all measure)/,
    );
  });
});

describe("the words of a drawing", () => {
  it.each([
    [
      "lines and words with places of their own",
      `<text>${'<tspan x="1" y="9">word <tspan>bold</tspan></tspan>\n'.repeat(2000)}</text>`,
    ],
    ["many texts", '<text x="1">a</text>'.repeat(5000)],
    ["a line of many colours", `<text>${'<tspan fill="red">ab</tspan>'.repeat(300)}</text>`],
    [
      "many short words on paths",
      `<path id="p" d="M0 0h9"/>${`<text><textPath href="#p">words on a path</textPath></text>`.repeat(1000)}`,
    ],
  ])("are taken where they are honest: %s", (_what, body) => {
    expect(() => checkGrowth(documentOf(body), "words.svg")).not.toThrow();
  });
});

describe("a drawing's cost", () => {
  it.each([
    ["a hundred shapes over the whole picture", documentOf(FULL + USE.repeat(100)), 2048],
    ["a thousand dashes", documentOf(`${CIRCLE} stroke-dasharray="0.125"/>`), 4096],
    [
      "five thousand dots in a mask",
      documentOf(
        `<mask id="m">${'<circle cx="9" cy="9" r="0.5"/>'.repeat(5000)}</mask><rect width="90" height="90" mask="url(#m)"/>`,
      ),
      4096,
    ],
    ["a pattern of many small tiles", nested("pattern", 1), 4096],
    [
      "a small shadow on each of a hundred letters",
      documentOf(
        `<filter id="s"><feDropShadow dx="1" dy="1" stdDeviation="1"/></filter>${'<rect width="4" height="6" filter="url(#s)"/>'.repeat(100)}`,
      ),
      4096,
    ],
  ])("leaves honest ones sharp: %s", async (_what, svg, pixels) => {
    expect(canDraw((await read(svg)).cost, pixels, pixels)).toBe(true);
  });

  it("is more for more pixels, and for more of the same", async () => {
    const pixelsOf = async (uses: number): Promise<number> => {
      const { cost } = await read(documentOf(`<g id="a" opacity="0.5">${FULL}</g>${USE.repeat(uses)}`));
      return [4096, 2048, 1024, 512, 256, 128, 64].find((pixels) => canDraw(cost, pixels, pixels)) ?? 0;
    };
    expect([await pixelsOf(1), await pixelsOf(100), await pixelsOf(1000), await pixelsOf(10_000)]).toEqual([
      4096, 1024, 256, 128,
    ]);
  });

  it("leaves out what lies beside the picture, and what asks for itself", async () => {
    const beside = documentOf(`<g transform="translate(200)">${FULL}</g>`);
    const { cost } = await read(
      documentOf(`<mask id="m" mask="url(#m)">${FULL}</mask><path d="M0 0h9" mask="url(#m)"/>`),
    );
    expect((await read(beside)).cost.shapes).toEqual({ perPixel: 0, perRow: 0, once: 0 });
    expect(canDraw(cost, 4096, 4096)).toBe(true);
  });

  it("takes each entity, comment and CDATA for what a reader of XML takes it", () => {
    const plain = growthOf(documentOf(FULL)).length;
    expect(growthOf(documentOf(`<!-- ${FULL} --><![CDATA[${FULL}]]><?x ${FULL}?>${FULL}`)).length).toBe(plain);
    expect(growthOf(documentOf(FULL, `<!DOCTYPE svg PUBLIC "]>" "a">`)).length).toBe(plain);
    expect(growthOf(documentOf("<text><![CDATA[ab]]></text>")).length).toBeGreaterThan(
      growthOf(documentOf("<text><!--ab--></text>")).length,
    );
  });

  it("does not keep the next drawing from being read", async () => {
    await expect(read(documentOf(BIG + USE.repeat(20_000)))).rejects.toThrow();
    const { svg } = await read(documentOf(FULL));
    expect(renderSvg(svg, 64).width).toBe(64);
  });
});

describe("the check of a drawing that is uploaded", () => {
  const check = (svg: string): string => new TextDecoder().decode(cleanSvg(new TextEncoder().encode(svg), "bomb.svg"));

  it.each([
    ["metadata", `<![CDATA[${"<metadata>".repeat(200_000)}]]>`],
    ["tags of metadata", `<!--${"<metadata ".repeat(200_000)}-->`],
    ["entities", `<![CDATA[${"<!ENTITY a ".repeat(200_000)}]]>`],
    ["comments", `<!--${"<!- ".repeat(200_000)}-->`],
  ])("takes no longer for very many %s that do not end", (_what, body) => {
    const checked = check(documentOf(body));
    expect(checked.startsWith("<svg")).toBe(true);
  });

  it("takes away metadata and comments, and nothing else", () => {
    const clean = check(
      documentOf(
        `<metadata/>a<metadata x="1">b<c/></metadata >d<!-- e -->f<metadata><metadata/>g</metadata><metadatas/>h<metadata>i`,
      ),
    );
    expect(clean).toBe(documentOf("adf<metadatas/>h<metadata>i"));
  });

  it.each([
    '<!ENTITY a SYSTEM "x">',
    '<!ENTITY b "c"><!ENTITY a "<g/>">',
    "<!ENTITY a '&#60;g/>'>",
    "<!ENTITY a PUBLIC",
  ])("refuses an entity that stands for markup or another file: %s", (entity) => {
    expect(() => check(documentOf("", `<!DOCTYPE svg [${entity}]>`))).toThrow(/an entity that stands for markup/);
  });
});
