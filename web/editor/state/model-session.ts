/**
 * The open model and its paint targets. A model that cannot be opened leaves everything as it was: since the engine
 * holds one model at a time, that may mean giving it the old one again.
 */

import { TexelcastError } from "../../core/texelcast-error.ts";
import type { Engine, MaterialInfo, ModelInfo, TargetInfo } from "../../engine/engine-api.ts";
import type { ModelViewer } from "../../viewer/viewer-api.ts";
import { type Design, materialsIn } from "../document/index.ts";
import { ToldError } from "../strings/told-error.ts";
import { type Strings, stringsIn } from "../strings.ts";
import { BareModelError, takesPaintUnwrapped } from "./bare-model-error.ts";
import { usedMaterials } from "./design-edits.ts";
import type { ModelRef, OpenModel } from "./design-state.ts";
import type { EditorState, TargetSettings } from "./editor-state.ts";
import type { Store } from "./store.ts";
import type { TaskHandle, Tasks } from "./tasks.ts";
import type { UpdateRouter } from "./update-router.ts";

export interface ModelSessionParts {
  readonly engine: Engine;
  readonly viewer: ModelViewer;
  readonly router: UpdateRouter;
  readonly store: Store<EditorState>;
  readonly tasks: Tasks;
  /** Gives the engine a design's layers. */
  readonly send: (design: Design) => void;
  /** Hears of each model that is on its way: what is undone or saved meanwhile waits for it. */
  readonly coming: (work: Promise<void>) => void;
}

/** What the engine is asked for. */
interface BakeAsked {
  readonly material: number;
  readonly settings: TargetSettings;
  /** The texture view is to show it. */
  readonly isShown: boolean;
}

/** Work that waits in line or is under way. */
interface Turn {
  /** Whose target it opens; null for that of a whole model. */
  readonly material: number | null;
  readonly end: AbortController;
}

export class ModelSession {
  readonly #engine: Engine;
  readonly #viewer: ModelViewer;
  readonly #router: UpdateRouter;
  readonly #store: Store<EditorState>;
  readonly #tasks: Tasks;
  readonly #send: (design: Design) => void;
  readonly #coming: (work: Promise<void>) => void;
  /** Sizes chosen for a model come back with it. */
  readonly #settings = new WeakMap<ModelRef, ReadonlyMap<number, TargetSettings>>();
  #uvTriangles = new Map<number, Float32Array>();
  #line: Promise<unknown> = Promise.resolve();
  readonly #turns = new Set<Turn>();

  constructor({ engine, viewer, router, store, tasks, send, coming }: ModelSessionParts) {
    this.#engine = engine;
    this.#viewer = viewer;
    this.#router = router;
    this.#store = store;
    this.#tasks = tasks;
    this.#send = send;
    this.#coming = coming;
  }

  get #strings(): Strings {
    return stringsIn(this.#store.state.language);
  }

