/**
 * `texelcast/three`: decals on a mesh of one's own three.js scene, in a texture that follows them live. `three` is the page's
 * own, as a peer.
 */
import {
  type Color,
  type DataTexture,
  type Material,
  type Mesh,
  SRGBColorSpace,
  type Texture,
  type WebGLRenderer,
} from "three";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { DesignLayer } from "../editor/document/design.ts";
import { makeDecalLayer } from "../editor/document/make-layer.ts";
import { resolveLayers } from "../editor/document/resolve-layers.ts";
import { checkValue, LIST, OBJECT } from "../engine/check-value.ts";
import type { Engine, PlanarProjector, Projector, TargetOptions, TargetUpdate, Vec3 } from "../engine/engine-api.ts";
import type { EngineClientOptions } from "../engine/engine-client.ts";
import { LiveTexture } from "../viewer/live-texture.ts";
import { meshGlb, placeOnPicture } from "../viewer/mesh-glb.ts";
import { beginEngine } from "./begin-engine.ts";

export { TexelcastError, type TexelcastErrorDetails, type TexelcastErrorJson } from "../core/texelcast-error.ts";
export type { Projector } from "../engine/engine-api.ts";

export interface PaintMeshOptions extends EngineClientOptions {
  /** Texels of the texture's side, 1 to 8192; default 1024. */
  readonly size?: number;
  /**
   * What lies below the decals: a colour (sRGB with alpha, each 0 to 1) or a picture's bytes (PNG, JPEG, WebP, AVIF). Default: the
   * material's colour. A material with a map needs it: three.js does not give the map's pixels away. A picture in a map's place lies
   * as the map did: in its UV set, with its transform, its `flipY` and the material's colour.
   */
  readonly base?: Exclude<TargetOptions["base"], "model" | undefined>;
}

/** A decal on the mesh; the fields of a design's decal layer that are not given are at their defaults. */
export type MeshDecal = Partial<
  Omit<ReturnType<typeof makeDecalLayer>, "type" | "asset" | "material" | "projector">
> & {
  /** Unique among the decals. */
  readonly id: string;
  /** The key that `setPicture` got. */
  readonly picture: string;
} & (
    | { readonly projector: Projector }
    /** A flat box in the mesh's own space; the picture faces its +Z. `size`: full extents. */
    | { readonly position: Vec3; readonly rotation: PlanarProjector["rotation"]; readonly size: Vec3 }
  );

/** A mesh whose texture is painted by an engine of its own. */
export class PaintedMesh {
  readonly mesh: Mesh;
  /** As `map` of the mesh's material, a copy of the one that it had. */
  readonly texture: Texture;
  /** All that the engine can do: fonts, exports, hashes. */
  readonly engine: Engine;
  readonly #live: LiveTexture;
  readonly #before: Material;
  readonly #painted: Material;
  #revision = 0;

