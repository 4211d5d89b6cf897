/** The design under edit: its history, the selection, and the engine's and the viewer's copies of it. */

import type { Engine, EngineLayer } from "../../engine/engine-api.ts";
import { withKeys } from "../../engine/layer-picture.ts";
import type { ModelView, ViewerDecal } from "../../viewer/viewer-api.ts";
import { type Design, type DesignLayer, emptyDesign, isPlaced, materialsOf } from "../document/design.ts";
import { walkLayers } from "../document/layer-tree.ts";
import { mirroredProjector } from "../document/mirror-layer.ts";
import { resolveLayers } from "../document/resolve-layers.ts";
import type { AssetLibrary } from "./asset-library.ts";
import { layerById } from "./design-edits.ts";
import type { DesignState, HistorySteps, ModelRef, Snapshot } from "./design-state.ts";

import { History } from "./history.ts";
import { OpenWork } from "./open-work.ts";
import type { Store } from "./store.ts";

export interface DesignSessionParts {
  readonly engine: Engine;
  readonly viewer: Pick<ModelView, "setDecals">;
  readonly library: AssetLibrary;
  readonly store: Store<DesignState>;
  /** Sees to work that goes on after a call, and tells the user where it fails. */
  readonly later: (work: Promise<void>) => void;
}

export class DesignSession {
  readonly #engine: Engine;
  readonly #viewer: Pick<ModelView, "setDecals">;
  readonly #library: AssetLibrary;
  readonly #store: Store<DesignState>;
  readonly #later: (work: Promise<void>) => void;
  readonly #history = new History<Snapshot>({ design: emptyDesign(), model: null });
  #saved: Design = this.#history.present.design;
  #sent: Design | null = null;
  #revision = 0;
  readonly #recording = new OpenWork();

  constructor({ engine, viewer, library, store, later }: DesignSessionParts) {
    this.#engine = engine;
    this.#viewer = viewer;
    this.#library = library;
    this.#store = store;
    this.#later = later;
  }

  get design(): Design {
    return this.#history.present.design;
  }

  /** The design without what a gesture only shows so far. */
  get recordedDesign(): Design {
    return this.#history.recorded.design;
  }

  /** The newest recorded step: the design and the model that it is for. */
  get recorded(): Snapshot {
    return this.#history.recorded;
  }

  get revision(): number {
    return this.#revision;
  }

  get selected(): DesignLayer | undefined {
    return layerById(this.design, this.#store.state.selectedId);
  }

  /** Place of the recorded design among the history's steps. */
  get position(): number {
    return this.#history.position;
  }

  /** What `travelTo` would bring back. */
  snapshotAt(position: number): Snapshot | undefined {
    return this.#history.valueAt(position);
  }

  /** Against the wrong model, or where it is only looked at, the design must not be edited. */
  get #closed(): boolean {
    const { switching, readonly } = this.#store.state;
    return switching || readonly;
  }

