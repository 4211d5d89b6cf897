/** The paper's plain method (bench/plain) compiled to WebAssembly with SIMD. */
import { readFile } from "node:fs/promises";
import type { Picture } from "../../web/engine/engine-api.ts";
import { decalFromModel, directionModel } from "../planar-matrix.ts";
import type { BenchMesh } from "../work.ts";
import type { BenchEngine, DragStep, Run } from "./engine.ts";

interface PlainExports extends WebAssembly.Exports {
  readonly memory: WebAssembly.Memory;
  _initialize(): void;
  malloc(byteCount: number): number;
  free(pointer: number): void;
  plain_bake(...args: number[]): number;
  plain_project(...args: number[]): number;
}

type Bytes = Float32Array | Uint32Array | Uint8Array;

export class PlainWasmEngine implements BenchEngine {
  readonly name = "plain method, WebAssembly";
  readonly #exports: PlainExports;
  /** What `load` put in place, and what `bake` did. */
  #loaded: number[] = [];
  #maps: number[] = [];
  #mesh = { positions: 0, normals: 0, uvs: 0, indices: 0, indexCount: 0 };
  #decal = { pointer: 0, width: 0, height: 0, numbers: 0 };
  #map = { size: 0, positions: 0, normals: 0, base: 0, out: 0 };

  private constructor(exports: PlainExports) {
    this.#exports = exports;
  }

  static async create(): Promise<PlainWasmEngine> {
    const bytes = await readFile(new URL("../../build/wasm-bench/plain_method.wasm", import.meta.url));
    const { instance } = await WebAssembly.instantiate(bytes, { env: { emscripten_notify_memory_growth() {} } });
    const exports = instance.exports as PlainExports;
    exports._initialize();
    return new PlainWasmEngine(exports);
  }

  async load(mesh: BenchMesh, decal: Picture): Promise<void> {
    this.#freeAll();
    const keep = (array: Bytes) => {
      const pointer = this.#copyIn(array);
      this.#loaded.push(pointer);
      return pointer;
    };
    this.#mesh = {
      positions: keep(mesh.positions),
      normals: keep(mesh.normals),
      uvs: keep(mesh.uvs),
      indices: keep(mesh.indices),
      indexCount: mesh.indices.length,
    };
    this.#decal = {
      pointer: keep(decal.rgba),
      width: decal.width,
      height: decal.height,
      numbers: keep(new Float32Array(15)),
    };
  }

  async bake(size: number): Promise<Run> {
    this.#makeMaps(size);
    const { positions, normals, uvs, indices, indexCount } = this.#mesh;
    const start = performance.now();
    const texels = this.#exports.plain_bake(
      positions,
      normals,
      uvs,
      indices,
      indexCount,
      size,
      this.#map.positions,
      this.#map.normals,
    );
    return { milliseconds: performance.now() - start, texels };
  }

  async project({ projector }: DragStep): Promise<Run> {
    const { pointer, width, height, numbers } = this.#decal;
    const { size, positions, normals, base, out } = this.#map;
    const view = new Float32Array(this.#exports.memory.buffer, numbers, 15);
    view.set([...decalFromModel(projector), ...directionModel(projector)]);
    const start = performance.now();
    const texels = this.#exports.plain_project(
      positions,
      normals,
      size,
      numbers,
      numbers + 12 * 4,
      pointer,
      width,
      height,
      base,
      out,
    );
    return { milliseconds: performance.now() - start, texels };
  }

  close(): void {
    this.#freeAll();
  }

  #makeMaps(size: number): void {
    if (this.#map.size === size) return;
    this.#freeMaps();
    const make = (bytesPerTexel: number) => {
      const pointer = this.#exports.malloc(size * size * bytesPerTexel);
      if (pointer === 0) throw new Error("out of memory");
      this.#maps.push(pointer);
      return pointer;
    };
    this.#map = { size, positions: make(12), normals: make(12), base: make(4), out: make(4) };
    new Uint8Array(this.#exports.memory.buffer, this.#map.base, size * size * 4).fill(255);
  }

  #copyIn(array: Bytes): number {
    const pointer = this.#exports.malloc(array.byteLength);
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    new Uint8Array(this.#exports.memory.buffer).set(bytes, pointer);
    return pointer;
  }

  #freeMaps(): void {
    for (const pointer of this.#maps) this.#exports.free(pointer);
    this.#maps = [];
    this.#map.size = 0;
  }

  #freeAll(): void {
    this.#freeMaps();
    for (const pointer of this.#loaded) this.#exports.free(pointer);
    this.#loaded = [];
  }
}
