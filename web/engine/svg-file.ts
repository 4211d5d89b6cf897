/**
 * An SVG file before it is drawn: told by its content, decoded, and checked against what a hostile one would do. Scripts
 * and addresses need no check: the renderer runs nothing and fetches nothing.
 */
import { badPicture } from "./picture-header.ts";
import { rasterSize } from "./raster-size.ts";
import { EMOJI, readShippedFont, SHIPPED_FONTS, type ShippedFontId, standIn } from "./shipped-fonts.ts";
import { withoutBeside } from "./svg-beside.ts";
import { canDraw, canFilter, costOf, type SvgCost } from "./svg-cost.ts";
import { elementsOf } from "./svg-elements.ts";
import { checkInnerPictures, costOfInner } from "./svg-inside.ts";
import { checkGrowth } from "./svg-limits.ts";
import { isTrap, readSvg, type SvgDocument, type SvgFonts, startSvgRenderer } from "./svg-renderer.ts";
import { withoutHalfSize } from "./svg-size.ts";
import { encodingOf } from "./svg-start.ts";
import { isEmoji } from "./text-emoji.ts";
import { isInvisible, scriptOf } from "./text-script.ts";

export interface SvgFile {
  readonly name: string;
  /** As it is to be drawn. */
  readonly svg: string;
  /** As the document gives them, CSS pixels; by them it keeps its proportions. */
  readonly width: number;
  readonly height: number;
  /** Fonts for the words in it; none without. */
  readonly fonts: readonly ShippedFontId[];
  readonly cost: SvgCost;
}

