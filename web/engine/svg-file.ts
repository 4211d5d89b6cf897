/**
 * An SVG file before it is drawn: told by its content, decoded, and checked against what a hostile one would do. Scripts
 * and addresses need no check: the renderer runs nothing and fetches nothing.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { badPicture, readPictureHeader } from "./picture-header.ts";
import { rasterSize } from "./raster-size.ts";
import { readShippedFont, SHIPPED_FONTS, type ShippedFontId, standIn } from "./shipped-fonts.ts";
import { canFilter, type FilterUse, filterUses } from "./svg-cost.ts";
import { type SvgFonts, simplifiedSvg, startSvgRenderer, svgSize } from "./svg-renderer.ts";
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
  readonly filters: readonly FilterUse[];
}

const MAX_BYTES = 16 * 2 ** 20;
/** Characters that entities may grow to; drawing programs name a few namespaces with them. */
const MAX_ENTITY_GROWTH = 2 ** 20;
/** Of all pictures inside it. */
const MAX_INNER_PIXELS = 64 * 2 ** 20;
/** Longer side by shorter. */
const MAX_ASPECT = 1000;
/** References may spell any word. */
const MAY_FILTER = /filter|data:image\/svg|&#|<!ENTITY/i;
const HINT = "Open it in a drawing program and save it again as plain SVG.";

/**
 * Reads an SVG file. Rejects with "bad-picture" naming the file: too large, not UTF-8 or UTF-16, not well-formed, without a
 * size, with entities or pictures inside that grow beyond all measure, or with filters that take as long.
 *
 * @param readFont for words that filters go over; rejects with "missing-file"
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
  checkEntities(svg, name);
  checkInnerPictures(svg, name);
  await startSvgRenderer();
  const { width, height } = readSize(svg, name);
  const aspect = width / height;
  if (!(aspect <= MAX_ASPECT && aspect >= 1 / MAX_ASPECT)) {
    throw badPicture(name, `it is ${width} × ${height}, which is more than ${MAX_ASPECT} times as long as wide`, HINT);
  }
  const fonts = fontsOf(svg);
  const simplified = MAY_FILTER.test(svg)
    ? simplifiedSvg(svg, svgFonts(await Promise.all(fonts.map((id) => readFont(id)))))
    : "";
  checkInnerDrawings(simplified, name);
  const filters = filterUses(simplified);
  const [leastWidth, leastHeight] = rasterSize(aspect, [1, 1]);
  if (!canFilter(filters, leastWidth, leastHeight)) {
    throw badPicture(name, "its filters would take too long to draw", "Make them simpler, or save it as PNG.");
  }
  return { name, svg, width, height, fonts, filters };
}

function decode(bytes: Uint8Array, name: string): string {
  try {
    return new TextDecoder(encodingOf(bytes), { fatal: true }).decode(bytes);
  } catch (cause) {
    throw badPicture(name, "its text is neither UTF-8 nor UTF-16", HINT, cause);
  }
}

function checkEntities(svg: string, name: string): void {
  let growth = 0;
  for (const [, entity = "", , value = ""] of svg.matchAll(/<!ENTITY\s+([^\s"'>]+)\s+(["'])(.*?)\2/gs)) {
    if (/&[^#]/.test(value)) throw badPicture(name, `its entity “${entity}” is made of other entities`, HINT);
    growth += value.length * (svg.split(`&${entity};`).length - 1);
    if (growth > MAX_ENTITY_GROWTH) throw badPicture(name, "its entities grow beyond all measure", HINT);
  }
}

function checkInnerPictures(svg: string, name: string): void {
  let pixels = 0;
  for (const [, type = "", data = ""] of svg.matchAll(/data:image\/(png|jpe?g|webp|gif)[^,"']*,([^"']*)/gi)) {
    const inner = `${name}, picture inside`;
    // Its header, with the room that an EXIF block may take before it.
    const { width, height } = readHeaderLeniently(data, inner, type);
    pixels += width * height;
    if (pixels > MAX_INNER_PIXELS) {
      throw badPicture(name, `the pictures inside have more than ${MAX_INNER_PIXELS} pixels`, "Make them smaller.");
    }
  }
}

/** What filters inside a drawing inside would take is not told from outside, nor what it is where it is packed. */
function checkInnerDrawings(simplified: string, name: string): void {
  for (const [, data = ""] of simplified.matchAll(/data:image\/svg\+xml;base64,\s*([^"']*)/g)) {
    const inner = atob(data);
    if (inner.includes("<svg") && !hasFilters(inner)) continue;
    throw badPicture(
      name,
      "a drawing inside it has filters, or is packed",
      "Draw what is inside into the drawing itself.",
    );
  }
}

/** One that cannot be read is left out by the renderer. */
function hasFilters(svg: string): boolean {
  try {
    return simplifiedSvg(svg).includes("<filter");
  } catch {
    return false;
  }
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

function readSize(svg: string, name: string): { width: number; height: number } {
  try {
    return svgSize(svg);
  } catch (thrown) {
    if (thrown instanceof TexelcastError) throw thrown;
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
