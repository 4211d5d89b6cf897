/** Pictures and drawings inside an SVG. */
import type { TexelcastError } from "../core/texelcast-error.ts";
import { readJpegHeader } from "./jpeg-header.ts";
import { checkJpegScans } from "./jpeg-scans.ts";
import { badPicture, checkedHeader, sniffPicture } from "./picture-header.ts";
import { readPngHeader } from "./png-header.ts";
import { costOf, type SvgCost } from "./svg-cost.ts";
import { elementsOf } from "./svg-elements.ts";
import { readSvg } from "./svg-renderer.ts";
import { NO_SHAPES, type ShapeCost } from "./svg-shapes.ts";
import { unknownPicture } from "./unknown-picture.ts";
import { readWebpHeader } from "./webp-header.ts";

/** What stands before the comma is short; without an end to it, many would each be looked for in all that follows. */
const INNER_PICTURE = /data:image\/(png|jpe?g|webp|avif|gif)[^,"']{0,200},([^"']*)/i;
const HEADERS = { png: readPngHeader, jpeg: readJpegHeader, webp: readWebpHeader } as const;
/** Of all pictures inside it. */
const MAX_INNER_PIXELS = 64 * 2 ** 20;
/** Of pictures inside, for each of their pixels: as of svg-cost.ts. */
const INNER_PIXEL = 5;

/** The drawing that an address with data holds; null where it is none. Throws "bad-picture" where it is packed. */
export function drawingIn(address: string, name: string): string | null {
  const comma = address.indexOf(",");
  const head = address.slice(0, comma);
  let text = "";
  try {
    const data = decodeURIComponent(
      address.slice(comma + 1).replace(/&(?:(lt|gt|quot|apos|amp)|#(\d+)|#x([0-9a-f]+));/gi, spellOut),
    );
    text = /;\s*base64\s*$/i.test(head) ? atob(data.replace(/\s+/g, "")) : data;
  } catch {}
  if (text.includes("<svg")) return text;
  if (!/^data:image\/svg/i.test(head) && !text.startsWith("\x1f\x8b")) return null;
  throw innerFault(name);
}

const NAMED: Readonly<Record<string, string>> = { lt: "<", gt: ">", quot: '"', apos: "'", amp: "&" };
function spellOut(reference: string, named?: string, decimal?: string, hex?: string): string {
  if (named !== undefined) return NAMED[named] ?? reference;
  const code = hex === undefined ? Number(decimal) : Number.parseInt(hex, 16);
  return code < 0x80 ? String.fromCharCode(code) : reference;
}

const innerFault = (name: string): TexelcastError =>
  badPicture(
    name,
    "inner-drawing",
    "a drawing inside it has filters, or is packed",
    "Draw what is inside into the drawing itself.",
  );

/** Throws "bad-picture" naming the file where pictures inside have too many pixels. */
export function checkInnerPictures(svg: string, name: string): void {
  let pixels = 0;
  for (const [, type = "", data = ""] of svg.matchAll(new RegExp(INNER_PICTURE, "gi"))) {
    const inner = `${name}, picture inside`;
    // Its header, with the room that an EXIF block may take before it.
    const { width, height } = readHeaderLeniently(data, inner, type);
    pixels += width * height;
    if (pixels > MAX_INNER_PIXELS) {
      throw badPicture(
        name,
        "inner-pixels",
        `the pictures inside have more than ${MAX_INNER_PIXELS} pixels`,
        "Make them smaller.",
      );
    }
  }
}

/**
 * Of a picture or drawing inside, by its address with data. Throws "bad-picture" where a drawing has filters: what they would
 * take is not told from outside.
 */
export function costOfInner(data: string, name: string): ShapeCost {
  if (!data.startsWith("data:image/svg")) return costOfPicture(data, name);
  const inner = drawingIn(data, name);
  const { filters, shapes } = inner === null ? { filters: [], shapes: NO_SHAPES } : costOfDrawing(inner, name);
  if (filters.length > 0) throw innerFault(name);
  return shapes;
}

/** One that cannot be read is left out by the renderer, as are drawings in it. */
function costOfDrawing(svg: string, name: string): SvgCost {
  let simplified = "";
  try {
    ({ simplified } = readSvg(svg));
  } catch {}
  return costOf(elementsOf(simplified), (data) => costOfPicture(data, name));
}

function costOfPicture(data: string, name: string): ShapeCost {
  const [, type = "", picture = ""] = INNER_PICTURE.exec(data) ?? [];
  if (picture === "") return NO_SHAPES;
  const { width, height } = readHeaderLeniently(picture, `${name}, picture inside`, type);
  return { ...NO_SHAPES, once: INNER_PIXEL * width * height };
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
  const format = sniffPicture(bytes);
  if (format === null) throw unknownPicture(bytes, name);
  if (format === "avif") {
    const hint = "Put a PNG, JPEG or WebP into the drawing instead.";
    throw badPicture(name, "inner-avif", "it is an AVIF picture, which a drawing cannot show", hint);
  }
  const header = checkedHeader(format, HEADERS[format], bytes, name);
  if (header.format === "jpeg") checkJpegScans(bytes, name);
  return header;
}
