/** The design under edit: its history, the selection, and the engine's and the viewer's copies of it. */
import type { Engine, EngineLayer } from "../../engine/engine-api.ts";
import { pictureOf, withPicture } from "../../engine/layer-picture.ts";
import type { ModelViewer, ViewerDecal } from "../../viewer/viewer-api.ts";
import { type Design, type DesignLayer, emptyDesign, materialsOf, resolveLayers } from "../document/index.ts";
import type { AssetLibrary } from "./asset-library.ts";
import { layerById } from "./design-edits.ts";
import type { EditorState, ModelRef, Snapshot } from "./editor-state.ts";
import { History } from "./history.ts";
import type { Store } from "./store.ts";

export interface DesignSessionParts {
  readonly engine: Engine;
  readonly viewer: ModelViewer;
  readonly library: AssetLibrary;
  readonly store: Store<EditorState>;
}

/** Models kept for an undo across them; older steps are dropped, since a model may weigh a hundred megabytes. */
const MODELS_KEPT = 3;

export class DesignSession {
  readonly #engine: Engine;
  readonly #viewer: ModelViewer;
  readonly #library: AssetLibrary;
  readonly #store: Store<EditorState>;
  readonly #history = new History<Snapshot>({ design: emptyDesign(), model: null });
  #saved: Design = this.#history.present.design;
  #sent: Design | null = null;
  #revision = 0;

  constructor({ engine, viewer, library, store }: DesignSessionParts) {
    this.#engine = engine;
    this.#viewer = viewer;
    this.#library = library;
    this.#store = store;
  }

  get design(): Design {
    return this.#history.present.design;
  }

  /** The design without what a gesture only shows so far. */
  get recordedDesign(): Design {
    return this.#history.recorded.design;
  }

  get revision(): number {
    return this.#revision;
  }

  get selected(): DesignLayer | undefined {
    return layerById(this.design, this.#store.state.selectedId);
  }

  get undoSnapshot(): Snapshot | undefined {
    return this.#history.undoValue;
  }

  get redoSnapshot(): Snapshot | undefined {
    return this.#history.redoValue;
  }

  /** Shows a design without recording it (a gesture is under way). */
  preview(design: Design): void {
    if (this.#store.state.switching) return;
    this.#history.preview({ ...this.#history.recorded, design });
    this.#publish();
  }

  cancelPreview(): void {
    if (!this.#history.previewing) return;
    this.#history.cancelPreview();
    this.#publish();
  }

  /** One step of the history. Steps of the same `mergeKey` close together in time are one. */
  record(design: Design, label: string, mergeKey?: string): void {
    if (this.#store.state.switching) return;
    // A preview that came back to where it began is no step.
    const unchanged = design === this.#history.recorded.design;
    this.#history.record(unchanged ? this.#history.recorded : { ...this.#history.recorded, design }, label, mergeKey);
    this.#publish();
  }

  /** A model took the place of another, with a design of its own: one step that brings both back when undone. */
  recordModel(model: ModelRef, design: Design, label: string): void {
    if (this.#history.recorded.model === null) this.#history.reset({ model, design });
    else this.#history.record({ model, design }, label);
    this.#forgetOldModels();
    this.#saved = design;
    this.#publish();
  }

  undo(): void {
    this.#history.undo();
    this.#publish();
  }

  redo(): void {
    this.#history.redo();
    this.#publish();
  }

  markSaved(): void {
    this.#saved = this.recordedDesign;
    this.#publish();
  }

  select(id: string | null): void {
    const selectedId = layerById(this.design, id) ? id : null;
    this.#store.set({ selectedId });
    this.#showDecals();
  }

  /** Gives the engine the layers of a design that is not the recorded one yet (its model is being opened). */
  send(design: Design): void {
    this.#revision += 1;
    this.#sent = design;
    this.#engine.setLayers(this.#engineLayers(design), this.#revision);
  }

  #engineLayers(design: Design): EngineLayer[] {
    return resolveLayers(design).map((layer) => {
      const asset = pictureOf(layer);
      const picture = asset === null ? undefined : this.#library.get(design.assets[asset]);
      return picture ? withPicture(layer, picture.engineKey) : layer;
    });
  }

  #publish(): void {
    const { design } = this;
    if (design.layers !== this.#sent?.layers) this.send(design);
    const { selectedId } = this.#store.state;
    this.#store.set({
      design,
      selectedId: layerById(design, selectedId) ? selectedId : null,
      undoLabel: this.#history.undoLabel,
      redoLabel: this.#history.redoLabel,
      unsaved: this.recordedDesign !== this.#saved,
    });
    this.#showDecals();
  }

  #showDecals(): void {
    const { design } = this;
    const decals = design.layers
      .filter((layer) => layer.type === "decal")
      .map((layer): ViewerDecal => {
        const picture = this.#library.get(design.assets[layer.asset]);
        const { id, name, visible, projector } = layer;
        const aspect = picture ? picture.width / picture.height : 1;
        return { id, name, materials: materialsOf(layer), visible, projector, aspect };
      });
    this.#viewer.setDecals(decals, this.#store.state.selectedId);
  }

  #forgetOldModels(): void {
    const newest = [...new Set([...this.#history.values()].map(({ model }) => model).reverse())].slice(0, MODELS_KEPT);
    this.#history.dropOldest(({ model }) => !newest.includes(model));
  }
}
