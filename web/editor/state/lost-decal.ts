/** A decal or a text that is moved, turned or sized until it lies beside the model: little or nothing is seen of it, which is said. */
import type { Projector } from "../../engine/engine-api.ts";
import type { ModelViewer } from "../../viewer/viewer-api.ts";
import { type Design, isPlaced, type PlacedLayer } from "../document/design.ts";
import { mirroredProjector } from "../document/mirror-layer.ts";
import { layerById } from "./design-edits.ts";
import type { OpenModel } from "./design-state.ts";
import type { NoticeBoard } from "./notice-board.ts";

/** Of a picture's sides, about its middle: what meets no surface with that shows a sliver at most. */
const CORE = 0.8;

export class LostDecal {
  readonly #viewer: Pick<ModelViewer, "materialsReached">;
  readonly #board: NoticeBoard;
  #model: OpenModel | null = null;
  #design: Design | null = null;
  /** What was told, of which layer. */
  #told: { readonly layer: string; readonly notice: number } | null = null;

  constructor(viewer: Pick<ModelViewer, "materialsReached">, board: NoticeBoard) {
    this.#viewer = viewer;
    this.#board = board;
  }

  /** A step was recorded, or travelled to. */
  follow(model: OpenModel | null, design: Design, selectedId: string | null): void {
    const before = model === this.#model ? this.#design : null;
    this.#model = model;
    this.#design = design;
    if (this.#told !== null && !this.#isStillLost(design, this.#told.layer, before)) {
      this.#board.dismiss(this.#told.notice);
      this.#told = null;
    }
    const [old, layer] = [placedIn(before, selectedId), placedIn(design, selectedId)];
    if (!old || !layer || old.projector === layer.projector || this.#told !== null) return;
    if (!this.#isLost(layer) || this.#isLost(old)) return;
    const { lostDecal, lostDecalWhy } = this.#board.strings.notices;
    const notice = this.#board.info({ title: lostDecal(layer.name), message: lostDecalWhy, stays: true });
    this.#told = { layer: layer.id, notice };
  }

  #isStillLost(design: Design, id: string, before: Design | null): boolean {
    const [old, layer] = [placedIn(before, id), placedIn(design, id)];
    return old !== undefined && layer !== undefined && (old === layer || this.#isLost(layer));
  }

  #isLost({ projector, mirror, backfaces }: PlacedLayer): boolean {
    const twin = mirror && mirroredProjector(projector, mirror);
    return [projector, ...(twin ? [twin] : [])].every((each) => {
      const core = coreOf(each);
      return core !== null && this.#viewer.materialsReached(core, backfaces).length === 0;
    });
  }
}

function placedIn(design: Design | null, id: string | null): PlacedLayer | undefined {
  const layer = design === null ? undefined : layerById(design, id);
  return isPlaced(layer) ? layer : undefined;
}

/** The middle of what a projector throws; null for a flat stamp, which lies on no side of the model. */
function coreOf(projector: Projector): Projector | null {
  switch (projector.kind) {
    case "planar": {
      const [width, height, depth] = projector.size;
      return { ...projector, size: [CORE * width, CORE * height, depth] };
    }
    case "perspective":
      return { ...projector, fov: CORE * projector.fov };
    case "cylindrical":
      return { ...projector, arc: CORE * projector.arc, height: CORE * projector.height };
    case "uv":
      return null;
  }
}
