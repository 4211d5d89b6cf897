/**
 * A texture of any size, painted by windows and given out in bands of rows: never more of it at once than a window and a
 * band. A window has the very texels of the whole but near its borders, so it is painted with a margin that is thrown away.
 */
import { MAX_SIZE } from "../core/sizes.ts";
import type { BasePicture } from "./base-picture.ts";
import { nextTurn } from "./event-loop.ts";
import type { OpenTarget } from "./open-target.ts";
import type { Size } from "./print-size.ts";
import { drawWhole, type PrintContext, withTarget } from "./print-target.ts";
import type { RasterTarget } from "./raster-size.ts";
import type { TexelRect } from "./zone-clip.ts";

/** Textures of this many texels are painted in one piece, where the core's targets are as long. */
const WHOLE_TEXELS = 4096 * 4096;
/** Side of a window without its margin, texels. */
const WINDOW_SIDE = 2048;
/** The core's tiles: windows begin where one does. */
const TILE = 16;

export interface PrintRaster {
  readonly material: number;
  readonly size: Size;
  readonly base: BasePicture;
  readonly raster: RasterTarget;
  /** The part that is wanted. */
  readonly rect: TexelRect;
  /** Place of a zone in the list: all outside of it and its bleed turns transparent. Null: everything stays. */
  readonly zone: number | null;
  /** Side of the windows; for tests. By default one as large as the texture, where that is not too large. */
  readonly windowSide?: number | undefined;
}

/** Calls `take` with band after band of the rectangle, top down: RGBA, straight alpha, rows packed. */
export async function paintBands(
  context: PrintContext,
  print: PrintRaster,
  take: (rows: Uint8Array) => void | Promise<void>,
): Promise<void> {
  const [width, height] = print.size;
  const { rect } = print;
  const longer = Math.max(width, height);
  const isWhole = width * height <= WHOLE_TEXELS && longer <= MAX_SIZE;
  const side = print.windowSide ?? (isWhole ? longer : WINDOW_SIDE);
  const margin = side >= longer ? 0 : marginOf(print.size);
  for (let top = rect.y; top < rect.y + rect.height; top += side) {
    const rows = Math.min(side, rect.y + rect.height - top);
    const band = new Uint8Array(rect.width * rows * 4);
    for (let left = rect.x; left < rect.x + rect.width; left += side) {
      const columns = Math.min(side, rect.x + rect.width - left);
      const inner = { x: left, y: top, width: columns, height: rows };
      await paintWindow(context, print, inner, margin, band);
      const share = (left + columns - rect.x) / rect.width;
      context.onProgress?.((top - rect.y + rows * share) / rect.height);
      await nextTurn();
      context.checkpoint();
    }
    await take(band);
  }
}

/** Further than colour bleeds, and gutters reach, from beyond a window's border (texelcast.h). */
function marginOf([width, height]: Size): number {
  const longer = Math.max(width, height);
  const bleed = Math.max(16, Math.floor(longer / 64));
  const gutter = Math.max(2, Math.floor((longer * 2 + 512) / 1024));
  return Math.ceil((bleed + gutter + 2) / TILE) * TILE;
}

async function paintWindow(
  context: PrintContext,
  print: PrintRaster,
  inner: TexelRect,
  margin: number,
  band: Uint8Array,
): Promise<void> {
  const [textureWidth, textureHeight] = print.size;
  const whole = margin === 0;
  const windowX = whole ? 0 : Math.max(0, Math.floor((inner.x - margin) / TILE) * TILE);
  const windowY = whole ? 0 : Math.max(0, Math.floor((inner.y - margin) / TILE) * TILE);
  // Whole tiles on this side, too: a tile that a window cuts through would be painted in other steps.
  const reach = (end: number, most: number): number => Math.min(most, Math.ceil((end + margin) / TILE) * TILE);
  const width = whole ? textureWidth : reach(inner.x + inner.width, textureWidth) - windowX;
  const height = whole ? textureHeight : reach(inner.y + inner.height, textureHeight) - windowY;
  const window = { textureWidth, textureHeight, windowX, windowY, base: print.base, raster: print.raster };
  await withTarget(context, { material: print.material, width, height }, window, (target) => {
    drawWhole(context, target);
    copyRows(target, print, inner, { x: windowX, y: windowY, width, height }, band);
  });
}

/** Most texels that are copied out of the core at once. */
const COPY_TEXELS = 1 << 21;

function copyRows(
  target: OpenTarget,
  { rect, zone }: PrintRaster,
  inner: TexelRect,
  window: TexelRect,
  band: Uint8Array,
): void {
  const rowsAtOnce = Math.max(1, Math.floor(COPY_TEXELS / window.width));
  for (let done = 0; done < inner.height; done += rowsAtOnce) {
    const count = Math.min(rowsAtOnce, inner.height - done);
    const row = inner.y - window.y + done;
    const texels = target.core.readBled(row, count, window.width);
    const cover = zone === null ? null : target.core.zoneMask(zone, row, count);
    for (let y = 0; y < count; y++) {
      const from = y * window.width + inner.x - window.x;
      const to = (done + y) * rect.width + inner.x - rect.x;
      band.set(texels.subarray(from * 4, (from + inner.width) * 4), to * 4);
      if (cover === null) continue;
      for (let x = 0; x < inner.width; x++) {
        const alpha = (to + x) * 4 + 3;
        band[alpha] = Math.round(((band[alpha] as number) * (cover[from + x] as number)) / 255);
      }
    }
  }
}
