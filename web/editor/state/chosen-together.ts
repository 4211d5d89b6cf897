/** Several chosen decals as one: the box round them, whose handles are theirs, and what turning and sizing it makes of each. */
import type { PlanarProjector, Projector } from "../../engine/engine-api.ts";
import { sameItems } from "../../engine/same-items.ts";
import type { Arrangement, ModelViewer, ViewerDecal } from "../../viewer/viewer-api.ts";
import type { PlacedLayer } from "../document/design.ts";
import type { EditorState } from "./editor-state.ts";
import { stampsBox, stampsChanged, stampsIn, stampWith } from "./stamps-together.ts";

/** What the views call the box in place of a decal: no layer has an empty id. */
export const TOGETHER = "";

/** So many are outlined: the lines of more would hide what they are round, and cost time in each frame. */
const MOST_OUTLINED = 24;

/** What a key or a handle does to a projector of any kind. */
export type ProjectorChange = <P extends Projector>(projector: P) => P;

interface Found {
  readonly arrangement: Arrangement | null;
  /** What they lie on: another model has another surface. */
  readonly model: unknown;
  /** As the newest step has left them, and their box by then. */
  readonly projectors: readonly Projector[];
  readonly box: PlanarProjector | null;
}

export class ChosenTogether {
  readonly #viewer: Pick<ModelViewer, "arrangement" | "setDecals">;
  readonly #state: () => Pick<EditorState, "material" | "model">;
  #found: Found = { arrangement: null, model: null, projectors: [], box: null };

  constructor(
    viewer: Pick<ModelViewer, "arrangement" | "setDecals">,
    state: () => Pick<EditorState, "material" | "model">,
  ) {
    this.#viewer = viewer;
    this.#state = state;
  }

  /**
   * Shows decals, `layers` of which are chosen, locked ones apart: with handles at the box round them, or where there is none
   * at the one that is selected, or at the topmost.
   *
   * @param layers as they are recorded: a gesture that goes on has the box itself
   */
  show(decals: readonly ViewerDecal[], selectedId: string | null, layers: readonly PlacedLayer[]): void {
    const ids = new Set(layers.map(({ id }) => id));
    const chosen = decals.filter(({ id, visible }) => visible && ids.has(id));
    const own = chosen.find(({ id }) => id === selectedId) ?? chosen.at(-1);
    const box = this.#boxOf(layers.map(({ projector }) => projector));
    if (!own) {
      this.#viewer.setDecals(decals, selectedId);
      return;
    }
    // A twin in its mirror is marked, too.
    const marked = new Set([...(own.beside ?? []), ...chosen.map(({ projector }) => projector)]);
    if (!box) marked.delete(own.projector);
    const held = {
      ...own,
      // Any of them is taken hold of, also through what lies over it.
      holds: chosen,
      beside: marked.size > MOST_OUTLINED ? [] : [...marked],
      // It is no decal that a press could mean.
      ...(box && { id: TOGETHER, projector: box, visible: false }),
    };
    this.#viewer.setDecals(box ? [...decals, held] : decals.map((each) => (each === own ? held : each)), held.id);
  }

  /** What a change of all of them at once, about their common middle, makes of each. */
  changed(layers: readonly PlacedLayer[], change: ProjectorChange): readonly Projector[] {
    const projectors = layers.map(({ projector }) => projector);
    const box = this.#boxOf(projectors);
    if (!box) return stampsChanged(layers, projectors.map(change), change);
    const next = change(box);
    return this.#kept(next, stampsChanged(layers, this.#at(next), change));
  }

  /** What a drag of their box, on the model or in the texture that is shown, makes of each; `ends`: as long as they stay so. */
  dragged(layers: readonly PlacedLayer[], box: Projector, ends: boolean): readonly Projector[] {
    if (box.kind === "planar") return ends ? this.#kept(box, this.#at(box)) : this.#at(box);
    const stamps = stampsIn(layers, this.#state().material);
    const before = stampsBox(stamps);
    const dragged = new Set<PlacedLayer>(stamps);
    const stamp = ({ projector }: PlacedLayer): Projector =>
      projector.kind === "uv" && box.kind === "uv" ? stampWith(before, box, projector) : projector;
    return layers.map((layer) => (dragged.has(layer) ? stamp(layer) : layer.projector));
  }

  /** As they lie once the box that is shown is that one. */
  #at(box: PlanarProjector): readonly Projector[] {
    const { arrangement, projectors } = this.#found;
    return arrangement?.at(box) ?? projectors;
  }

  /** Many steps go out from where the first did, and leave nothing but their sum. */
  #kept(box: PlanarProjector, projectors: readonly Projector[]): readonly Projector[] {
    this.#found = { ...this.#found, projectors, box };
    return projectors;
  }

  #boxOf(projectors: readonly Projector[]): PlanarProjector | null {
    const { model } = this.#state();
    if (this.#found.model !== model || !sameItems(this.#found.projectors, projectors)) {
      const arrangement = this.#viewer.arrangement(projectors);
      this.#found = { arrangement, model, projectors, box: arrangement?.box ?? null };
    }
    return this.#found.box;
  }
}
