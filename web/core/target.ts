/** One material's texture at a size: its baked map, its base picture and its layers. Made by `Session.createTarget`. */
import {
  type CoreGradient,
  type Dab,
  DabLayout,
  GradientLayout,
  type LayerDef,
  LayerDefLayout,
  type MapInfo,
  MapInfoLayout,
  NONE,
  type Rect,
  RectLayout,
  UpdateLayout,
  type ZoneSurface,
  ZoneSurfaceLayout,
} from "./abi.ts";
import { readStruct, writeStruct } from "./struct-layout.ts";
import { TexelcastError } from "./texelcast-error.ts";
import type { CoreModule } from "./wasm-module.ts";

/** A layer of the target by its handle. */
export type LayerHandle = number & { readonly brand?: "TxcLayer" };

/** What an update changed; all of it copies. */
export interface CoreUpdate {
  readonly rects: readonly Rect[];
  /** The rectangles' texels packed one after another, RGBA. */
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly projectedLayers: number;
  readonly projectedTexels: number;
  readonly compositedTexels: number;
  /** Layers wait that the limit left no room for. */
  readonly unfinished: boolean;
}

export class Target {
  readonly #core: CoreModule;
  readonly #session: number;
  readonly #handle: number;

  constructor(core: CoreModule, session: number, handle: number) {
    this.#core = core;
    this.#session = session;
    this.#handle = handle;
  }

  destroy(): void {
    this.#core.run("txc_target_destroy", this.#session, this.#handle);
  }