  /**
   * Opens a model in place of the one before, with the design that is to be seen on it; `onOpen` runs once it is the
   * open one. Rejects with a TexelcastError, and the old model and its targets are there as before.
   *
   * @param keepsView whether it is seen as the one before is, if it takes the same room
   */
  open(ref: ModelRef, design: Design, onOpen: () => void, { keepsView = false } = {}): Promise<void> {
    const work = async (task: TaskHandle): Promise<void> => {
      const before = this.#store.state.model;
      const info = await this.#engine.loadModel(ref.source);
      this.#store.set({ switching: true });
      try {
        task.checkCancelled();
        await this.#show({ ref, info }, design, task, keepsView);
      } catch (thrown) {
        if (before) await this.#restore(before);
        throw thrown;
      } finally {
        this.#store.set({ switching: false });
      }
      onOpen();
    };
    for (const { end } of this.#turns) end.abort();
    const opened = this.#inLine(null, this.#strings.tasks.opening(ref.title), work);
    this.#coming(opened);
    return opened;
  }

  /** Sizes and gutters that a model is to be opened with. */
  rememberSettings(ref: ModelRef, settings: ReadonlyMap<number, TargetSettings>): void {
    this.#settings.set(ref, settings);
  }

  /** Opens a material's target with other settings; the old one stays until the new one is there. */
  async configure(material: number, settings: TargetSettings): Promise<void> {
    const { model, targetSettings, usualTarget } = this.#store.state;
    if (!model) return;
    const change = (value: TargetSettings): void => {
      const map = new Map(this.#store.state.targetSettings).set(material, value);
      this.#settings.set(model.ref, map);
      this.#store.set({ targetSettings: map });
    };
    change(settings);
    // Nobody waits for this target in another size any more; the others are still wanted.
    for (const turn of this.#turns) if (turn.material === material) turn.end.abort();
    try {
      await this.#openInLine(material, () => model === this.#store.state.model);
    } catch (thrown) {
      // Back to what is still open, unless a newer wish is already on its way.
      const newest = this.#store.state.targetSettings.get(material) === settings;
      if (newest) change(targetSettings.get(material) ?? usualTarget);
      throw thrown;
    }
  }

  /** Opens a target again as it is, for its first update: the whole picture, with all its mip levels. */
  reopen(material: number): Promise<void> {
    return this.#openInLine(material);
  }

  /** Makes a material the one that the texture view shows. */
  async showMaterial(material: number): Promise<void> {
    if (material === this.#store.state.material) return;
    this.#store.set({ material });
    const target = this.#store.state.targets.get(material);
    if (target) {
      await this.#showFlat(target);
      return;
    }
    // It may be on its way already, for a layer on it.
    await this.#openInLine(material, () => !this.#store.state.targets.has(material));
    const opened = this.#store.state.targets.get(material);
    const isWanted = material === this.#store.state.material && material !== this.#router.textureMaterial;
    if (opened && isWanted) await this.#showFlat(opened);
  }

  async #showFlat(target: TargetInfo): Promise<void> {
    const { material } = target;
    const uvTriangles = await this.#uvTrianglesOf(material);
    try {
      await this.#router.showInTextureView(target, uvTriangles);
    } catch {
      // One that cannot be drawn gives no texels. Opened anew, it tells all of them once it can.
      await this.#openInLine(material);
    }
  }

  /** Opens the targets that a design's layers need and that are not open yet. */
  async ensureTargets(design: Design): Promise<void> {
    const { model } = this.#store.state;
    const isLacking = (material: number): boolean =>
      model === this.#store.state.model && !this.#store.state.targets.has(material);
    const lacking = [...usedMaterials(design)].filter((material) => isLacking(material) && this.#paintable(material));
    const turns = lacking.map((material) => this.#openInLine(material, () => isLacking(material)));
    const ends = await Promise.allSettled(turns);
    // One that was ended for another size is opened by what wished for that.
    await this.#line;
    for (const [index, end] of ends.entries()) {
      if (end.status === "rejected" && isLacking(lacking[index] as number)) throw end.reason;
    }
  }

  async #show(model: OpenModel, design: Design, task: TaskHandle, keepsView: boolean): Promise<void> {
    const material = firstPaintable(model, design, this.#strings);
    this.#router.clear();
    this.#uvTriangles = new Map();
    this.#send(design);
    const before = this.#store.state.model;
    const bringView = keepsView && before && hasRoomOf(model, before) ? this.#keepView() : null;
    const targetSettings = this.#settings.get(model.ref) ?? new Map<number, TargetSettings>();
    // The engine prepares the texture while the view reads the model.
    let isViewed = false;
    const settings = targetSettings.get(material) ?? this.#store.state.usualTarget;
    const baked = this.#bake({ material, settings, isShown: true }, task.signal, (share) => {
      if (isViewed) task.progress(share);
    });
    // Where the view refuses the model nobody asks how it ended.
    baked.catch(() => undefined);
    await this.#viewer.setModel(model.info);
    isViewed = true;
    this.#store.set({
      // Its GLB, with all textures, is read.
      model: { ...model, info: { ...model.info, glb: new Uint8Array() } },
      material,
      targets: new Map(),
      targetSettings,
      textureMode: "texture",
    });
    // Whoever shows a model's parts hears of it in the next microtask, and shows all of them.
    await Promise.resolve();
    // A part of the texture that was looked at is another one of this model.
    if (bringView) bringView();
    else this.#router.showWholeTexture();
    task.relabel(this.#strings.tasks.baking);
    const bind = await baked.catch((thrown: unknown) => {
      throw brokenCoordinates(model, material, thrown);
    });
    bind();
    for (const other of usedMaterials(design)) {
      if (other !== material && this.#paintable(other)) await this.#openTarget(other, task);
    }
  }

  /** What brings the camera back to where it is, and hides the parts that are hidden. */
  #keepView(): () => void {
    const bringCamera = this.#viewer.keepCamera();
    const { parts, hidden } = this.#store.state.shown;
    return () => {
      bringCamera();
      const { shown } = this.#store.state;
      if (shown.parts.length !== parts.length) return;
      this.#store.set({ shown: { ...shown, hidden } });
      this.#viewer.setHiddenParts(hidden);
    };
  }

  async #restore(before: OpenModel): Promise<void> {
    await this.#tasks.run(this.#strings.tasks.restoring(before.ref.title), async (task) => {
      const info = await this.#engine.loadModel(before.ref.source);
      await this.#show({ ref: before.ref, info }, this.#store.state.design, task, true);
    });
  }

  async #openTarget(material: number, task: TaskHandle): Promise<void> {
    const { targetSettings, usualTarget, material: shown } = this.#store.state;
    const settings = targetSettings.get(material) ?? usualTarget;
    const ask = { material, settings, isShown: material === shown };
    const bind = await this.#bake(ask, task.signal, (share) => task.progress(share));
    bind();
  }

  /** Lets the engine open a target. What comes back gives it to the views, which must have the model then. */
  async #bake(
    { material, settings: { size, gutter }, isShown }: BakeAsked,
    signal: AbortSignal,
    onProgress: (share: number) => void,
  ): Promise<() => void> {
    // Asked for together: the page may be long in taking an answer, while it draws.
    const outlines = isShown ? this.#uvTrianglesOf(material) : null;
    const opened = this.#engine.openTarget(
      {
        material,
        mipmaps: true,
        ...(size !== null && { width: size, height: size }),
        ...(gutter !== null && { gutter }),
      },
      onProgress,
      signal,
    );
    const [info, uvTriangles] = await Promise.all([opened, outlines]);
    return () => this.#bind(info, uvTriangles);
  }

  /** Gives a target that the engine has opened to the views. */
  #bind(info: TargetInfo, uvTriangles: Float32Array | null): void {
    this.#router.bind(info, info.material === this.#store.state.material ? uvTriangles : null);
    this.#store.set({ targets: new Map(this.#store.state.targets).set(info.material, info) });
  }

  async #uvTrianglesOf(material: number): Promise<Float32Array> {
    const known = this.#uvTriangles.get(material);
    if (known) return known;
    const triangles = await this.#engine.uvTriangles(material);
    this.#uvTriangles.set(material, triangles);
    return triangles;
  }

  #paintable(material: number): boolean {
    const { model } = this.#store.state;
    return model?.info.materials.some((info) => info.index === material && info.refusal === null) ?? false;
  }

  /** @param isWanted asked when its turn has come */
  #openInLine(material: number, isWanted: () => boolean = () => true): Promise<void> {
    return this.#inLine(material, this.#strings.tasks.baking, async (task) => {
      if (isWanted()) await this.#openTarget(material, task);
    });
  }

  /** One after another. */
  #inLine(material: number | null, label: string, work: (task: TaskHandle) => Promise<void>): Promise<void> {
    const turn: Turn = { material, end: new AbortController() };
    const { signal } = turn.end;
    this.#turns.add(turn);
    const done = this.#line
      .then(() =>
        this.#tasks.run(label, async (task) => {
          signal.addEventListener("abort", task.abort);
          if (signal.aborted) task.abort();
          task.checkCancelled();
          await work(task);
        }),
      )
      .finally(() => this.#turns.delete(turn));
    this.#line = done.catch(() => undefined);
    return done;
  }
}

