/** A session of the core: one model, its targets, and the decals' pictures. All calls are synchronous. */
import {
  type CoreMaterialInfo,
  type CoreModelInfo,
  type CoreZone,
  type LayerMetrics,
  LayerMetricsLayout,
  MaterialInfoLayout,
  MeshDefLayout,
  ModelInfoLayout,
  type SessionDef,
  SessionDefLayout,
  type SessionStats,
  SessionStatsLayout,
  type TargetDef,
  TargetDefLayout,
  ZoneLayout,
} from "./abi.ts";
import { writeStruct } from "./struct-layout.ts";
import { type LayerHandle, Target } from "./target.ts";
import { TexelcastError } from "./texelcast-error.ts";
import type { CoreModule } from "./wasm-module.ts";

/** One mesh as a three.js BufferGeometry has it. */
export interface MeshArrays {
  /** Three a vertex, metres, model space. */
  readonly positions: Float32Array;
  /** Three a vertex; without them, flat face normals. */
  readonly normals?: Float32Array | null;
  /** Two a vertex. */
  readonly uvs?: Float32Array | null;
  /** Without them, every three vertices are a triangle. */
  readonly indices?: Uint16Array | Uint32Array | null;
  /** Below 1024; default 0. */
  readonly material?: number;
}

/** A picture of the session by its handle. */
export type ImageHandle = number & { readonly brand?: "TxcImage" };

export class Session {
  readonly core: CoreModule;
  readonly #handle: number;

  private constructor(core: CoreModule, handle: number) {
    this.core = core;
    this.#handle = handle;
  }

  static create(core: CoreModule, def: Partial<SessionDef> = {}): Session {
    const handle = core.withStruct(SessionDefLayout, "txc_session_def_default", def, (defPointer) =>
      core.collectU32((out) => core.run("txc_session_create", defPointer, out)),
    );
    return new Session(core, handle);
  }

  /** Ends the session and everything in it. */
  destroy(): void {
    this.core.run("txc_session_destroy", this.#handle);
  }

  stats(): SessionStats {
    return this.core.collectStruct(SessionStatsLayout, (out) => this.core.run("txc_session_stats", this.#handle, out));
  }

  /** Loads a GLB (no Draco, no meshopt) in place of the model before; targets end. A failed load changes nothing. */
  loadGlb(bytes: Uint8Array): void {
    this.core.withBytes(bytes, (pointer) => {
      this.core.run("txc_model_load_glb", this.#handle, pointer, bytes.byteLength);
    });
  }

  /** Adds raw arrays to the session's model, or starts one; targets end. Throws "bad-argument" naming an array of a wrong length. */
  addMesh(mesh: MeshArrays): void {
    const vertexCount = mesh.positions.length / 3;
    checkLength("positions", mesh.positions, Math.ceil(vertexCount) * 3);
    checkLength("normals", mesh.normals, vertexCount * 3);
    checkLength("uvs", mesh.uvs, vertexCount * 2);
    const indices = mesh.indices instanceof Uint16Array ? Uint32Array.from(mesh.indices) : (mesh.indices ?? null);
    const def = { vertexCount, indexCount: indices?.length ?? 0, material: mesh.material ?? 0 };
    const { core } = this;
    core.withStruct(MeshDefLayout, "txc_mesh_def_default", def, (defPointer) =>
      core.withBytes(mesh.positions, (positions) =>
        core.withBytes(mesh.normals ?? null, (normals) =>
          core.withBytes(mesh.uvs ?? null, (uvs) =>
            core.withBytes(indices, (indexPointer) => {
              core.run("txc_model_add_mesh", this.#handle, defPointer, positions, normals, uvs, indexPointer);
            }),
          ),
        ),
      ),
    );
  }

  modelInfo(): CoreModelInfo {
    return this.core.collectStruct(ModelInfoLayout, (out) => this.core.run("txc_model_info", this.#handle, out));
  }

  materialInfo(material: number): CoreMaterialInfo {
    return this.core.collectStruct(MaterialInfoLayout, (out) =>
      this.core.run("txc_material_info", this.#handle, material, out),
    );
  }

  /** Six numbers (u, v of three corners) for each of the material's triangles. */
  materialUvs(material: number): Float32Array<ArrayBuffer> {
    const { triangleCount } = this.materialInfo(material);
    const bytes = this.core.collect(triangleCount * 24, (out) => {
      this.core.run("txc_material_uvs", this.#handle, material, out, triangleCount);
    });
    return new Float32Array(bytes.buffer);
  }

  /** A new target; bake it before anything is read. */
  createTarget(def: Partial<TargetDef> = {}): Target {
    const { core } = this;
    const handle = core.withStruct(TargetDefLayout, "txc_target_def_default", def, (defPointer) =>
      core.collectU32((out) => core.run("txc_target_create", this.#handle, defPointer, out)),
    );
    return new Target(core, this.#handle, handle);
  }

  /** Takes these for the session's zones; `corners`: u and v for each corner of their polygons. */
  setZones(zones: readonly Partial<CoreZone>[], corners: Float32Array): void {
    const { core } = this;
    const plain = core.collect(ZoneLayout.byteSize, (out) => core.call("txc_zone_default", out));
    const bytes = new Uint8Array(Math.max(1, zones.length) * ZoneLayout.byteSize);
    const view = new DataView(bytes.buffer);
    zones.forEach((zone, index) => {
      bytes.set(plain, index * ZoneLayout.byteSize);
      writeStruct(ZoneLayout, view, index * ZoneLayout.byteSize, zone);
    });
    core.withBytes(bytes, (pointer) =>
      core.withBytes(corners, (cornerPointer) => {
        const { length } = zones;
        core.run("txc_session_set_zones", this.#handle, pointer, length, cornerPointer, corners.length / 2);
      }),
    );
  }

  /** Measures a layer: its handles on all targets that it paints. `zoneShares`: one for each of `zoneCount` zones. */
  measureLayer(
    layers: readonly LayerHandle[],
    zoneCount: number,
  ): { readonly metrics: LayerMetrics; readonly zoneShares: Float32Array<ArrayBuffer> } {
    const { core } = this;
    return core.withBytes(Uint32Array.from(layers), (handles) =>
      core.withMemory(zoneCount * 4, (shares) => {
        const metrics = core.collectStruct(LayerMetricsLayout, (out) => {
          core.run("txc_layer_metrics", this.#handle, handles, layers.length, out, shares);
        });
        return { metrics, zoneShares: new Float32Array(core.copyOut(shares, zoneCount * 4).buffer) };
      }),
    );
  }

  /** Copies a picture (RGBA, straight alpha, row 0 at the top) into the session, for layers to use. */
  createImage(width: number, height: number, rgba: Uint8Array): ImageHandle {
    checkLength("rgba", rgba, width * height * 4);
    return this.core.withBytes(rgba, (pointer) =>
      this.core.collectU32((out) => this.core.run("txc_image_create", this.#handle, width, height, pointer, out)),
    );
  }

  /** Layers that use the picture turn transparent. */
  destroyImage(image: ImageHandle): void {
    this.core.run("txc_image_destroy", this.#handle, image);
  }
}

/** The core trusts its counts, so an array of another length must not get that far. */
function checkLength(name: string, array: { readonly length: number } | null | undefined, wanted: number): void {
  if (array === null || array === undefined || array.length === wanted) return;
  throw new TexelcastError("bad-argument", `“${name}” has ${array.length} numbers where ${wanted} are needed.`, {
    field: name,
    value: String(array.length),
  });
}
