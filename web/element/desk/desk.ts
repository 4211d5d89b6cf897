/**
 * Where a design is worked on in a shop: one engine, one view, one design with its history, and no more of the editor than
 * these need. The element shows it; closing it ends the worker and the graphics, and the design can go on at another desk.
 */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { Design, DesignLayer } from "../../editor/document/design.ts";
import { flattenLayers, removeById } from "../../editor/document/layer-tree.ts";
import { AssetLibrary } from "../../editor/state/asset-library.ts";
import { DecalReach, type PlacedLayer } from "../../editor/state/decal-reach.ts";
import { layerById, patchLayer, usedMaterials, withoutUnusedAssets } from "../../editor/state/design-edits.ts";
import { DesignSession } from "../../editor/state/design-session.ts";
import { type EditorState, INITIAL_FIGURES, INITIAL_STATE } from "../../editor/state/editor-state.ts";
import { Store } from "../../editor/state/store.ts";
import { UpdateRouter } from "../../editor/state/update-router.ts";
import type { Engine, ModelInfo, ModelSource, TargetInfo } from "../../engine/engine-api.ts";
import { createEngineClient } from "../../engine/engine-client.ts";
import { createModelViewer } from "../../viewer/model-viewer.ts";
import type { DecalGesture, ModelViewer } from "../../viewer/viewer-api.ts";
import type { DeskHooks, DeskSettings } from "./desk-settings.ts";
import { LOOK_ONLY } from "./look-only.ts";

export interface DeskParts {
  /** Where the view goes; it must have a size. */
  readonly view: HTMLElement;
  /** Address of the engine's WebAssembly; "" the bundler's. */
  readonly wasm: string;
  readonly hooks: DeskHooks;
}

/** Of the whole way, where each part of opening ends. */
const LOADED = 0.35;

export class Desk {
  readonly engine: Engine;
  readonly viewer: ModelViewer;
  readonly store = new Store<EditorState>(INITIAL_STATE);
  readonly session: DesignSession;
  readonly library: AssetLibrary;
  readonly reach: DecalReach;
  readonly hooks: DeskHooks;
  readonly #router: UpdateRouter;
  #line: Promise<unknown> = Promise.resolve();
  #seen: Pick<EditorState, "design" | "selectedId">;
  #recorded: Design;
  #closed = false;