  /** Bakes on for about `workLimit` texels. `progress` is 0 to 1; `done` once the map is ready. */
  bake(workLimit: number): { readonly done: boolean; readonly progress: number } {
    return this.#core.withMemory(4, (out) => {
      const pending = this.#core.run("txc_target_bake", this.#session, this.#handle, workLimit, out);
      const progress = new Float32Array(this.#core.copyOut(out, 4).buffer)[0] ?? 0;
      return { done: !pending, progress };
    });
  }

  info(): MapInfo {
    return this.#core.collectStruct(MapInfoLayout, (out) =>
      this.#core.run("txc_map_info", this.#session, this.#handle, out),
    );
  }

  /** Rows of the map: three floats a texel, metres, model space. */
  readPositions(row: number, rowCount: number): Float32Array<ArrayBuffer> {
    return new Float32Array(this.#readRows("txc_map_read_positions", row, rowCount, 12).buffer);
  }

  /** Rows of the map: three floats a texel, unit length, model space. */
  readNormals(row: number, rowCount: number): Float32Array<ArrayBuffer> {
    return new Float32Array(this.#readRows("txc_map_read_normals", row, rowCount, 12).buffer);
  }

  /** Rows of the map: 0 empty, 1 covered, 2 gutter. */
  readCoverage(row: number, rowCount: number): Uint8Array<ArrayBuffer> {
    return this.#readRows("txc_map_read_coverage", row, rowCount, 1);
  }

  /** Rows of the map: how many triangles cover the texel, capped at 255. */
  readOverlap(row: number, rowCount: number): Uint8Array<ArrayBuffer> {
    return this.#readRows("txc_map_read_overlap", row, rowCount, 1);
  }

  #readRows(
    name: "txc_map_read_positions" | "txc_map_read_normals" | "txc_map_read_coverage" | "txc_map_read_overlap",
    row: number,
    rowCount: number,
    bytesPerTexel: number,
  ): Uint8Array<ArrayBuffer> {
    this.#checkRows(row, rowCount);
    return this.#core.collect(this.info().width * rowCount * bytesPerTexel, (out) => {
      this.#core.run(name, this.#session, this.#handle, row, rowCount, out);
    });
  }

  /** Rows of a view of the map (abi.ts, `MapViews`), RGBA. */
  view(view: number, row: number, rowCount: number): Uint8Array<ArrayBuffer> {
    this.#checkRows(row, rowCount);
    return this.#core.collect(this.info().width * rowCount * 4, (out) => {
      this.#core.run("txc_map_view", this.#session, this.#handle, view, row, rowCount, out);
    });
  }

  /** Before memory is asked for: a count far out of range would name the memory, not the argument. */
  #checkRows(row: number, rowCount: number): void {
    const { height } = this.info();
    if (!Number.isInteger(row) || !Number.isInteger(rowCount) || row < 0 || rowCount < 0 || row + rowCount > height) {
      throw new TexelcastError(
        "bad-argument",
        `Rows ${row} to ${row + rowCount} do not lie in a map of ${height} rows.`,
        {
          field: "row",
          value: `${row}, ${rowCount}`,
        },
      );
    }
  }

  /** Sets what the layers lie on: RGBA, straight alpha, resampled with `filter` (abi.ts, `Filters`). */
  setBase(width: number, height: number, rgba: Uint8Array, filter: number): void {
    if (rgba.length !== width * height * 4) {
      throw new TexelcastError(
        "bad-argument",
        `A ${width} × ${height} picture has ${width * height * 4} bytes, not ${rgba.length}.`,
        {
          field: "rgba",
          value: String(rgba.length),
        },
      );
    }
    this.#core.withBytes(rgba, (pointer) => {
      this.#core.run("txc_target_set_base", this.#session, this.#handle, width, height, pointer, filter);
    });
  }

  /** Sets the base to one colour, each channel 0 to 255. */
  setBaseColor(red: number, green: number, blue: number, alpha: number): void {
    this.#core.run("txc_target_set_base_color", this.#session, this.#handle, red, green, blue, alpha);
  }

  /** Adds a layer on top of its parent's others, else of the target's; what `def` leaves out has the ABI's default. */
  createLayer(def: Partial<LayerDef>): LayerHandle {
    return this.#core.withStruct(LayerDefLayout, "txc_layer_def_default", def, (pointer) =>
      this.#core.collectU32((out) => this.#core.run("txc_layer_create", this.#session, this.#handle, pointer, out)),
    );
  }

  /** Gives a layer new values; what `def` leaves out goes back to the ABI's default. */
  updateLayer(layer: LayerHandle, def: Partial<LayerDef>): void {
    this.#core.withStruct(LayerDefLayout, "txc_layer_def_default", def, (pointer) => {
      this.#core.run("txc_layer_update", this.#session, layer, pointer);
    });
  }

  /** Puts a layer at `index` from the bottom of the list that it is in. */
  moveLayer(layer: LayerHandle, index: number): void {
    this.#core.run("txc_layer_move", this.#session, layer, index);
  }

  /** Ends a layer and all that are in it. */
  destroyLayer(layer: LayerHandle): void {
    this.#core.run("txc_layer_destroy", this.#session, layer);
  }

  /**
   * Gets ready for changes of a layer (`inside`: of what is on top in a group, and of its mask), on at most `tileCount` tiles
   * from `firstTile` on. Returns the tile to go on with; null when there is no more to do.
   */
  prepareLayer(layer: LayerHandle, inside: boolean, firstTile: number, tileCount: number): number | null {
    const next = this.#core.collectU32((out) =>
      this.#core.run("txc_layer_prepare", this.#session, layer, Number(inside), firstTile, tileCount, out),
    );
    return next === NONE ? null : next;
  }

  /** A small picture of what a layer paints, or of its mask: `side` x `side` pixels, RGBA (texelcast.h). */
  layerMiniature(layer: LayerHandle, ofMask: boolean, side: number): Uint8Array<ArrayBuffer> {
    return this.#core.collect(side * side * 4, (out) => {
      this.#core.run("txc_layer_miniature", this.#session, layer, Number(ofMask), side, out);
    });
  }

  /** What the layer was last given. */
  layerDef(layer: LayerHandle): LayerDef {
    return this.#core.collectStruct(LayerDefLayout, (out) =>
      this.#core.run("txc_layer_def", this.#session, layer, out),
    );
  }

  /** Gives a fill a gradient, what it leaves out with the ABI's default, or (null) one colour again. */
  setGradient(fill: LayerHandle, gradient: Partial<CoreGradient> | null): void {
    const core = this.#core;
    if (gradient === null) core.run("txc_fill_set_gradient", this.#session, fill, 0);
    else
      core.withStruct(GradientLayout, "txc_gradient_default", gradient, (pointer) => {
        core.run("txc_fill_set_gradient", this.#session, fill, pointer);
      });
  }

  /** Keeps a fill to some of the material's triangles; null: everywhere. */
  setTriangles(fill: LayerHandle, triangles: Uint32Array | null): void {
    // An empty list means none, a null pointer all.
    const bytes = triangles !== null && triangles.length === 0 ? new Uint32Array(1) : triangles;
    this.#core.withBytes(bytes, (pointer) => {
      this.#core.run("txc_fill_set_triangles", this.#session, fill, pointer, triangles?.length ?? 0);
    });
  }

  /** Adds dabs after a stroke's others, all or none; what a dab leaves out has the ABI's default. */
  addDabs(stroke: LayerHandle, dabs: readonly Partial<Dab>[]): void {
    const core = this.#core;
    const plain = core.collect(DabLayout.byteSize, (out) => core.call("txc_dab_default", out));
    const bytes = new Uint8Array(dabs.length * DabLayout.byteSize);
    const view = new DataView(bytes.buffer);
    dabs.forEach((dab, index) => {
      bytes.set(plain, index * DabLayout.byteSize);
      writeStruct(DabLayout, view, index * DabLayout.byteSize, dab);
    });
    core.withBytes(bytes, (pointer) => {
      core.run("txc_stroke_add_dabs", this.#session, stroke, pointer, dabs.length);
    });
  }

  /** Takes all dabs of a stroke away. */
  clearDabs(stroke: LayerHandle): void {
    this.#core.run("txc_stroke_clear", this.#session, stroke);
  }

  /** A stroke's dabs as they were given. */
  dabs(stroke: LayerHandle): Dab[] {
    const core = this.#core;
    const count = core.collectU32((out) => core.run("txc_stroke_dab_count", this.#session, stroke, out));
    const bytes = core.collect(count * DabLayout.byteSize, (out) => {
      core.run("txc_stroke_dabs", this.#session, stroke, 0, count, out);
    });
    const view = new DataView(bytes.buffer);
    return Array.from({ length: count }, (_, index) => readStruct(DabLayout, view, index * DabLayout.byteSize));
  }

  /**
   * Projects and composites what changed since the update before.
   * @param into memory for the update's bytes, written over where it is large enough; the caller's from then on, as any
   * @param workLimit of projections, in texels about (texelcast.h); 0 shows what is there so far
   */
  update(into?: ArrayBuffer, workLimit = NONE): CoreUpdate {
    const core = this.#core;
    const update = core.collectStruct(UpdateLayout, (out) => {
      core.run("txc_target_update", this.#session, this.#handle, workLimit, out);
    });
    const rects: Rect[] = [];
    const rectPointer = core.call("txc_target_update_rects", this.#session, this.#handle);
    for (let i = 0; i < update.rectCount; i++) {
      rects.push(core.readStructAt(RectLayout, rectPointer + i * RectLayout.byteSize));
    }
    return {
      rects,
      bytes: this.#pack(rects, update.byteCount, into),
      projectedLayers: update.projectedLayers,
      projectedTexels: update.projectedTexels,
      compositedTexels: update.compositedTexels,
      unfinished: update.unfinished !== 0,
    };
  }

  /** Row by row from the levels, so that each texel is copied once on its way out. */
  #pack(rects: readonly Rect[], byteCount: number, into?: ArrayBuffer): Uint8Array<ArrayBuffer> {
    // Fresh memory of some megabytes costs more than the copy.
    const packed =
      into && into.byteLength >= byteCount ? new Uint8Array(into, 0, byteCount) : new Uint8Array(byteCount);
    const { width } = this.info();
    for (const rect of rects) {
      const level = this.#core.call("txc_target_level", this.#session, this.#handle, rect.level);
      const stride = Math.max(1, width >> rect.level) * 4;
      const first = level + rect.y * stride + rect.x * 4;
      this.#core.copyRows(first, stride, rect.width * 4, rect.height, packed, rect.byteOffset);
    }
    return packed;
  }

  /** Rows of a zone's cover (its place in the session's list; null: of any), bleed included: 0 to 255 a texel. */
  zoneMask(zone: number | null, row: number, rowCount: number): Uint8Array<ArrayBuffer> {
    this.#checkRows(row, rowCount);
    return this.#core.collect(this.info().width * rowCount, (out) => {
      this.#core.run("txc_zone_mask", this.#session, this.#handle, zone ?? NONE, row, rowCount, out);
    });
  }

  /** What a zone's surface is like; null: all of the material's. */
  zoneSurface(zone: number | null): ZoneSurface {
    return this.#core.collectStruct(ZoneSurfaceLayout, (out) => {
      this.#core.run("txc_zone_surface", this.#session, this.#handle, zone ?? NONE, out);
    });
  }

  /** Rows of what a layer is like on the surface (abi.ts, `PrintMaps`): one float a texel, 0 where it paints nothing. */
  printMap(layer: LayerHandle, kind: number, row: number, rowCount: number): Float32Array<ArrayBuffer> {
    this.#checkRows(row, rowCount);
    const bytes = this.#core.collect(this.info().width * rowCount * 4, (out) => {
      this.#core.run("txc_layer_print_map", this.#session, layer, kind, row, rowCount, out);
    });
    return new Float32Array(bytes.buffer);
  }

  /** A copy of a rectangle of a level as of the newest update, RGBA. */
  read(level: number, x: number, y: number, width: number, height: number): Uint8Array<ArrayBuffer> {
    return this.#core.collect(width * height * 4, (out) => {
      this.#core.run("txc_target_read", this.#session, this.#handle, level, x, y, width, height, out);
    });
  }

  /** Rows of level 0 as they are exported: colour bled outward from charts that layers changed (spec.md, 6). RGBA. */
  readBled(row: number, rowCount: number, width: number): Uint8Array<ArrayBuffer> {
    return this.#core.collect(rowCount * width * 4, (out) => {
      this.#core.run("txc_target_read_bled", this.#session, this.#handle, row, rowCount, out);
    });
  }

  /** 64-bit FNV-1a over a rectangle of level 0: 16 hex digits, high word first. */
  hash(x: number, y: number, width: number, height: number): string {
    const bytes = this.#core.collect(8, (out) => {
      this.#core.run("txc_target_hash", this.#session, this.#handle, x, y, width, height, out);
    });
    return new DataView(bytes.buffer).getBigUint64(0, true).toString(16).padStart(16, "0");
  }
}
