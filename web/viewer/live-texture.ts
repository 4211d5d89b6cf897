/**
 * A material's texture on the GPU, kept up to date rectangle by rectangle.
 *
 * Why not `needsUpdate`: it uploads the whole texture. Why not `addUpdateRange`: over several rows it uploads the
 * wrong pixels. `copyTextureToTexture` from a DataTexture that was never bound goes straight from the packed bytes to
 * `texSubImage2D`, and nothing is copied on the way. It sets six things anew for each rectangle, of which an update in a
 * drag has a score, so only the first goes through it (1.33 ms of this thread for an update of both views against 1.58).
 */
import {
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  NearestFilter,
  RepeatWrapping,
  RGBAFormat,
  SRGBColorSpace,
  type Texture,
  UnsignedByteType,
  Vector2,
  type WebGLRenderer,
} from "three";
import type { DirtyRect, TargetInfo, TargetUpdate } from "../engine/engine-api.ts";

/** Anisotropy beyond this is not seen on painted colours, and costs fill rate. */
const MOST_ANISOTROPY = 8;

export class LiveTexture {
  readonly texture: DataTexture;
  readonly width: number;
  readonly height: number;
  readonly #levels: number;
  readonly #nearestByModel: boolean;
  readonly #renderer: WebGLRenderer;
  readonly #staging = new DataTexture(new Uint8Array(4), 1, 1);
  readonly #position = new Vector2();

  /** @param like the model's own texture, whose transform, UV set and magnification are kept; null where it has none. */
  constructor(renderer: WebGLRenderer, info: TargetInfo, like: Texture | null) {
    this.#renderer = renderer;
    this.width = info.width;
    this.height = info.height;
    this.#levels = Math.max(1, info.mipLevels);
    const texture = new DataTexture(null, info.width, info.height, RGBAFormat, UnsignedByteType);
    texture.colorSpace = SRGBColorSpace;
    texture.flipY = false;
    texture.generateMipmaps = false;
    texture.wrapS = like?.wrapS ?? RepeatWrapping;
    texture.wrapT = like?.wrapT ?? RepeatWrapping;
    // Pixel-art skins ask for NEAREST in their sampler; it stays their look.
    this.#nearestByModel = like?.magFilter === NearestFilter;
    texture.magFilter = this.#nearestByModel ? NearestFilter : LinearFilter;
    texture.minFilter = this.#levels > 1 ? LinearMipmapLinearFilter : LinearFilter;
    texture.anisotropy = this.#levels > 1 ? Math.min(MOST_ANISOTROPY, renderer.capabilities.getMaxAnisotropy()) : 1;
    if (like !== null) {
      texture.channel = like.channel;
      texture.offset.copy(like.offset);
      texture.repeat.copy(like.repeat);
      texture.center.copy(like.center);
      texture.rotation = like.rotation;
    }
    if (this.#levels > 1) {
      texture.mipmaps = levelSizes(info.width, info.height, this.#levels);
    }
    // Storage for all levels is allocated and left empty: the first update brings every texel.
    texture.source.dataReady = false;
    texture.needsUpdate = true;
    renderer.initTexture(texture);
    this.texture = texture;
  }

  /**
   * Whether texels are shown as squares; null: as the model's own texture asks. Told to the GPU directly: three would allocate the texture anew for it, and its
   * texels, which only the GPU has, would be lost.
   */
  set pixelated(value: boolean | null) {
    const { texture } = this;
    const nearest = value ?? this.#nearestByModel;
    const gl = this.#renderer.getContext() as WebGL2RenderingContext;
    const handle = this.#handle;
    texture.magFilter = nearest ? NearestFilter : LinearFilter;
    if (handle === undefined) return;
    this.#renderer.state.bindTexture(gl.TEXTURE_2D, handle);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, nearest ? gl.NEAREST : gl.LINEAR);
  }

  /** Whether every rectangle lies inside this texture: an update of a target of another size does not. */
  fits(update: TargetUpdate): boolean {
    return update.rects.every((rect) => {
      const { width, height } = levelSize(this.width, this.height, rect.level);
      return rect.x + rect.width <= width && rect.y + rect.height <= height;
    });
  }

  /** Uploads an update's rectangles; levels that this texture does not have are left out. Returns the bytes uploaded. */
  upload({ rects, bytes }: TargetUpdate): number {
    const [first, ...rest] = rects.filter(
      ({ level, width, height }) => level < this.#levels && width > 0 && height > 0,
    );
    if (first === undefined) {
      return 0;
    }
    // By three, which says how bytes are to be read; what it says holds for the others.
    this.#uploadFirst(first, bytes);
    const gl = this.#renderer.getContext() as WebGL2RenderingContext;
    this.#renderer.state.bindTexture(gl.TEXTURE_2D, this.#handle as WebGLTexture);
    for (const { x, y, width, height, level, byteOffset } of rest) {
      gl.texSubImage2D(gl.TEXTURE_2D, level, x, y, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes, byteOffset);
    }
    return [first, ...rest].reduce((sum, rect) => sum + byteLength(rect), 0);
  }

  dispose(): void {
    this.texture.dispose();
  }

  get #handle(): WebGLTexture | undefined {
    return (this.#renderer.properties.get(this.texture) as { __webglTexture?: WebGLTexture }).__webglTexture;
  }

  #uploadFirst(rect: DirtyRect, bytes: Uint8Array): void {
    const data = bytes.subarray(rect.byteOffset, rect.byteOffset + byteLength(rect)) as Uint8Array<ArrayBuffer>;
    this.#staging.image = { data, width: rect.width, height: rect.height };
    this.#position.set(rect.x, rect.y);
    this.#renderer.copyTextureToTexture(this.#staging, this.texture, null, this.#position, 0, rect.level);
  }
}

function byteLength({ width, height }: DirtyRect): number {
  return width * height * 4;
}

function levelSize(width: number, height: number, level: number): { width: number; height: number } {
  return { width: Math.max(1, width >> level), height: Math.max(1, height >> level) };
}

/** Descriptors without data: three allocates as many levels as it finds here. */
function levelSizes(width: number, height: number, levels: number) {
  return Array.from({ length: levels }, (_, level) => ({ ...levelSize(width, height, level), data: null })) as never[];
}
