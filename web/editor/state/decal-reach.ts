/** Which materials a decal paints from where it lies, and how that follows it when it is moved. */

import type { MaterialInfo, Projector } from "../../engine/engine-api.ts";
import type { ModelViewer } from "../../viewer/viewer-api.ts";
import { type LayerMaterials, layerMaterials, type Mirror, materialsOf, type PlacedLayer } from "../document/design.ts";
import { mirroredProjector } from "../document/mirror-layer.ts";

export class DecalReach {
  readonly #viewer: Pick<ModelViewer, "materialsReached">;
  readonly #materials: () => readonly MaterialInfo[];
  /** Asked in each frame of a drag, of the layer as it was before. */
  readonly #follows = new WeakMap<PlacedLayer, boolean>();

  constructor(viewer: Pick<ModelViewer, "materialsReached">, materials: () => readonly MaterialInfo[]) {
    this.#viewer = viewer;
    this.#materials = materials;
  }

  /** All paintable materials that a projector reaches, and its twin with a mirror; `otherwise` where they reach none. */
  at(projector: Projector, backfaces: boolean, otherwise: number, mirror: Mirror | null = null): LayerMaterials {
    const reached = this.#paintable(projector, backfaces, mirror);
    return reached.length === 0 ? otherwise : layerMaterials(reached);
  }

  /** All paintable materials that a projector reaches. */
  all(projector: Projector, backfaces: boolean): readonly number[] {
    return this.#paintable(projector, backfaces);
  }

  /** The material of the surface that a projector was put on, where that takes no paint and neither does all else that it reaches. */
  bareOf(projector: Projector, backfaces: boolean, onto: number | null): MaterialInfo | null {
    const material = this.#materials().find(({ index }) => index === onto);
    if (!material || material.refusal === null) return null;
    return this.#paintable(projector, backfaces).length === 0 ? material : null;
  }

  /**
   * The materials of a decal that was moved, or given another mirror. One that painted everything it reached goes on to do so:
   * over a border it paints both sides, and dragged onto what takes no paint it waits there for the model to be unwrapped. One that
   * was kept off a material it reached stays on its own, until it is dragged onto another.
   *
   * @param onto the material of the surface that it was dragged onto; null where it was moved without touching one
   */
  movedTo(layer: PlacedLayer, projector: Projector, onto: number | null, mirror = layer.mirror): LayerMaterials {
    const own = materialsOf(layer);
    const met = onto !== null && !own.includes(onto) ? onto : layer.material;
    if (!this.#followsSurface(layer)) return typeof met === "number" && this.#canPaint(met) ? met : layer.material;
    const reached = this.#paintable(projector, layer.backfaces, mirror);
    return reached.length === 0 ? met : layerMaterials(reached);
  }

  #followsSurface(layer: PlacedLayer): boolean {
    const known = this.#follows.get(layer);
    if (known !== undefined) return known;
    const own = materialsOf(layer);
    const { projector, backfaces, mirror } = layer;
    const follows = this.#paintable(projector, backfaces, mirror).every((material) => own.includes(material));
    this.#follows.set(layer, follows);
    return follows;
  }

  #paintable(projector: Projector, backfaces: boolean, mirror: Mirror | null = null): number[] {
    // Most models have one material, and then there is nothing to ask.
    const paintable = this.#materials().filter(({ refusal }) => refusal === null);
    if (this.#materials().length < 2) return paintable.map(({ index }) => index);
    const twin = mirror && mirroredProjector(projector, mirror);
    const reached = [projector, ...(twin ? [twin] : [])].flatMap((each) =>
      this.#viewer.materialsReached(each, backfaces),
    );
    return [...new Set(reached)].filter((material) => this.#canPaint(material)).sort((a, b) => a - b);
  }

  #canPaint(material: number): boolean {
    return this.#materials().some(({ index, refusal }) => index === material && refusal === null);
  }
}
