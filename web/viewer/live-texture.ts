/**
 * A material's texture on the GPU, kept up to date rectangle by rectangle.
 *
 * Why not `needsUpdate`: it uploads the whole texture. Why not `addUpdateRange`: over several rows it uploads the
 * wrong pixels. Why not `copyTextureToTexture`: it sets six things anew for each rectangle, of which an update in a drag
 * has a score, and asks the GPU how bytes are read, so that the first one waited until all was drawn that had been asked
 * for (in software most of a second of a page's opening).
 */
import {
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  NearestFilter,
  RepeatWrapping,
  SRGBColorSpace,
  type Texture,
  type WebGLRenderer,
} from "three";
import type { TargetInfo, TargetUpdate } from "../engine/engine-api.ts";
import { anisotropyFor } from "./anisotropy.ts";

export class LiveTexture {
  readonly texture: DataTexture;
  readonly width: number;
  readonly height: number;
  readonly #levels: number;
  readonly #nearestByModel: boolean;
  readonly #renderer: WebGLRenderer;

  /** @param like the model's own texture, whose transform, UV set and magnification are kept; null where it has none. */
  constructor(renderer: WebGLRenderer, info: TargetInfo, like: Texture | null) {
    this.#renderer = renderer;
    this.width = info.width;
    this.height = info.height;
    this.#levels = Math.max(1, info.mipLevels);
    const texture = new DataTexture(null, info.width, info.height);
    layLike(texture, like);
    // Pixel-art skins ask for NEAREST in their sampler; it stays their look.
    this.#nearestByModel = like?.magFilter === NearestFilter;
    texture.magFilter = this.#nearestByModel ? NearestFilter : LinearFilter;
    texture.minFilter = LinearFilter;
    if (this.#levels > 1) {
      texture.minFilter = LinearMipmapLinearFilter;
      texture.anisotropy = anisotropyFor(renderer);
      // Descriptors without data: three allocates as many levels as it finds here.
      texture.mipmaps = Array.from({ length: this.#levels }, (_, level) => ({
        ...levelSize(info.width, info.height, level),
        data: null,
      })) as never[];
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
    const { state } = this.#renderer;
    const gl = this.#renderer.getContext() as WebGL2RenderingContext;
    // Made anew where the graphics context was lost.
    this.#renderer.initTexture(this.texture);
    state.bindTexture(gl.TEXTURE_2D, this.#handle as WebGLTexture);
    // How bytes are read, told by way of three, which keeps what was told; older ones keep nothing. All else it puts back.
    const tell = state.pixelStorei ?? gl.pixelStorei;
    tell.call(gl, gl.UNPACK_FLIP_Y_WEBGL, false);
    tell.call(gl, gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    tell.call(gl, gl.UNPACK_ALIGNMENT, 4);
    let sum = 0;
    for (const { x, y, width, height, level, byteOffset } of rects) {
      if (level < this.#levels && width > 0 && height > 0) {
        gl.texSubImage2D(gl.TEXTURE_2D, level, x, y, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes, byteOffset);
        sum += width * height * 4;
      }
    }
    return sum;
  }

  dispose(): void {
    this.texture.dispose();
  }

  get #handle(): WebGLTexture | undefined {
    return (this.#renderer.properties.get(this.texture) as { __webglTexture?: WebGLTexture }).__webglTexture;
  }
}

function levelSize(width: number, height: number, level: number): { width: number; height: number } {
  return { width: width >> level || 1, height: height >> level || 1 };
}

/**
 * Lays a texture on a model in the place of the model's own.
 *
 * @param like the model's own texture, whose transform, UV set and repeating are kept; null where it has none.
 */
export function layLike(texture: DataTexture, like: Texture | null): void {
  texture.colorSpace = SRGBColorSpace;
  // Where the paint goes on otherwise than the model's own, the mended scene says how.
  const wrap = like?.userData.painted ?? like;
  texture.wrapS = wrap?.wrapS ?? RepeatWrapping;
  texture.wrapT = wrap?.wrapT ?? RepeatWrapping;
  if (like?.matrixAutoUpdate) like.updateMatrix();
  texture.channel = like?.channel ?? 0;
  texture.matrixAutoUpdate = false;
  if (like) texture.matrix.copy(like.matrix);
}
