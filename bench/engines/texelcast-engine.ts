/** Our core in WebAssembly, called as the engine calls it. */
import { Filters, type LayerDef, LayerKinds, Occlusions, Projectors } from "../../web/core/abi.ts";
import { Session } from "../../web/core/session.ts";
import type { CoreUpdate, LayerHandle, Target } from "../../web/core/target.ts";
import { type CoreModule, loadCore } from "../../web/core/wasm-module.ts";
import type { Picture, PlanarProjector } from "../../web/engine/engine-api.ts";
import type { BenchMesh } from "../work.ts";
import type { BenchEngine, DragStep, Run } from "./engine.ts";

const ALL_OF_IT = 0xffffffff;

export class TexelcastEngine implements BenchEngine {
  readonly name: string;
  readonly #core: CoreModule;
  readonly #below: readonly PlanarProjector[];
  #mesh: BenchMesh | null = null;
  #decal: Picture | null = null;
  #session: Session | null = null;
  #target: Target | null = null;
  #newest: CoreUpdate | null = null;
  #layer: { readonly handle: LayerHandle; readonly image: number } | null = null;

  private constructor(core: CoreModule, name: string, below: readonly PlanarProjector[]) {
    this.#core = core;
    this.name = name;
    this.#below = below;
  }

  /** @param below decals that lie under the dragged one and stay where they are */
  static async create(name = "Texelcast", below: readonly PlanarProjector[] = []): Promise<TexelcastEngine> {
    return new TexelcastEngine(await loadCore(), name, below);
  }

  async load(mesh: BenchMesh, decal: Picture): Promise<void> {
    this.#mesh = mesh;
    this.#decal = decal;
  }

  /** A new session each time, since a session bakes a model once and then reuses its map. Mesh reading is not timed. */
  async bake(size: number): Promise<Run> {
    this.#session?.destroy();
    this.#layer = null;
    const session = Session.create(this.#core, { memoryBudgetMib: 3072 });
    this.#session = session;
    if (!this.#mesh) throw new Error("load comes first");
    session.addMesh(this.#mesh);
    const start = performance.now();
    const target = session.createTarget({ width: size, height: size });
    while (!target.bake(ALL_OF_IT).done);
    const milliseconds = performance.now() - start;
    this.#target = target;
    return { milliseconds, texels: target.info().coveredTexels };
  }

  /** A frame of a drag: the layer's projector changes, and the update projects, composites, and packs what changed. */
  async project({ projector, occlusion }: DragStep): Promise<Run> {
    const target = this.#target;
    if (!target) throw new Error("bake comes first");
    const layer = this.#layerOf(target);
    const start = performance.now();
    target.updateLayer(layer.handle, definition(projector, occlusion, layer.image));
    // The step ends when the bytes are packed. That they are copied out of the module comes on top, but not fresh memory
    // for them each time: the step before is done with its own.
    const update = target.update(this.#newest?.bytes.buffer);
    this.#newest = update;
    return { milliseconds: performance.now() - start, texels: update.projectedTexels };
  }

  /** A design's first picture: all layers below are made, projected and composited. The map is there already. */
  async open(size: number): Promise<Run> {
    const [session, decal] = [this.#session, this.#decal];
    if (!session || !decal) throw new Error("bake comes first");
    const image = session.createImage(decal.width, decal.height, decal.rgba);
    const target = session.createTarget({ width: size, height: size });
    target.bake(ALL_OF_IT);
    const start = performance.now();
    for (const projector of this.#below) target.createLayer(definition(projector, "none", image));
    const { projectedTexels } = target.update();
    const milliseconds = performance.now() - start;
    target.destroy();
    session.destroyImage(image);
    return { milliseconds, texels: projectedTexels };
  }

  /** What the newest step of a drag changed, for a GPU. */
  get newestUpdate(): CoreUpdate {
    if (!this.#newest) throw new Error("project comes first");
    return this.#newest;
  }

  /** A copy of the whole texture, RGBA, row 0 at the top. */
  readTexture(size: number): Uint8Array {
    if (!this.#target) throw new Error("bake comes first");
    return this.#target.read(0, 0, 0, size, size);
  }

  /** What the newest bake's map holds at rest, all that is derived from it included. */
  map(): { readonly bytes: number; readonly coveredTexels: number; readonly gutterTexels: number } {
    const target = this.#target;
    if (!target) throw new Error("bake comes first");
    const { byteCount, coveredTexels, gutterTexels } = target.info();
    return { bytes: byteCount, coveredTexels, gutterTexels };
  }

  #layerOf(target: Target): { readonly handle: LayerHandle; readonly image: number } {
    if (this.#layer) return this.#layer;
    if (!this.#session || !this.#decal) throw new Error("load comes first");
    const image = this.#session.createImage(this.#decal.width, this.#decal.height, this.#decal.rgba);
    for (const projector of this.#below) target.createLayer(definition(projector, "none", image));
    const invisible = { kind: LayerKinds.decal, image, visible: 0 };
    this.#layer = { handle: target.createLayer(invisible), image };
    // The first update reports the whole texture, which is no part of a drag.
    target.update();
    return this.#layer;
  }

  close(): void {
    this.#session?.destroy();
  }
}

/** As the shared designs have it: a hard angle. */
function definition(
  { position, rotation, size }: PlanarProjector,
  occlusion: DragStep["occlusion"],
  image: number,
): Partial<LayerDef> {
  return {
    kind: LayerKinds.decal,
    image,
    filter: Filters.linear,
    projector: Projectors.planar,
    occlusion: Occlusions[occlusion],
    angleFadeStart: 90,
    angleFadeEnd: 90,
    positionModel: [...position],
    rotation: [...rotation],
    size: [...size],
  };
}
