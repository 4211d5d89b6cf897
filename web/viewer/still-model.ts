/** A model as it is shown: its scene, its bounds, its materials. */
import type { Box3, WebGLRenderer } from "three";
import { boundsOf } from "./camera-framing.ts";
import { partsOf } from "./model-parts.ts";
import { type ModelScene, positionsOf, shapedMeshes } from "./model-scene.ts";
import { PaintedMaterials } from "./painted-materials.ts";
import { HIDDEN_LAYER, MODEL_LAYER } from "./view-layers.ts";
import type { ModelPart } from "./viewer-api.ts";

export class StillModel {
  readonly scene: ModelScene;
  /** Vertices at rest, three numbers each. */
  readonly positions: Float32Array;
  readonly bounds: Box3;
  readonly parts: readonly ModelPart[];
  readonly materials: PaintedMaterials;
  #hidden: ReadonlySet<number> = new Set();

  constructor(renderer: WebGLRenderer, scene: ModelScene) {
    this.scene = scene;
    this.positions = positionsOf(scene);
    this.bounds = boundsOf(this.positions);
    this.parts = partsOf(scene);
    this.materials = new PaintedMaterials(renderer, scene);
  }

  /** Parts that are not drawn. */
  get hidden(): ReadonlySet<number> {
    return this.#hidden;
  }

  hide(parts: ReadonlySet<number>): void {
    this.#hidden = parts;
    for (const [place, mesh] of shapedMeshes(this.scene).entries()) {
      mesh.layers.set(parts.has(place) ? HIDDEN_LAYER : MODEL_LAYER);
    }
  }

  dispose(): void {
    this.materials.dispose();
    this.scene.root.removeFromParent();
    this.scene.dispose();
  }
}
