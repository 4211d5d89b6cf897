/** Our core on the page's own thread; with `upload`, its dirty rectangles go to the GPU as the editor brings them there. */
import { WebGLRenderer } from "three";
import type { Picture, TargetInfo } from "../../web/engine/engine-api.ts";
import { LiveTexture } from "../../web/viewer/live-texture.ts";
import type { DragStep, Run } from "../engines/engine.ts";
import { TexelcastEngine } from "../engines/texelcast-engine.ts";
import type { BenchMesh } from "../work.ts";
import { type PageEngine, readOnePixel, timeWithGpu } from "./page-engine.ts";

export class TexelcastPageEngine implements PageEngine {
  readonly name: string;
  readonly engine: TexelcastEngine;
  readonly #gpu: UploadTarget | null;
  #size = 0;

  private constructor(engine: TexelcastEngine, gpu: UploadTarget | null) {
    this.engine = engine;
    this.name = engine.name;
    this.#gpu = gpu;
  }

  static async create({ upload }: { upload: boolean }): Promise<TexelcastPageEngine> {
    const engine = await TexelcastEngine.create(upload ? "Texelcast, uploaded" : "Texelcast");
    return new TexelcastPageEngine(engine, upload ? new UploadTarget() : null);
  }

  async load(mesh: BenchMesh, decal: Picture): Promise<void> {
    await this.engine.load(mesh, decal);
  }

  async prepare(size: number): Promise<void> {
    await this.engine.bake(size);
    this.#size = size;
    this.#gpu?.make(size);
  }

  async project(step: DragStep): Promise<Run> {
    const gpu = this.#gpu;
    if (!gpu) return this.engine.project(step);
    // The core's step is synchronous under its promise, but a promise in the middle would let a frame pass.
    const run = await this.engine.project(step);
    const uploaded = await timeWithGpu(
      () => gpu.upload(this.engine.newestUpdate),
      () => gpu.readPixel(),
    );
    return {
      texels: run.texels,
      milliseconds: run.milliseconds + uploaded.milliseconds,
      untilRead: run.milliseconds + uploaded.untilRead,
    };
  }

  async readTexture(): Promise<Uint8Array> {
    return this.#gpu ? this.#gpu.read() : this.engine.readTexture(this.#size);
  }

  close(): void {
    this.engine.close();
    this.#gpu?.close();
  }
}

/** The editor's live texture, without a model: bound to a frame buffer, from which its texels can be read. */
class UploadTarget {
  readonly #renderer = new WebGLRenderer();
  readonly #gl = this.#renderer.getContext() as WebGL2RenderingContext;
  readonly #framebuffer = this.#gl.createFramebuffer();
  #texture: LiveTexture | null = null;
  #size = 0;

  /** Without mip levels, as the others of the benchmark are. */
  make(size: number): void {
    this.#texture?.dispose();
    this.#size = size;
    const nothing = { gutter: 0, coveredTexels: 0, gutterTexels: 0, overlappingTexels: 0, mapBytes: 0 };
    const nowhere = { boundsMin: [0, 0, 0], boundsMax: [0, 0, 0] } as const;
    const info: TargetInfo = { material: 0, width: size, height: size, mipLevels: 1, ...nothing, ...nowhere };
    this.#texture = new LiveTexture(this.#renderer, info, null);
    // The base: the steps bring only what changes on it.
    const bytes = new Uint8Array(size * size * 4).fill(255);
    this.upload({ rects: [{ x: 0, y: 0, width: size, height: size, level: 0, byteOffset: 0 }], bytes });
  }

  upload({ rects, bytes }: { rects: TexelcastEngine["newestUpdate"]["rects"]; bytes: Uint8Array }): void {
    const figures = { projectedLayers: 0, projectedTexels: 0, compositedTexels: 0, milliseconds: 0 };
    this.#texture?.upload({ material: 0, revision: 0, rects, bytes, ...figures });
    this.#gl.flush();
  }

  readPixel(): void {
    this.#bound(() => readOnePixel(this.#gl));
  }

  read(): Uint8Array {
    const rgba = new Uint8Array(this.#size * this.#size * 4);
    const gl = this.#gl;
    this.#bound(() => gl.readPixels(0, 0, this.#size, this.#size, gl.RGBA, gl.UNSIGNED_BYTE, rgba));
    return rgba;
  }

  close(): void {
    this.#texture?.dispose();
    this.#renderer.dispose();
  }

  #bound(read: () => void): void {
    const gl = this.#gl;
    const { __webglTexture } = this.#renderer.properties.get(this.#texture?.texture) as {
      __webglTexture: WebGLTexture;
    };
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, __webglTexture, 0);
    read();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }
}