  /** Shows a design without recording it (a gesture is under way). */
  preview(design: Design): void {
    if (this.#closed) return;
    this.#history.preview({ ...this.#history.recorded, design });
    this.#publish();
  }

  /** False where none was shown. */
  cancelPreview(): boolean {
    const { previewing } = this.#history;
    this.#history.cancelPreview();
    if (previewing) this.#publish();
    return previewing;
  }

  /** One step of the history. Steps of the same `mergeKey` close together in time are one. */
  record(design: Design, label: string, mergeKey?: string): void {
    if (this.#closed) return;
    // A preview that came back to where it began is no step.
    const unchanged = design === this.#history.recorded.design;
    this.#history.record(unchanged ? this.#history.recorded : { ...this.#history.recorded, design }, label, mergeKey);
    this.#publish();
    this.#sweep();
  }

  /** Counts work as under way whose end records a step: a stroke was released, and its picture is still being written. */
  recordsLater(work: Promise<unknown>): void {
    this.#recording.add(work);
  }

  /** Whether something is under way that `settled` waits for. */
  get recording(): boolean {
    return this.#recording.underWay;
  }

  /** Resolves when all that the user has done is recorded, or has failed: what goes back, saves or exports waits for it. */
  settled(): Promise<void> {
    return this.#recording.settled();
  }

  /** A model took the place of another, with a design of its own: one step that brings both back when undone. */
  recordModel(model: ModelRef, design: Design, label: string): void {
    if (this.#history.recorded.model === null) this.#history.reset({ model, design });
    else this.#history.record({ model, design }, label);
    this.#saved = design;
    this.#publish();
    this.#sweep();
  }

  /** All of its steps, for the session that comes after it. */
  get steps(): History<Snapshot> {
    return this.#history;
  }

  /**
   * Goes on with the steps of a session that has ended, where the design that it ended at is the one that was opened: they are
   * the design's, whatever engine and view had shown it.
   */
  resume(before: History<Snapshot>): void {
    const history = this.#history;
    const { model, design } = history.recorded;
    if (before.recorded.design !== design) return;
    for (const [at, label] of before.labels.entries()) {
      const value = { ...(before.valueAt(at) as Snapshot), model };
      if (at === 0) history.reset(value);
      else history.record(value, label);
    }
    this.travelTo(before.position);
  }

  travelTo(position: number): void {
    this.#history.travelTo(position);
    this.#publish();
    this.#sweep();
  }

  /** Bytes that the history's steps may hold; steps that no longer fit are dropped, the oldest first. */
  setHistoryBudget(bytes: number): void {
    this.#history.budget = bytes;
    this.#publish();
    this.#sweep();
  }

  /** What was written to a file, while the user may have gone on. */
  markSaved(design = this.recordedDesign): void {
    this.#saved = design;
    this.#publish();
  }

  /** Chooses a layer, and with `others` more beside it. */
  select(id: string | null, others: readonly string[] = []): void {
    this.#store.set(this.#present(id, others));
    this.#showDecals();
  }

  /** Of a choice what the design has, the layer itself first. */
  #present(
    id: string | null,
    others: readonly string[],
  ): Pick<DesignState, "selectedId" | "selection" | "editingMask"> {
    const { design } = this;
    const selection = [...new Set(id === null ? others : [id, ...others])].filter((each) => layerById(design, each));
    const { selection: before, editingMask } = this.#store.state;
    const same = selection.length === before.length && selection.every((each, index) => each === before[index]);
    const selectedId = selection[0] ?? null;
    return {
      selectedId,
      selection: same ? before : selection,
      editingMask: layerById(design, selectedId)?.mask && editingMask === selectedId ? editingMask : null,
    };
  }

  /** Lets the engine get ready for a change of the selected layer, or of what is painted on it. */
  expectChange(): void {
    const { selected } = this;
    const { editingMask } = this.#store.state;
    const inside = selected?.type === "paint" || editingMask === selected?.id;
    this.#engine.expect(selected === undefined ? null : { id: selected.id, inside });
  }

  /** Gives the engine the layers of a design that is not the recorded one yet (its model is being opened). */
  send(design: Design): void {
    this.#revision += 1;
    this.#sent = design;
    if (this.#library.lacks(design)) this.#later(this.#sendLater(design));
    else this.#engine.setLayers(this.#engineLayers(design), this.#revision);
  }

  /** A step far back may use pictures that the engine has no more: until it has them, it goes on showing what it shows. */
  async #sendLater(design: Design): Promise<void> {
    await this.#library.giveBack(design).finally(() => {
      if (this.#sent?.layers !== design.layers) return;
      this.#engine.setLayers(this.#engineLayers(design), this.#revision);
      this.#showDecals();
    });
  }

  #sweep(): void {
    const history = this.#history;
    const reachable = function* (): Iterable<Design> {
      for (const { design } of history.values()) yield design;
    };
    this.#library.sweep([this.design, this.recordedDesign], reachable);
  }

  #engineLayers(design: Design): EngineLayer[] {
    const engineKey = (asset: string): string => this.#library.engineKey(design.assets[asset]) ?? asset;
    return resolveLayers(design).map((layer) => withKeys(layer, engineKey));
  }

  #publish(): void {
    const { design } = this;
    if (design.layers !== this.#sent?.layers) this.send(design);
    const { selectedId, selection } = this.#store.state;
    this.#store.set({
      design,
      ...this.#present(selectedId, selection),
      undoLabel: this.#history.undoLabel,
      redoLabel: this.#history.redoLabel,
      history: this.#historySteps(),
      unsaved: this.recordedDesign !== this.#saved,
    });
    this.#showDecals();
  }

  #showDecals(): void {
    const { design } = this;
    const { selectedId } = this.#store.state;
    const decals: ViewerDecal[] = [];
    for (const { layer, shown, locked } of walkLayers(design, { masks: false, strokes: false })) {
      // A locked one cannot be taken hold of, and does not stand before those that can.
      if (locked || !isPlaced(layer)) continue;
      const picture = layer.type === "decal" ? this.#library.get(design.assets[layer.asset]) : undefined;
      const { id, name, projector } = layer;
      const aspect = picture ? picture.width / picture.height : 1;
      const each = { id, name, materials: materialsOf(layer), visible: shown, projector, aspect };
      const twin = id === selectedId && shown && layer.mirror && mirroredProjector(projector, layer.mirror);
      decals.push(twin ? { ...each, beside: [twin] } : each);
    }
    this.#viewer.setDecals(decals, selectedId);
  }

  #historySteps(): HistorySteps {
    const history = this.#history;
    // A gesture's frames record nothing.
    if (history.previewing) return this.#store.state.history;
    const { labels, position, dropped, heldBytes, budget } = history;
    return { labels, position, dropped, heldBytes, budget };
  }
}
