/**
 * An SVG file before it is drawn: told by its content, decoded, and checked against what a hostile one would do. Scripts
 * and addresses need no check: the renderer runs nothing and fetches nothing.
 */
import { badPicture, readPictureHeader } from "./picture-header.ts";
import { rasterSize } from "./raster-size.ts";
import { readShippedFont, SHIPPED_FONTS, type ShippedFontId, standIn } from "./shipped-fonts.ts";
import { canDraw, canFilter, costOf, type SvgCost } from "./svg-cost.ts";
import { growthOf } from "./svg-growth.ts";
import { readSvg, type SvgDocument, type SvgFonts, startSvgRenderer } from "./svg-renderer.ts";
import { NO_SHAPES, type ShapeCost } from "./svg-shapes.ts";
import { encodingOf } from "./svg-start.ts";
import { isInvisible, scriptOf } from "./text-script.ts";

export interface SvgFile {
  readonly name: string;
  readonly svg: string;
  /** As the document gives them, CSS pixels; by them it keeps its proportions. */
  readonly width: number;
  readonly height: number;
  /** Fonts for the words in it; none without. */
  readonly fonts: readonly ShippedFontId[];
  readonly cost: SvgCost;
}

const MAX_BYTES = 16 * 2 ** 20;
/** Characters that entities may grow to; drawing programs name a few namespaces with them. */
const MAX_ENTITY_GROWTH = 2 ** 20;
/** What stands before the comma is short; without an end to it, many would each be looked for in all that follows. */
const INNER_PICTURE = /data:image\/(png|jpe?g|webp|gif)[^,"']{0,200},([^"']*)/i;
/** Of all pictures inside it. */
const MAX_INNER_PIXELS = 64 * 2 ** 20;
/** Characters that it may grow to by what it reuses, and by its words. */
const MAX_LENGTH = 32 * 2 ** 20;
/** Elements, by all that asks for them. */
const MAX_VISITS = 1e7;
/** Of rules of style with elements, and the like. */
const MAX_COMPARISONS = 1e9;
/** Longer side by shorter. */
const MAX_ASPECT = 1000;
/** Of pictures inside, for each of their pixels: as of svg-cost.ts. */
const INNER_PIXEL = 5;
const HINT = "Open it in a drawing program and save it again as plain SVG.";

/**
 * Reads an SVG file. Rejects with "bad-picture" naming the file: too large, not UTF-8 or UTF-16, not well-formed, without a
 * size, growing beyond all measure by what it reuses, entities or pictures inside, or taking as long to draw.
 *
 * @param readFont for its words; rejects with "missing-file"
 */
export async function readSvgFile(
  bytes: Uint8Array,
  name: string,
  readFont: (id: ShippedFontId) => Promise<Uint8Array> = readShippedFont,
): Promise<SvgFile> {
  if (bytes.length > MAX_BYTES) {
    throw badPicture(name, `it has ${bytes.length} bytes, and ${MAX_BYTES} is the most for SVG`, "Make it simpler.");
  }
  const svg = decode(bytes, name);
  checkGrowth(withEntities(svg, name), name);
  checkInnerPictures(svg, name);
  await startSvgRenderer();
  const fonts = fontsOf(svg);
  const buffers = await Promise.all(fonts.map((id) => readFont(id)));
  const { width, height, simplified } = readDocument(svg, svgFonts(buffers), name);
  const aspect = width / height;
  if (!(aspect <= MAX_ASPECT && aspect >= 1 / MAX_ASPECT)) {
    throw badPicture(name, `it is ${width} × ${height}, which is more than ${MAX_ASPECT} times as long as wide`, HINT);
  }
  const cost = costOf(simplified, (data) => costOfInner(data, name));
  const [leastWidth, leastHeight] = rasterSize(aspect, [1, 1]);
  if (!canDraw(cost, leastWidth, leastHeight)) {
    const what = canFilter(cost, leastWidth, leastHeight) ? "it" : "its filters";
    throw badPicture(name, `${what} would take too long to draw`, "Make it simpler, or save it as PNG.");
  }
  return { name, svg, width, height, fonts, cost };
}

function decode(bytes: Uint8Array, name: string): string {
  try {
    return new TextDecoder(encodingOf(bytes), { fatal: true }).decode(bytes);
  } catch (cause) {
    throw badPicture(name, "its text is neither UTF-8 nor UTF-16", HINT, cause);
  }
}

/** The document with what its entities stand for in their places. */
function withEntities(svg: string, name: string): string {
  const entities = new Map<string, string>();
  for (const [, entity = "", , value = ""] of svg.matchAll(/<!ENTITY\s+([^\s"'>]+)\s+(["'])(.*?)\2/gs)) {
    if (/&[^#]/.test(value)) throw badPicture(name, `its entity “${entity}” is made of other entities`, HINT);
    if (!entities.has(entity)) entities.set(entity, value);
  }
  if (entities.size === 0) return svg;
  let growth = 0;
  return svg.replace(/&([^\s&;#]+);/g, (reference, entity: string) => {
    const value = entities.get(entity) ?? reference;
    growth += value.length;
    if (growth > MAX_ENTITY_GROWTH) throw badPicture(name, "its entities grow beyond all measure", HINT);
    return value;
  });
}

function checkGrowth(svg: string, name: string): void {
  const { length, visits, comparisons } = growthOf(svg);
  if (length > MAX_LENGTH || visits > MAX_VISITS) {
    throw badPicture(name, "with all that it reuses, and its words, it grows beyond all measure", "Make it simpler.");
  }
  if (comparisons > MAX_COMPARISONS) {
    throw badPicture(name, "it would take too long to read: too much in it is styled or reused", HINT);
  }
}

function checkInnerPictures(svg: string, name: string): void {
  let pixels = 0;
  for (const [, type = "", data = ""] of svg.matchAll(new RegExp(INNER_PICTURE, "gi"))) {
    const inner = `${name}, picture inside`;
    // Its header, with the room that an EXIF block may take before it.
    const { width, height } = readHeaderLeniently(data, inner, type);
    pixels += width * height;
    if (pixels > MAX_INNER_PIXELS) {
      throw badPicture(name, `the pictures inside have more than ${MAX_INNER_PIXELS} pixels`, "Make them smaller.");
    }
  }
}

/**
 * Of a picture or drawing inside. One that cannot be read is left out by the renderer. What filters inside a drawing inside
 * would take is not told from outside, nor what it is where it is packed: rejected.
 */
function costOfInner(data: string, name: string): ShapeCost {
  const [, drawing] = /^data:image\/svg\+xml;base64,\s*([^"']*)/.exec(data) ?? [];
  if (drawing === undefined) {
    const [, type = "", picture = ""] = INNER_PICTURE.exec(data) ?? [];
    if (picture === "") return NO_SHAPES;
    const { width, height } = readHeaderLeniently(picture, `${name}, picture inside`, type);
    return { ...NO_SHAPES, once: INNER_PIXEL * width * height };
  }
  const inner = atob(drawing);
  const cost = inner.includes("<svg") ? costOfDrawing(inner, name) : null;
  if (cost?.filters.length === 0) return cost.shapes;
  throw badPicture(
    name,
    "a drawing inside it has filters, or is packed",
    "Draw what is inside into the drawing itself.",
  );
}

function costOfDrawing(svg: string, name: string): SvgCost {
  checkGrowth(withEntities(svg, name), name);
  let simplified = "";
  try {
    ({ simplified } = readSvg(svg));
  } catch {}
  return costOf(simplified, () => NO_SHAPES);
}

/** A picture that cannot be read is left out by the renderer, so that only sizes matter here. */
function readHeaderLeniently(data: string, name: string, type: string): { width: number; height: number } {
  let bytes: Uint8Array;
  try {
    bytes = Uint8Array.from(atob(decodeURIComponent(data).replace(/\s+/g, "")), (byte) => byte.charCodeAt(0));
  } catch {
    return { width: 0, height: 0 };
  }
  if (type.toLowerCase() === "gif") {
    const [a = 0, b = 0, c = 0, d = 0] = bytes.subarray(6, 10);
    return { width: a + 256 * b, height: c + 256 * d };
  }
  return readPictureHeader(bytes, name);
}

function readDocument(svg: string, fonts: SvgFonts | null, name: string): SvgDocument {
  try {
    return readSvg(svg, fonts);
  } catch (thrown) {
    throw badPicture(name, describeFault(thrown), HINT, thrown);
  }
}

/** What resvg says, without its own introduction. */
export function describeFault(thrown: unknown): string {
  const said = thrown instanceof Error ? thrown.message : String(thrown);
  const cause = said.replace(/^SVG data parsing failed cause /, "");
  if (/reference loop/.test(cause)) return "its entities grow beyond all measure";
  if (/nodes limit/.test(cause)) return "it has too many elements";
  if (/invalid size/.test(cause)) return "it has no width and height above 0";
  return cause === said ? `it cannot be drawn (${said})` : `it is not well-formed: ${cause}`;
}

/** The fonts that the words of a document may need. Which characters are words and which are markup does not matter. */
function fontsOf(svg: string): ShippedFontId[] {
  if (!/<(?:[\w-]+:)?text[\s>]/.test(svg)) return [];
  const scripts = new Set<string>();
  for (const character of svg) {
    if (character < "\u0250" || isInvisible(character)) continue;
    const script = scriptOf(character);
    if (script !== null) scripts.add(script);
  }
  const fonts = new Set<ShippedFontId>(["inter-400", "inter-700"]);
  for (const script of scripts) for (const weight of [400, 700] as const) fonts.add(standIn(script, weight));
  return [...fonts];
}

/** What the renderer is given for the words of a document; null without any. */
export const svgFonts = (buffers: readonly Uint8Array[]): SvgFonts | null =>
  buffers.length === 0 ? null : { buffers, family: SHIPPED_FONTS["inter-400"].name };
