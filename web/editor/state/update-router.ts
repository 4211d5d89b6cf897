/**
 * Brings the engine's updates to the two views, or to one where there is no flat view. A view can take an update only for a target that it was told of, so
 * updates that arrive early wait for `bind`.
 */
import type { Engine, TargetInfo, TargetUpdate } from "../../engine/engine-api.ts";
import type { ModelView, TextureView } from "../../viewer/viewer-api.ts";
import type { Figures } from "./editor-state.ts";
import type { Store } from "./store.ts";

export class UpdateRouter {
  readonly #engine: Engine;
  readonly #viewer: ModelView;
  readonly #textureView: TextureView | null;
  readonly #figures: Store<Figures>;
  readonly #bound = new Map<number, TargetInfo>();
  readonly #early = new Map<number, TargetUpdate[]>();
  #textureMaterial: number | null = null;

  constructor(engine: Engine, viewer: ModelView, textureView: TextureView | null, figures: Store<Figures>) {
    this.#engine = engine;
    this.#viewer = viewer;
    this.#textureView = textureView;
    this.#figures = figures;
    engine.onUpdate((update) => this.#receive(update));
  }

  /** The material that the texture view was told to show; null for none. */
  get textureMaterial(): number | null {
    return this.#textureMaterial;
  }

  /** Forgets every target: the engine has another model now. */
  clear(): void {
    this.#bound.clear();
    this.#early.clear();
    this.#textureMaterial = null;
  }

  /** All of the texture is seen, wherever the one before it had been moved to. */
  showWholeTexture(): void {
    this.#textureView?.resetZoom();
  }

  /**
   * To be called when the engine has said that the target is open, and the views have its model: what came of it until then is
   * applied. With `uvTriangles` the texture view shows this target from now on.
   */
  bind(info: TargetInfo, uvTriangles: Float32Array | null): void {
    this.#bound.set(info.material, info);
    this.#viewer.bindTarget(info);
    if (uvTriangles) {
      this.#textureMaterial = info.material;
      this.#textureView?.bindTarget(info, uvTriangles);
    }
    const early = this.#early.get(info.material) ?? [];
    this.#early.delete(info.material);
    for (const update of early) this.#apply(update);
  }

  /** Shows a target that was bound before in the texture view. */
  async showInTextureView(info: TargetInfo, uvTriangles: Float32Array): Promise<void> {
    this.#textureMaterial = info.material;
    this.#textureView?.bindTarget(info, uvTriangles);
    this.#textureView?.applyUpdate(await this.#fullUpdate(info));
  }

  async #fullUpdate(info: TargetInfo): Promise<TargetUpdate> {
    const { material, width, height } = info;
    const bytes = await this.#engine.readTexels(material, 0, 0, width, height);
    return {
      material,
      revision: this.#figures.state.update?.revision ?? 0,
      rects: [{ x: 0, y: 0, width, height, level: 0, byteOffset: 0 }],
      bytes,
      projectedLayers: 0,
      projectedTexels: 0,
      compositedTexels: 0,
      milliseconds: 0,
    };
  }

  #receive(update: TargetUpdate): void {
    if (this.#bound.has(update.material)) {
      this.#apply(update);
      return;
    }
    const waiting = this.#early.get(update.material);
    if (waiting) waiting.push(update);
    else this.#early.set(update.material, [update]);
  }

  #apply(update: TargetUpdate): void {
    const isFlat = update.material === this.#textureMaterial && this.#textureView !== null;
    const isShown = this.#viewer.applyUpdate(update);
    const isShownFlat = isFlat ? this.#textureView.applyUpdate(update) : true;
    if (isShown && isShownFlat) free(update.bytes);
    const { material, revision, projectedTexels, compositedTexels, milliseconds } = update;
    this.#figures.set({
      update: { material, revision, projectedTexels, compositedTexels, milliseconds },
      uploadMilliseconds: this.#viewer.statistics.uploadMilliseconds,
      updates: this.#figures.state.updates + 1,
    });
  }
}

/**
 * Gives the memory of bytes back now instead of when the browser next collects garbage: a drag at 2048 x 2048 brings 3.8 MB a move.
 */
function free({ buffer }: Uint8Array): void {
  // Not in the types of ES2023, nor in browsers before 2024.
  (buffer as ArrayBuffer & { transfer?: (length: number) => ArrayBuffer }).transfer?.(0);
}