const MAX_BYTES = 16 * 2 ** 20;
/** What the renderer leaves out; a picture at an address it writes out as "raw", one with data by its type. */
const UNDRAWN = /<(?:[\w-]+:)?(?:foreignObject|image)\b/;
/** How Inkscape has its arrowheads follow their lines. The renderer does not know it, and lets each point to the right. */
const REVERSED_AT_START = /(\sorient\s*=\s*["'])auto-start-reverse(["'])/g;
/** Longer side by shorter. */
const MAX_ASPECT = 1000;
const HINT = "Open it in a drawing program and save it again as plain SVG.";
const AS_PNG = "Open it in a drawing program and save it again as plain SVG, or as PNG.";

/**
 * Reads an SVG file. Rejects with "bad-picture" naming the file: too large, not UTF-8 or UTF-16, not well-formed, without a
 * size, with nothing that can be drawn, growing beyond all measure by what it reuses, entities or pictures inside, or taking
 * as long to draw.
 *
 * @param readFont for its words; rejects with "missing-file"
 */
export async function readSvgFile(
  bytes: Uint8Array,
  name: string,
  readFont: (id: ShippedFontId) => Promise<Uint8Array> = readShippedFont,
): Promise<SvgFile> {
  if (bytes.length > MAX_BYTES) {
    throw badPicture(
      name,
      "too-many-bytes",
      `it has ${bytes.length} bytes, and ${MAX_BYTES} is the most for SVG`,
      "Make it simpler.",
    );
  }
  const svg = withoutHalfSize(decode(bytes, name)).replace(REVERSED_AT_START, "$1auto$2");
  checkGrowth(svg, name);
  checkInnerPictures(svg, name);
  await startSvgRenderer();
  const fonts = fontsOf(svg);
  const buffers = await Promise.all(fonts.map((id) => readFont(id)));
  const { width, height, simplified } = readDocument(svg, svgFonts(buffers), name);
  const aspect = width / height;
  if (!(aspect <= MAX_ASPECT && aspect >= 1 / MAX_ASPECT)) {
    throw badPicture(
      name,
      "too-long",
      `it is ${width} × ${height}, which is more than ${MAX_ASPECT} times as long as wide`,
      HINT,
    );
  }
  const elements = elementsOf(simplified);
  const isBlank = !elements.elements.some(
    ({ definition, outline, attributes }) =>
      definition === "" && (outline !== null || /^data:image\/(?!raw)/.test(attributes.get("href") ?? "")),
  );
  if (isBlank && UNDRAWN.test(svg)) {
    const problem = "it holds nothing that can be drawn: parts of web pages and pictures at addresses are left out";
    throw badPicture(name, "nothing-drawn", problem, AS_PNG);
  }
  const cost = costOf(elements, (data) => costOfInner(data, name));
  const [leastWidth, leastHeight] = rasterSize(aspect, [1, 1]);
  if (!canDraw(cost, leastWidth, leastHeight)) {
    const what = canFilter(cost, leastWidth, leastHeight) ? "it" : "its filters";
    throw badPicture(name, "too-slow", `${what} would take too long to draw`, "Make it simpler, or save it as PNG.");
  }
  const onPage = withoutBeside(simplified, elements);
  if (onPage !== null) return { name, svg: onPage, width, height, fonts: [], cost };
  return { name, svg, width, height, fonts, cost };
}

function decode(bytes: Uint8Array, name: string): string {
  try {
    return new TextDecoder(encodingOf(bytes), { fatal: true }).decode(bytes);
  } catch (cause) {
    throw badPicture(name, "encoding", "its text is neither UTF-8 nor UTF-16", HINT, cause);
  }
}

function readDocument(svg: string, fonts: SvgFonts | null, name: string): SvgDocument {
  try {
    return readSvg(svg, fonts);
  } catch (thrown) {
    throw badPicture(name, ...describeFault(thrown, svg), thrown);
  }
}

/** What resvg says, without its own introduction, between the reason of the error and what to do. */
export function describeFault(thrown: unknown, svg: string): readonly [reason: string, problem: string, hint: string] {
  if (isTrap(thrown))
    return ["undrawable", "the renderer stops at it, with parts far beside its page or deep in one another", AS_PNG];
  const said = thrown instanceof Error ? thrown.message : String(thrown);
  const cause = said.replace(/^SVG data parsing failed cause /, "");
  if (/reference loop/.test(cause)) return ["entities", "its entities grow beyond all measure", HINT];
  if (/nodes limit/.test(cause)) return ["too-slow", "it has too many elements", HINT];
  // So is a drawing that was copied out of a web page, which takes it for what it is without. One that is cut short has no root, either.
  if (/root node/.test(cause) && !/\sxmlns\b/.test(svg))
    return ["no-namespace", `it has no xmlns="http://www.w3.org/2000/svg"`, HINT];
  if (/invalid size/.test(cause)) return ["no-size", "it has no width and height above 0", HINT];
  return cause === said
    ? ["undrawable", `it cannot be drawn (${said})`, AS_PNG]
    : ["not-well-formed", `it is not well-formed: ${cause}`, HINT];
}

/** A character by its number: "&#x1f382;", "&#127874;". */
const NUMBERED = /&#(?:x([\da-f]{1,8})|(\d{1,8}));/gi;
const MOST_CODE = 0x10ffff;

/** The fonts that the words of a document may need. Which characters are words and which are markup does not matter. */
function fontsOf(svg: string): ShippedFontId[] {
  if (!/<(?:[\w-]+:)?text[\s>]/.test(svg)) return [];
  const scripts = new Set<string>();
  for (const character of svg.replace(NUMBERED, (whole, hex, decimal) => {
    const code = hex === undefined ? Number(decimal) : Number.parseInt(hex, 16);
    return code <= MOST_CODE ? String.fromCodePoint(code) : whole;
  })) {
    if (character < "\u0250" || isInvisible(character)) continue;
    const script = isEmoji(character) ? EMOJI : scriptOf(character);
    if (script !== null) scripts.add(script);
  }
  const fonts = new Set<ShippedFontId>(["inter-400", "inter-700"]);
  for (const script of scripts) for (const weight of [400, 700] as const) fonts.add(standIn(script, weight));
  return [...fonts];
}

/** What the renderer is given for the words of a document; null without any. */
export const svgFonts = (buffers: readonly Uint8Array[]): SvgFonts | null =>
  buffers.length === 0 ? null : { buffers, family: SHIPPED_FONTS["inter-400"].name };
