/**
 * Where a design is worked on: its engine, its view, its history, and what a page or a customer may do with it, whichever mode
 * shows it. Closing it ends the worker and the graphics, and the design can go on at another desk.
 */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { type Design, type DesignLayer, isPlaced, type PlacedLayer } from "../../editor/document/design.ts";
import { removeById } from "../../editor/document/layer-tree.ts";
import type { AssetLibrary } from "../../editor/state/asset-library.ts";
import { DecalReach } from "../../editor/state/decal-reach.ts";
import { layerById, patchLayer, placedCount, withoutUnusedAssets } from "../../editor/state/design-edits.ts";
import type { DesignSession } from "../../editor/state/design-session.ts";
import type { DesignState } from "../../editor/state/design-state.ts";
import { OpenWork } from "../../editor/state/open-work.ts";
import type { Store } from "../../editor/state/store.ts";
import { ToldError } from "../../editor/strings/told-error.ts";
import type { Engine } from "../../engine/engine-api.ts";
import type { PrintReport } from "../../engine/print-report.ts";
import type { PrintZones } from "../../engine/print-zones.ts";
import type { DecalViewer, ModelView } from "../../viewer/viewer-api.ts";
import type { DeskHooks, DeskSettings } from "./desk-settings.ts";

export interface DeskParts {
  readonly engine: Engine;
  readonly viewer: ModelView;
  /** Loads what takes hold of the view; asked for once, and again where it failed. */
  readonly loadHands: () => Promise<DecalViewer>;
  readonly store: Store<DesignState>;
  readonly session: DesignSession;
  readonly library: AssetLibrary;
  readonly hooks: DeskHooks;
}

export class Desk {
  readonly engine: Engine;
  readonly viewer: ModelView;
  readonly store: Store<DesignState>;
  readonly session: DesignSession;
  readonly library: AssetLibrary;
  readonly reach: DecalReach;
  readonly hooks: DeskHooks;
  #seen: Pick<DesignState, "selectedId">;
  /** What the page knows of; null until the desk is open. */
  #recorded: Design | null = null;
  readonly #closing = new AbortController();
  readonly #loadHands: () => Promise<DecalViewer>;
  #taking: Promise<DecalViewer> | null = null;
  /** What was begun and is not in the design yet. */
  readonly #begun = new OpenWork();
  #hands: DecalViewer | null = null;
  /** Where the product may be printed; null: everywhere, and nobody asked how well. */
  zones: PrintZones | null = null;
  /** Of the design as it was last measured. */
  report: PrintReport | null = null;

  constructor({ engine, viewer, loadHands, store, session, library, hooks }: DeskParts) {
    this.engine = engine;
    this.viewer = viewer;
    this.store = store;
    this.session = session;
    this.library = library;
    this.hooks = hooks;
    this.#loadHands = loadHands;
    const reaching = {
      materialsReached: (...of: Parameters<DecalViewer["materialsReached"]>) => this.#held.materialsReached(...of),
    };
    this.reach = new DecalReach(reaching, () => store.state.model?.info.materials ?? []);
    this.#seen = store.state;
    store.subscribe(() => this.#react());
  }

  get settings(): DeskSettings {
    return this.hooks.settings();
  }

  /** The view with hands; null until `takeHands` brought them. */
  get hands(): DecalViewer | null {
    return this.#hands;
  }

  /** Loads what takes hold of the view, if nobody did yet. Rejects with "cancelled" where the desk is closed meanwhile. */
  takeHands(): Promise<DecalViewer> {
    this.#taking ??= this.#loadHands().then(
      (hands) => {
        this.#hands = hands;
        return hands;
      },
      (thrown: unknown) => {
        this.#taking = null;
        throw thrown;
      },
    );
    return this.#taking;
  }

  get #held(): DecalViewer {
    if (this.#hands === null) throw new TexelcastError("internal", "The view was asked before it was taken hold of.");
    return this.#hands;
  }

  /**
   * Cuts what is printed off at the zones, if they say so. Of a zone on a material that the model does not have the page is
   * told; the others hold.
   */
  async useZones(zones: PrintZones | null): Promise<void> {
    await this.engine.setZones(zones);
    this.zones = zones;
    const materials = this.store.state.model?.info.materials ?? [];
    for (const { id, material } of zones?.zones ?? []) {
      if (materials.some(({ index }) => index === material)) continue;
      const { zoneMaterial, zoneMaterialHint } = this.settings.words.errors;
      const list = materials.map(({ index, name }) => (name === "" ? index : `${index} (${name})`)).join(", ");
      const details = { field: "material", value: String(material), hint: zoneMaterialHint(list) };
      this.hooks.warn(new ToldError("bad-zones", zoneMaterial(id, material), details));
    }
  }

  /** The design without what a gesture only shows so far. */
  get design(): Design {
    return this.session.recordedDesign;
  }

  /** The design as it is seen: with what is dragged or typed and not a step yet. */
  get shown(): Design {
    return this.session.design;
  }

  get selected(): DesignLayer | undefined {
    return this.session.selected;
  }

  /** Counts work that ends in a change of the design, or of what the engine shows of it, as under way. */
  during<T>(work: Promise<T>): Promise<T> {
    this.#begun.add(work);
    return work;
  }