/** The material that the design's top layer paints, else the paintable one with the most triangles. */
function firstPaintable({ ref, info }: OpenModel, design: Design, strings: Strings): number {
  const paintable = info.materials.filter(({ refusal }) => refusal === null);
  const isPaintable = (material: number): boolean => paintable.some(({ index }) => index === material);
  const wanted = design.layers.toReversed().flatMap(materialsIn).find(isPaintable);
  if (wanted !== undefined) return wanted;
  const [best] = paintable.toSorted((a, b) => b.triangles - a.triangles);
  if (best) return best.index;
  throw refusalOf(ref, info, strings);
}

/** Whether a model takes the room of another one, as it does unwrapped. */
function hasRoomOf({ info }: OpenModel, before: OpenModel): boolean {
  const corners = ({ boundsMin, boundsMax }: ModelInfo): readonly number[] => [...boundsMin, ...boundsMax];
  const others = corners(before.info);
  return corners(info).every((place, axis) => place === others[axis]);
}

/** Coordinates may be numbers and yet of no use, which is found when they are drawn: then the model is refused after all. */
function brokenCoordinates({ ref, info }: OpenModel, material: number, thrown: unknown): unknown {
  if (!(thrown instanceof TexelcastError) || thrown.code !== "bad-uvs") return thrown;
  const bare = info.materials.filter((each) => each.index === material || takesPaintUnwrapped(each));
  const model = { ref, materials: bare.map(({ index }) => index) };
  return new BareModelError(thrown.code, model, thrown.message, { ...thrown.toJSON(), subject: info.name });
}

function refusalOf(ref: ModelRef, { name, materials }: ModelInfo, strings: Strings): TexelcastError {
  const isRefused = (material: MaterialInfo): material is MaterialInfo & { refusal: object } => !!material.refusal;
  const refused = materials.filter(isRefused);
  const bare = refused.filter(takesPaintUnwrapped);
  // What can be helped is told before what cannot.
  const [first] = [...bare, ...refused];
  if (!first) return new ToldError("no-triangles", strings.errors.noMaterials, { subject: name });
  const { code, message } = first.refusal;
  const details = { subject: name, field: strings.materialName(first.index, first.name) };
  if (bare.length === 0) return new TexelcastError(code, message, { ...details, hint: strings.errors.refusedHint });
  const model = { ref, materials: bare.map(({ index }) => index) };
  return new BareModelError(code, model, message, { ...details, hint: strings.errors.noUvsHint });
}
