/** Zoom and pan of the texture view. Pixels are CSS pixels of the view; texels count from the texture's top left. */

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Free room around a texture that is fitted, pixels. */
const FIT_MARGIN = 16;
/** Pixels that one texel may grow to. */
const MOST_PIXELS_PER_TEXEL = 64;
/** A texture is not zoomed below this share of the fitted size. */
const LEAST_SHARE_OF_FIT = 0.4;
/** This much of the texture stays in view, pixels. */
const KEPT_IN_VIEW = 48;

export class TextureCamera {
  /** Pixels per texel. */
  scale = 1;
  /** Where the texture's top left corner is, pixels. */
  x = 0;
  y = 0;
  #view: Size = { width: 1, height: 1 };
  #texture: Size = { width: 1, height: 1 };
  /** Until the user moves the view, it follows its own size. */
  #fitted = true;

  setView(view: Size): void {
    this.#view = view;
    this.#settle();
  }

  /** A texture of other proportions or size keeps the same part in view, unless all of it was. */
  setTexture(texture: Size): void {
    if (!this.#fitted && texture.width > 0) {
      this.scale *= this.#texture.width / texture.width;
    }
    this.#texture = texture;
    this.#settle();
  }

  /** All of the texture, centred. */
  fit(): void {
    this.#fitted = true;
    this.#settle();
  }

  /** Zooms by a factor about a point of the view that stays where it is. */
  zoomAt(factor: number, x: number, y: number): void {
    const scale = Math.min(MOST_PIXELS_PER_TEXEL, Math.max(LEAST_SHARE_OF_FIT * this.#fitScale(), this.scale * factor));
    this.x = x - ((x - this.x) * scale) / this.scale;
    this.y = y - ((y - this.y) * scale) / this.scale;
    this.scale = scale;
    this.#fitted = false;
    this.#settle();
  }

  panBy(x: number, y: number): void {
    this.x += x;
    this.y += y;
    this.#fitted = false;
    this.#settle();
  }

  /** Whether a point is in the view, and this far from its border. */
  holds({ x, y }: { readonly x: number; readonly y: number }, margin: number): boolean {
    const { width, height } = this.#view;
    return x >= margin && y >= margin && x <= width - margin && y <= height - margin;
  }

  /** A texture coordinate's place in the view. */
  pixelOf(uv: readonly [number, number]): { x: number; y: number } {
    return {
      x: this.x + uv[0] * this.#texture.width * this.scale,
      y: this.y + uv[1] * this.#texture.height * this.scale,
    };
  }

  /** The texture coordinate at a point of the view, not wrapped. */
  uvOf(x: number, y: number): [number, number] {
    return [(x - this.x) / (this.#texture.width * this.scale), (y - this.y) / (this.#texture.height * this.scale)];
  }

  #fitScale(): number {
    const width = Math.max(1, this.#view.width - 2 * FIT_MARGIN) / this.#texture.width;
    const height = Math.max(1, this.#view.height - 2 * FIT_MARGIN) / this.#texture.height;
    return Math.min(width, height, MOST_PIXELS_PER_TEXEL);
  }

  #settle(): void {
    const { width, height } = this.#view;
    if (this.#fitted) {
      this.scale = this.#fitScale();
      this.x = (width - this.#texture.width * this.scale) / 2;
      this.y = (height - this.#texture.height * this.scale) / 2;
      return;
    }
    const kept = Math.min(KEPT_IN_VIEW, width / 2, height / 2);
    this.x = Math.min(width - kept, Math.max(kept - this.#texture.width * this.scale, this.x));
    this.y = Math.min(height - kept, Math.max(kept - this.#texture.height * this.scale, this.y));
  }
}