  /** Resolves when all that was begun is in the design, or has failed. */
  settled(): Promise<void> {
    return this.#begun.settled();
  }

  /** Whether what is shown is the design, and no gesture or typing is under way. */
  get atRest(): boolean {
    return this.shown === this.design;
  }

  /** Makes what is shown a step of the history, as the end of the gesture or of the typing would. */
  keepShown(): void {
    if (!this.atRest && !this.settings.readonly) this.record(this.shown, this.settings.words.steps.change);
    // Where nothing may be recorded, it is not to be printed either.
    this.session.cancelPreview();
  }

  /** The material that new things go on where nothing else says. */
  get material(): number {
    return this.store.state.material ?? 0;
  }

  /** False where there is no such layer. */
  select(id: string | null): boolean {
    if (id !== null && (this.settings.readonly || !layerById(this.design, id))) return false;
    this.session.select(id);
    return true;
  }

  /** Records a design as a step. Throws "readonly" where nobody may. */
  record(design: Design, label: string): void {
    this.checkWritable();
    this.session.record(design, label);
  }

  /** Shows a change of a layer, or (`final`) records it. */
  change<L extends DesignLayer>(
    id: string,
    patch: Partial<Omit<L, "id" | "type">>,
    final: boolean,
    key?: string,
  ): void {
    if (this.settings.readonly) return;
    const design = patchLayer<L>(this.design, id, patch);
    if (final) this.session.record(design, this.settings.words.steps.change, key && `${key}:${id}`);
    else this.session.preview(design);
  }

  /**
   * Moves, turns or sizes what is placed: it paints the materials that it then lies on (`onto`: where a hand put it), and its
   * depth, of which a shop's customers need not know, goes with its size.
   */
  place(id: string, placed: PlacedLayer["projector"], final: boolean, key?: string, onto: number | null = null): void {
    const layer = layerById(this.design, id);
    if (!isPlaced(layer)) return;
    const projector = this.#hands?.resized(layer.projector, placed) ?? placed;
    const material = this.reach.movedTo(layer, projector, onto);
    this.change<PlacedLayer>(id, { projector, material }, final, key);
  }

  /** Takes a design in place of the one on the product, as a step of the history. */
  takeDesign(design: Design): void {
    this.session.record(design, this.settings.words.steps.design);
    this.session.select(null);
  }

  remove(id: string): boolean {
    const layer = layerById(this.design, id);
    if (!layer) return false;
    this.checkWritable();
    const { words } = this.settings;
    this.session.record(withoutUnusedAssets(removeById(this.design, id)), words.steps.remove);
    this.hooks.announce(words.announce.removed(layer.name));
    return true;
  }

  /** What is shown and no step yet becomes one first. False where there is no step that way. */
  travel(by: 1 | -1): boolean {
    this.keepShown();
    const { undoLabel, redoLabel } = this.store.state;
    if (this.settings.readonly || (by < 0 ? undoLabel : redoLabel) === null) return false;
    this.session.travelTo(this.session.position + by);
    const { announce } = this.settings.words;
    this.hooks.announce(by < 0 ? announce.undone : announce.redone);
    return true;
  }

  /** As a hand asks for it: a field that was just left may still measure the words that it records. */
  async step(by: 1 | -1): Promise<void> {
    await this.settled();
    this.travel(by);
  }

  /** Throws "refused" where the design is only looked at. */
  checkWritable(): void {
    const { readonly, words } = this.settings;
    if (readonly) throw new ToldError("refused", words.errors.readonly);
  }

  /** How many more pictures and texts there may be. */
  get room(): number {
    const { maxDecals } = this.settings;
    return maxDecals === null ? Number.POSITIVE_INFINITY : maxDecals - placedCount(this.design);
  }

  /** Throws "too-many-decals" where that many more may not come. */
  checkRoom(more = 1): void {
    this.checkWritable();
    if (more <= 0 || this.room >= more) return;
    const { words, maxDecals } = this.settings;
    throw new ToldError("too-many-decals", words.errors.tooMany(maxDecals ?? 0), {
      field: "max-decals",
      value: String(maxDecals),
      hint: words.errors.tooManyHint,
    });
  }

  /** From here on steps are told; what was opened is none. */
  opened(): void {
    this.#recorded = this.design;
  }

  get closed(): boolean {
    return this.signal.aborted;
  }

  /** Aborted with "disposed" when it is closed. */
  get signal(): AbortSignal {
    return this.#closing.signal;
  }

  /** Ends the worker and the graphics. */
  close(): void {
    if (this.closed) return;
    // What was typed and not left goes on with the rest, at the next desk.
    this.keepShown();
    this.#closing.abort(new TexelcastError("disposed", "The product was closed."));
    this.library.dispose();
    this.engine.dispose();
    this.viewer.dispose();
  }

  #react(): void {
    const { selectedId } = this.store.state;
    const before = this.#seen;
    this.#seen = { selectedId };
    if (this.closed) return;
    if (selectedId !== before.selectedId) this.hooks.selected(selectedId);
    if (this.#recorded === null || this.design === this.#recorded) return;
    this.#recorded = this.design;
    this.hooks.changed();
  }
}
