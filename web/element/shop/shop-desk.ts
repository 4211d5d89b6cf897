/** The shop's desk: one engine, one view, one design with its history, and no more of the editor than these need. */
import type { Design } from "../../editor/document/design.ts";
import { AssetLibrary } from "../../editor/state/asset-library.ts";
import type { PlacedLayer } from "../../editor/state/decal-reach.ts";
import { layerById, usedMaterials } from "../../editor/state/design-edits.ts";
import { DesignSession } from "../../editor/state/design-session.ts";
import { type EditorState, INITIAL_FIGURES, INITIAL_STATE } from "../../editor/state/editor-state.ts";
import { Store } from "../../editor/state/store.ts";
import { UpdateRouter } from "../../editor/state/update-router.ts";
import type { ModelSource, TargetInfo } from "../../engine/engine-api.ts";
import { createEngineClient } from "../../engine/engine-client.ts";
import { LOOK_ONLY } from "../../viewer/look-only.ts";
import { createModelViewer } from "../../viewer/model-viewer.ts";
import type { DecalGesture } from "../../viewer/viewer-api.ts";
import { Desk } from "../desk/desk.ts";
import type { DeskHooks } from "../desk/desk-settings.ts";
import { paintableMaterial } from "../desk/paintable.ts";

export interface ShopDeskParts {
  /** Where the view goes; it must have a size. */
  readonly view: HTMLElement;
  /** Address of the engine's WebAssembly; "" the bundler's. */
  readonly wasm: string;
  readonly hooks: DeskHooks;
}

/** Of opening, where the model is read. */
const LOADED = 0.35;

export class ShopDesk extends Desk {
  readonly #router: UpdateRouter;
  #line: Promise<unknown> = Promise.resolve();
  #shown: Pick<EditorState, "design" | "selectedId">;

  /** Throws a TexelcastError without WebGL 2. */
  constructor({ view, wasm, hooks }: ShopDeskParts) {
    // First: without graphics there is nothing to begin a worker for.
    const viewer = createModelViewer(view, { label: hooks.settings().words.view });
    const engine = createEngineClient(wasm === "" ? {} : { wasm });
    const store = new Store<EditorState>(INITIAL_STATE);
    const library = new AssetLibrary(engine);
    const later = (work: Promise<void>): void => this.#attempt(work);
    const session = new DesignSession({ engine, viewer, library, store, later });
    super({ engine, viewer, library, store, session, hooks });
    this.#router = new UpdateRouter(engine, viewer, null, new Store(INITIAL_FIGURES));
    this.#shown = store.state;
    viewer.on("select", ({ id }) => this.select(id));
    viewer.on("gesture", (gesture) => this.#follow(gesture));
    viewer.on("needsFullUpdate", ({ material }) => this.#attempt(this.#inLine(() => this.#openTarget(material))));
    engine.onError((error) => this.#fail(error));
    store.subscribe(() => this.#show());
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
    const material = paintableMaterial(info, this.settings);
    this.store.set({ model: { ref, info }, material });
    const materials = [...new Set([material, ...usedMaterials(design)])].filter((each) => this.#canPaint(each));
    for (const [index, each] of materials.entries()) {
      const share = (part: number): number => LOADED + ((1 - LOADED) * (index + part)) / materials.length;
      await this.#openTarget(each, (part) => this.hooks.progress(share(part)));
    }
    this.session.recordModel(ref, design, "");
    this.opened();
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

  /** Takes up the settings' material, and gives what is open the settings' size. */
  async resize(): Promise<void> {
    const { model, targets } = this.store.state;
    if (model === null) return;
    const own = paintableMaterial(model.info, this.settings);
    this.store.set({ material: own });
    for (const material of new Set([own, ...targets.keys()])) await this.#inLine(() => this.#openTarget(material));
  }

  /** Resolves when every target that the design needs is open and shows it. */
  async idle(): Promise<void> {
    await this.#line;
    await this.engine.idle();
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

  #show(): void {
    const { design, selectedId } = this.store.state;
    const before = this.#shown;
    this.#shown = { design, selectedId };
    if (this.closed) return;
    if (design !== before.design) this.#attempt(this.#ensureTargets(design));
    if (selectedId !== before.selectedId) this.session.expectChange();
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
    if (!this.closed) this.hooks.failed(thrown);
  }
}
