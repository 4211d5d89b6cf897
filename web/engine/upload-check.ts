/**
 * A picture before anything is made of it: what it is by its content, how large by its header, and safe to keep and to hand on.
 * The same in the page and in a shop's server.
 */

import { TexelcastError } from "../core/texelcast-error.ts";
import { mentionsColors } from "./color-mention.ts";
import { checkJpegScans } from "./jpeg-scans.ts";
import { readPictureHeader } from "./picture-header.ts";
import { withoutMetadata } from "./picture-metadata.ts";
import { cleanSvg } from "./svg-safety.ts";
import { isSvg } from "./svg-start.ts";

export interface UploadLimits {
  /** Of the file; default 20 MiB. */
  readonly bytes?: number;
  /** Millions of pixels; default 64. */
  readonly megapixels?: number;
}

export interface CheckedPicture {
  readonly type: "image/png" | "image/jpeg" | "image/webp" | "image/avif" | "image/svg+xml";
  /** Without metadata. */
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Pixels, upright; of a drawing what its first tag says, 0 where that says nothing. */
  readonly width: number;
  readonly height: number;
}

export const UPLOAD_LIMITS = { bytes: 20 * 2 ** 20, megapixels: 64 } as const;

/**
 * Checks a picture and takes its metadata away but what shows; decodes nothing.
 *
 * Rejects with "too-large" (bytes or pixels), "unsafe-file" (a drawing with scripts), "bad-picture" (neither PNG, JPEG, WebP, AVIF nor
 * SVG, damaged, cut short, CMYK, animated, a colour profile by tables), each naming the file and saying what to do.
 */
export async function checkUpload(name: string, bytes: Uint8Array, limits: UploadLimits = {}): Promise<CheckedPicture> {
  const { bytes: mostBytes = UPLOAD_LIMITS.bytes, megapixels = UPLOAD_LIMITS.megapixels } = limits;
  if (bytes.length > mostBytes) {
    const has = `it has ${(bytes.length / 2 ** 20).toFixed(1)} MiB, and ${(mostBytes / 2 ** 20).toFixed(1)} is the most`;
    throw tooLarge(name, has, String(bytes.length));
  }
  if (isSvg(bytes)) {
    const clean = cleanSvg(bytes, name);
    return { type: "image/svg+xml", bytes: clean, ...drawingSize(clean) };
  }
  const { format, width, height, orientation } = await readPictureHeader(bytes, name);
  if (format === "jpeg") checkJpegScans(bytes, name);
  if (width * height > megapixels * 1e6) {
    const has = `it has ${width} × ${height} pixels (${((width * height) / 1e6).toFixed(1)} megapixels), and ${megapixels} megapixels is the most`;
    throw tooLarge(name, has, `${width} × ${height}`);
  }
  const turned = orientation >= 5;
  const colors = mentionsColors(bytes)
    ? await (await import("./picture-profile.ts")).keptColors(format, bytes, name)
    : null;
  return {
    type: `image/${format}`,
    bytes: await withoutMetadata(format, bytes, { orientation, colors }),
    width: turned ? height : width,
    height: turned ? width : height,
  };
}

const tooLarge = (name: string, has: string, value: string): TexelcastError =>
  new TexelcastError("too-large", `The picture “${name}” is too large: ${has}.`, {
    subject: name,
    value,
    hint: "Make it smaller and try again.",
  });

function drawingSize(svg: Uint8Array): { width: number; height: number } {
  const tag = /<(?:[\w-]+:)?svg\b[^>]*>/i.exec(new TextDecoder().decode(svg.subarray(0, 16384)))?.[0] ?? "";
  const number = (name: string): number =>
    Number(new RegExp(`\\s${name}\\s*=\\s*["']\\s*([\\d.]+)[^%]*?["']`).exec(tag)?.[1] ?? 0);
  const [, , wide = 0, high = 0] = (/\sviewBox\s*=\s*["']([^"']*)/.exec(tag)?.[1] ?? "")
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  // Both of one origin: an icon that tells its height alone, as "1em", is no line.
  const size = { width: number("width"), height: number("height") };
  if (!(size.width && size.height)) Object.assign(size, { width: wide || size.width, height: high || size.height });
  return Number.isFinite(size.width) && Number.isFinite(size.height) ? size : { width: 0, height: 0 };
}