  /** Throws a TexelcastError without WebGL 2. */
  constructor({ view, wasm, hooks }: DeskParts) {
    this.hooks = hooks;
    const { store } = this;
    // First: without graphics there is nothing to begin a worker for.
    this.viewer = createModelViewer(view, { label: hooks.settings().words.view });
    this.engine = createEngineClient(wasm === "" ? {} : { wasm });
    const { engine, viewer } = this;
    this.library = new AssetLibrary(engine);
    this.#router = new UpdateRouter(engine, viewer, null, new Store(INITIAL_FIGURES));
    this.session = new DesignSession({
      ...{ engine, viewer, store },
      library: this.library,
      later: (work) => void work.catch((thrown: unknown) => this.#fail(thrown)),
    });
    this.reach = new DecalReach(viewer, () => store.state.model?.info.materials ?? []);
    this.#seen = store.state;
    this.#recorded = this.session.recordedDesign;
    viewer.on("select", ({ id }) => this.select(id));
    viewer.on("gesture", (gesture) => this.#follow(gesture));
    viewer.on("needsFullUpdate", ({ material }) => this.#attempt(this.#inLine(() => this.#openTarget(material))));
    engine.onError((error) => this.#fail(error));
    store.subscribe(() => this.#react());
  }

  get settings(): DeskSettings {
    return this.hooks.settings();
  }

  /** The design without what a gesture only shows so far. */
  get design(): Design {
    return this.session.recordedDesign;
  }

  get selected(): DesignLayer | undefined {
    return this.session.selected;
  }

  /** The material that new things go on where nothing else says. */
  get material(): number {
    return this.store.state.material ?? 0;
  }

  /**
   * Opens a model with a design, which is read when the engine can take its files. Rejects with a TexelcastError; the desk is
   * of no use then.
   */
  async open(source: ModelSource, readDesign: () => Promise<Design>): Promise<void> {
    const info = await this.engine.loadModel(source);
    const design = await readDesign();
    this.hooks.progress(LOADED);
    this.session.send(design);
    await this.viewer.setModel(info);
    this.#router.clear();
    const ref = { source, title: source.name, demoId: null };
    const material = this.#paintable(info);
    this.store.set({ model: { ref, info }, material });
    const materials = [...new Set([material, ...usedMaterials(design)])].filter((each) => this.#canPaint(each));
    for (const [index, each] of materials.entries()) {
      const share = (part: number): number => LOADED + ((1 - LOADED) * (index + part)) / materials.length;
      await this.#openTarget(each, (part) => this.hooks.progress(share(part)));
    }
    this.session.recordModel(ref, design, "");
    this.#recorded = this.design;
    this.configure();
    await this.engine.idle();
  }

  /** Takes up what the element's settings are now. */
  configure(): void {
    const { camera, readonly } = this.settings;
    this.viewer.setCamera(null, camera);
    this.viewer.setTool(readonly ? LOOK_ONLY : null);
    if (readonly) this.session.select(null);
  }

  /** Gives the open targets the size of the settings. */
  async resize(): Promise<void> {
    for (const material of this.store.state.targets.keys()) await this.#inLine(() => this.#openTarget(material));
  }

  /** False where there is no such layer. */
  select(id: string | null): boolean {
    if (id !== null && (this.settings.readonly || !layerById(this.design, id))) return false;
    this.session.select(id);
    return true;
  }

  /** Records a design as a step. Throws "readonly" where nobody may. */
  record(design: Design, label: string, mergeKey?: string): void {
    this.checkWritable();
    this.session.record(design, label, mergeKey);
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

  /** Moves, turns or sizes what is placed: it paints the materials that it then lies on. */
  place(id: string, projector: PlacedLayer["projector"], final: boolean, key?: string): void {
    const layer = layerById(this.design, id);
    if (layer?.type !== "decal" && layer?.type !== "text") return;
    const material = this.reach.movedTo(layer, projector, null);
    this.change<PlacedLayer>(id, { projector, material }, final, key);
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

  /** False where there is no step that way. */
  travel(by: 1 | -1): boolean {
    const { undoLabel, redoLabel } = this.store.state;
    if (this.settings.readonly || (by < 0 ? undoLabel : redoLabel) === null) return false;
    this.session.travelTo(this.session.position + by);
    const { announce } = this.settings.words;
    this.hooks.announce(by < 0 ? announce.undone : announce.redone);
    return true;
  }

  /** Throws "refused" where the design is only looked at. */
  checkWritable(): void {
    const { readonly, words } = this.settings;
    if (readonly) throw new TexelcastError("refused", words.errors.readonly);
  }

  /** How many more pictures and texts there may be. */
  get room(): number {
    const { maxDecals } = this.settings;
    if (maxDecals === null) return Number.POSITIVE_INFINITY;
    const placed = flattenLayers(this.design, { masks: false, strokes: false });
    return maxDecals - placed.filter(({ type }) => type === "decal" || type === "text").length;
  }

  /** Throws "too-many-decals" where no other one may come. */
  checkRoom(): void {
    this.checkWritable();
    if (this.room > 0) return;
    const { words, maxDecals } = this.settings;
    throw new TexelcastError("too-many-decals", words.errors.tooMany(maxDecals ?? 0), {
      field: "max-decals",
      value: String(maxDecals),
      hint: words.errors.tooManyHint,
    });
  }

  /** Resolves when every target that the design needs is open and shows it. */
  async idle(): Promise<void> {
    await this.#line;
    await this.engine.idle();
  }

  /** Ends the worker and the graphics. */
  close(): void {
    this.#closed = true;
    // What no design holds any more is thrown away, and with it the addresses of its pictures.
    this.library.dispose();
    this.engine.dispose();
    this.viewer.dispose();
  }

  #follow({ id, phase, projector, material: onto }: DecalGesture): void {
    if (phase === "start") this.select(id);
    else if (phase === "cancel") this.session.cancelPreview();
    else {
      const layer = layerById(this.design, id);
      if (layer?.type !== "decal" && layer?.type !== "text") return;
      const material = this.reach.movedTo(layer, projector, onto);
      this.change<PlacedLayer>(id, { projector, material }, phase === "end");
    }
  }

  #react(): void {
    const { design, selectedId } = this.store.state;
    const before = this.#seen;
    this.#seen = { design, selectedId };
    if (this.#closed) return;
    if (design !== before.design) this.#attempt(this.#ensureTargets(design));
    if (selectedId !== before.selectedId) {
      this.session.expectChange();
      this.hooks.selected(selectedId);
    }
    if (this.design === this.#recorded) return;
    this.#recorded = this.design;
    this.hooks.changed();
  }

  async #ensureTargets(design: Design): Promise<void> {
    for (const material of usedMaterials(design)) {
      if (this.store.state.targets.has(material) || !this.#canPaint(material)) continue;
      await this.#inLine(async () => {
        if (!this.store.state.targets.has(material)) await this.#openTarget(material);
      });
    }
  }

  async #openTarget(material: number, progress?: (share: number) => void): Promise<TargetInfo> {
    const { size } = this.settings;
    const sides = size === null ? {} : { width: size, height: size };
    const info = await this.engine.openTarget({ material, mipmaps: true, ...sides }, progress);
    // In the turn in which the engine answered: the next thing it says is the target's first picture.
    this.#router.bind(info, null);
    this.store.set({ targets: new Map(this.store.state.targets).set(material, info) });
    return info;
  }

  #inLine<T>(work: () => Promise<T>): Promise<T> {
    const turn = this.#line.then(work);
    this.#line = turn.catch(() => undefined);
    return turn;
  }

  /** The material that the page asks for, else the paintable one with the most triangles. */
  #paintable({ name, materials }: ModelInfo): number {
    const { material, words } = this.settings;
    const open = materials.filter(({ refusal }) => refusal === null);
    const [largest] = open.toSorted((a, b) => b.triangles - a.triangles);
    if (open.some(({ index }) => index === material)) return material ?? 0;
    const asked = material === null ? undefined : materials.find(({ index }) => index === material);
    if (material === null && largest) return largest.index;
    const refusal = asked?.refusal ?? materials.find((each) => each.refusal !== null)?.refusal;
    throw new TexelcastError(
      refusal?.code.toLowerCase().replaceAll("_", "-") ?? "bad-argument",
      refusal?.message ?? words.errors.notOpenable,
      { subject: name, field: "material", value: String(material) },
    );
  }

  #canPaint(material: number): boolean {
    return (
      this.store.state.model?.info.materials.some(({ index, refusal }) => index === material && refusal === null) ??
      false
    );
  }

  #attempt(work: Promise<unknown>): void {
    void work.catch((thrown: unknown) => this.#fail(thrown));
  }

  #fail(thrown: unknown): void {
    if (!this.#closed) this.hooks.failed(thrown);
  }
}
