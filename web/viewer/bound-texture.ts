/**
 * One target in the texture view: its picture, its outlines and the chart that is lit, on the GPU, and what is kept beside it
 * to make all that anew when the graphics context was lost.
 */
import type { TargetInfo, TargetUpdate } from "../engine/engine-api.ts";
import type { CssColor } from "./css-color.ts";
import { FinestLevel, type TexelRegion } from "./finest-level.ts";
import type { TextureCamera } from "./texture-camera.ts";
import type { PaintedLines, PaintedTexture, TexturePainter } from "./texture-painter.ts";
import { type UvBounds, UvCharts } from "./uv-charts.ts";
import { meanLength, type UvEdges, uvEdges } from "./uv-edges.ts";

/** Opacity of inner lines against borders, where they are this many pixels long on average, or longer. */
const MOST_INNER_STRENGTH = 0.4;
const LINES_APART = 40;
/** Opacity of a lit chart's face: as on the model. */
const GLOW = 0.1;

/** Looks of what is drawn over the picture. */
export interface OverlayColors {
  readonly border: CssColor;
  readonly glow: CssColor;
}

/** The chart that is lit up. */
interface LitChart {
  readonly chart: number;
  readonly corners: PaintedLines;
  readonly borders: PaintedLines;
}

export class BoundTexture {
  readonly info: TargetInfo;
  readonly #uvTriangles: Float32Array;
  readonly #edges: UvEdges;
  /** Of the inner lines, in texture widths. */
  readonly #meanLength: number;
  #painter: TexturePainter;
  #texture: PaintedTexture;
  #finest: FinestLevel;
  #borders: PaintedLines;
  #inner: PaintedLines;
  #lit: LitChart | null = null;
  /** Made when a chart is first asked for. */
  #charts: UvCharts | null = null;

  /** Takes the picture over from the target that was bound before, where it is of the same one, and frees the rest of it. */
  constructor(painter: TexturePainter, info: TargetInfo, uvTriangles: Float32Array, before: BoundTexture | null) {
    this.#painter = painter;
    this.info = info;
    this.#uvTriangles = uvTriangles;
    this.#edges = uvEdges(uvTriangles);
    this.#meanLength = meanLength(this.#edges.inner);
    const isSame = before !== null && isAlike(before.info, info);
    if (before !== null) {
      before.dim();
      before.#freeLines();
      if (!isSame) painter.freeTexture(before.#texture);
    }
    this.#texture = isSame ? before.#texture : makeTexture(painter, info);
    this.#finest = isSame ? before.#finest : new FinestLevel();
    this.#borders = painter.makeLines(this.#edges.borders);
    this.#inner = painter.makeLines(this.#edges.inner);
  }

  get texture(): PaintedTexture {
    return this.#texture;
  }

  /** The graphics context is a new one: everything is made again, the picture empty. */
  restore(painter: TexturePainter): void {
    this.#painter = painter;
    this.#lit = null;
    this.#texture = makeTexture(painter, this.info);
    this.#finest = new FinestLevel();
    this.#borders = painter.makeLines(this.#edges.borders);
    this.#inner = painter.makeLines(this.#edges.inner);
  }

  /** Whether an update is one of this target, at its size. */
  takes({ material, rects }: TargetUpdate): boolean {
    const { width, height } = this.info;
    return (
      material === this.info.material &&
      rects.every(
        (rect) =>
          rect.x + rect.width <= Math.max(1, width >> rect.level) &&
          rect.y + rect.height <= Math.max(1, height >> rect.level),
      )
    );
  }

  /** `sparesFinest`: the finest mip level of an update that brings more of them is left out, as nobody sees it now. */
  upload(update: Pick<TargetUpdate, "rects" | "bytes">, sparesFinest: boolean): void {
    const hasLevels = update.rects.some(({ level }) => level > 0);
    const isSpared = hasLevels && sparesFinest;
    this.#painter.upload(this.#texture, update, isSpared ? 1 : 0);
    if (isSpared) this.#finest.leftOut(update.rects);
    else if (!hasLevels) this.#painter.makeLevels(this.#texture);
  }

  /** What was left out and is to be asked for, now that it is seen; null for nothing. */
  missing(): TexelRegion | null {
    return this.#finest.toAskFor();
  }

  /** The answer to `missing`: its texels, or null where they will not come. */
  complete(region: TexelRegion, bytes: Uint8Array | null): void {
    if (bytes !== null) {
      this.#painter.upload(this.#texture, { rects: [{ ...region, level: 0, byteOffset: 0 }], bytes }, 0);
    }
    this.#finest.answered(bytes === null ? null : region);
  }

  /** To be called before the texture is drawn: what of it is up to date. */
  drawFromNewest(): void {
    this.#painter.drawFrom(this.#texture, this.#finest.isStale ? 1 : 0);
  }

  drawOutlines({ border }: OverlayColors, camera: TextureCamera, pixelRatio: number): void {
    // Lines that lie close together on the screen would add up to a sheet over the picture.
    const pixels = this.#meanLength * this.info.width * camera.scale;
    const strength = MOST_INNER_STRENGTH * Math.min(1, Math.max(0.15, pixels / LINES_APART));
    const inner = [border[0], border[1], border[2], border[3] * strength] as const;
    this.#painter.drawLines(this.#inner, inner, this.#texture, camera, pixelRatio);
    this.#painter.drawLines(this.#borders, border, this.#texture, camera, pixelRatio);
  }

  drawLit({ glow }: OverlayColors, camera: TextureCamera, pixelRatio: number): void {
    if (this.#lit === null) return;
    const face = [glow[0], glow[1], glow[2], GLOW] as const;
    this.#painter.drawTriangles(this.#lit.corners, face, this.#texture, camera, pixelRatio);
    this.#painter.drawLines(this.#lit.borders, glow, this.#texture, camera, pixelRatio);
  }

  /** Round the chart at a place; null beside all charts. */
  chartAt(uv: readonly [number, number]): UvBounds | null {
    this.#charts ??= new UvCharts(this.#uvTriangles);
    return this.#charts.boundsAt(uv);
  }

  /** Lights the chart up that covers a place, or none. Returns whether that changes the picture. */
  light(uv: readonly [number, number] | null): boolean {
    if (uv === null) return this.dim();
    this.#charts ??= new UvCharts(this.#uvTriangles);
    const chart = this.#charts.chartAt(uv);
    if (chart === (this.#lit?.chart ?? null)) return false;
    this.dim();
    if (chart !== null) {
      const corners = this.#charts.cornersOfChart(chart);
      this.#lit = {
        chart,
        corners: this.#painter.makeLines(corners),
        borders: this.#painter.makeLines(uvEdges(corners).borders),
      };
    }
    return true;
  }

  /** Returns whether a chart was lit. */
  dim(): boolean {
    if (this.#lit === null) return false;
    this.#painter.freeLines(this.#lit.corners);
    this.#painter.freeLines(this.#lit.borders);
    this.#lit = null;
    return true;
  }

  #freeLines(): void {
    this.#painter.freeLines(this.#borders);
    this.#painter.freeLines(this.#inner);
  }
}

function isAlike(a: TargetInfo, b: TargetInfo): boolean {
  return a.material === b.material && a.width === b.width && a.height === b.height && a.mipLevels === b.mipLevels;
}

function makeTexture(painter: TexturePainter, { width, height, mipLevels }: TargetInfo): PaintedTexture {
  return painter.makeTexture(width, height, Math.max(1, mipLevels));
}