  private constructor(mesh: Mesh, engine: Engine, live: LiveTexture, like: Texture | null) {
    this.mesh = mesh;
    this.engine = engine;
    this.texture = live.texture;
    this.#live = live;
    this.#before = materialOf(mesh);
    this.#painted = this.#before.clone();
    // What three.js's own copies leave behind.
    const { onBeforeCompile, onBeforeRender, customProgramCacheKey } = this.#before;
    Object.assign(this.#painted, { onBeforeCompile, onBeforeRender, customProgramCacheKey });
    // The colour lies in the texture now, but for one that a map had over it.
    if (like === null) (this.#painted as Partial<{ color: Color }>).color?.set(0xffffff);
    Object.assign(this.#painted, { map: live.texture, needsUpdate: true });
    mesh.material = this.#painted;
  }

  /**
   * Bakes the mesh and gives it its texture. Rejects with a TexelcastError: "bad-argument" for a mesh without `uv`, with several
   * materials, or with a map and no `base`; "unsupported" for another renderer than three.js's of WebGL; and with what the engine says.
   */
  static async create(renderer: WebGLRenderer, mesh: Mesh, options: PaintMeshOptions = {}): Promise<PaintedMesh> {
    checkValue(options, OBJECT, "options");
    const { size = 1024, base, ...engineOptions } = options;
    check(renderer, mesh);
    const holds = (value: unknown): boolean => Number.isInteger(value) && size >= 1 && size <= 8192;
    checkValue(size, { must: "a whole number from 1 to 8192", holds }, "size");
    const target = { material: 0, width: size, height: size, base: base ?? colorOf(mesh), mipmaps: true };
    const like = isFile(base) ? (mapOf(materialOf(mesh)) ?? null) : null;
    const bytes = meshGlb(mesh, like);
    const engine = beginEngine(engineOptions);
    try {
      await engine.loadModel({ name: mesh.name || "mesh", bytes });
      let live: LiveTexture | null = null;
      // The target's first texels come before its promise does.
      const early: TargetUpdate[] = [];
      const show = (update: TargetUpdate): void => {
        if (live === null) {
          early.push(update);
          return;
        }
        // Of another size, where the engine was told so directly.
        if (!live.fits(update)) return;
        keepTexels(live.texture, update);
        live.upload(update);
      };
      engine.onUpdate(show);
      live = new LiveTexture(renderer, await engine.openTarget(target), like);
      if (like !== null) live.texture.matrix.copy(placeOnPicture(like));
      letThreeFill(live.texture);
      early.forEach(show);
      return new PaintedMesh(mesh, engine, live, like);
    } catch (error) {
      engine.dispose();
      throw error;
    }
  }

  /** Takes in a picture (PNG, JPEG, WebP, AVIF, SVG) under a key. Rejects with "bad-picture", and "bad-argument" for what are no bytes. */
  async setPicture(
    key: string,
    bytes: Uint8Array | ArrayBuffer,
    name = key,
  ): Promise<{ width: number; height: number }> {
    // By its tag, as one of another window's is none of this one's. What is neither, the engine refuses by name.
    const isBuffer = /^\[object (Shared)?ArrayBuffer\]$/.test(Object.prototype.toString.call(bytes));
    return await this.engine.setAsset(key, { name, bytes: isBuffer ? new Uint8Array(bytes) : (bytes as Uint8Array) });
  }

  /**
   * All decals, bottom to top, in place of those before. Returns at once; the texture follows. Throws "bad-argument" for what is no
   * list of objects; what is wrong in one of them, `idle` tells.
   */
  setDecals(decals: readonly MeshDecal[]): void {
    checkValue(decals, LIST, "decals");
    const layers = decals.map(layerOf);
    this.engine.setLayers(resolveLayers({ layers, assets: {} }), ++this.#revision);
  }

  /** Resolves when the texture shows all that was set. */
  async idle(): Promise<void> {
    await this.engine.idle();
  }

  /** The texture as PNG. */
  async exportPng(): Promise<Uint8Array<ArrayBuffer>> {
    return await this.engine.exportPng(0);
  }

  /** Ends the engine, and gives the mesh the material that it had. */
  dispose(): void {
    this.engine.dispose();
    if (this.mesh.material === this.#painted) this.mesh.material = this.#before;
    this.#painted.dispose();
    this.#live.dispose();
  }
}

function layerOf(decal: MeshDecal, at: number): DesignLayer {
  checkValue(decal, OBJECT, `decals[${at}]`);
  const { picture, ...rest } = decal;
  const projector: Projector =
    "projector" in decal
      ? decal.projector
      : { kind: "planar", position: decal.position, rotation: decal.rotation, size: decal.size };
  return makeDecalLayer({ ...rest, asset: picture, material: 0, projector });
}

type Level = { data: Uint8Array | null; readonly width: number; readonly height: number };

/** The picture that three.js has of a texture, and its smaller ones. */
function levelsOf({ image, mipmaps }: DataTexture): readonly Level[] {
  return (mipmaps.length > 0 ? mipmaps : [image]) as readonly Level[];
}

/**
 * Has three.js keep the texels too, as it does of any texture: it makes the GPU's anew where the graphics context was lost, for another
 * wrapping or filter, for another renderer and after `texture.dispose()`, and exporters read them.
 */
function letThreeFill(texture: DataTexture): void {
  for (const level of levelsOf(texture)) level.data = new Uint8Array(level.width * level.height * 4);
  (texture.image as Level).data = levelsOf(texture)[0]?.data ?? null;
  texture.source.dataReady = true;
}

function keepTexels(texture: DataTexture, { rects, bytes }: TargetUpdate): void {
  const levels = levelsOf(texture);
  for (const { x, y, width, height, level, byteOffset } of rects) {
    const kept = levels[level];
    for (let row = 0; kept?.data && row < height; row++) {
      const from = byteOffset + row * width * 4;
      kept.data.set(bytes.subarray(from, from + width * 4), ((y + row) * kept.width + x) * 4);
    }
  }
}

function check(renderer: WebGLRenderer, mesh: Mesh): void {
  if (!(renderer as { isWebGLRenderer?: boolean } | undefined)?.isWebGLRenderer) {
    throw new TexelcastError("unsupported", "The texture is written into by WebGL; this is no WebGLRenderer.", {
      field: "renderer",
      hint: "Give the WebGLRenderer that draws the mesh; WebGPURenderer has no such texture, whatever it draws by.",
    });
  }
  if (!mesh?.isMesh) {
    throw new TexelcastError("bad-argument", "This is no mesh of three.js.", {
      field: "mesh",
      value: String((mesh as { type?: unknown } | undefined)?.type),
      hint: "Of a loaded scene give one of its meshes, as `traverse` finds them.",
    });
  }
  materialOf(mesh);
}

function materialOf(mesh: Mesh): Material {
  if (!Array.isArray(mesh.material)) return mesh.material;
  throw new TexelcastError("bad-argument", "The mesh has several materials; a texture of ours is of one.", {
    subject: mesh.name || "mesh",
    field: "material",
    hint: "Split it into one mesh a material.",
  });
}

const mapOf = (material: Material): Texture | null | undefined => (material as Partial<{ map: Texture | null }>).map;

type Base = PaintMeshOptions["base"];

const isFile = (base: Base): base is Extract<Base, { readonly bytes: Uint8Array }> => "bytes" in Object(base);

function colorOf(mesh: Mesh): readonly [number, number, number, number] {
  const material = materialOf(mesh);
  const { color } = material as Partial<{ color: Color }>;
  if (mapOf(material)) {
    throw new TexelcastError("bad-argument", "The material has a map, whose pixels three.js does not give away.", {
      subject: mesh.name || "mesh",
      field: "base",
      hint: "Give the map's file as `base`, or a colour.",
    });
  }
  if (color === undefined) return [1, 1, 1, 1];
  const { r, g, b } = color.getRGB({ r: 0, g: 0, b: 0 } as Color, SRGBColorSpace);
  return [r, g, b, 1];
}
