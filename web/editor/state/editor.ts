/**
 * The editor without its looks: one state, the commands that change it, and the wiring between design, engine and
 * views. Panels read `store` and call commands; nothing else changes the state.
 */
import type { Engine, MapView, TargetInfo } from "../../engine/engine-api.ts";
import type { ModelViewer, TextureView } from "../../viewer/viewer-api.ts";
import { type Design, type DesignLayer, materialsIn } from "../document/index.ts";
import { type DemoCatalogue, loadDemoCatalogue } from "../files/demo-catalogue.ts";
import { fileStem } from "../files/download.ts";
import type { Autosave } from "../storage/autosave.ts";
import type { Language } from "../strings/language.ts";
import { type Strings, stringsIn } from "../strings.ts";
import { TipCommands } from "../tools/brush-tips.ts";
import { PaletteCommands } from "../tools/palette-commands.ts";
import { PartsTool } from "../tools/parts-tool.ts";
import { registerTools } from "../tools/register-tools.ts";
import { textTool } from "../tools/text-tool.ts";
import { Toolbox } from "../tools/toolbox.ts";
import type { Admission } from "./admission.ts";
import { AssetLibrary } from "./asset-library.ts";
import { BareParts } from "./bare-parts.ts";
import { ClipboardCommands } from "./clipboard-commands.ts";
import { DecalCommands } from "./decal-commands.ts";
import { DecalReach } from "./decal-reach.ts";
import { layerById } from "./design-edits.ts";
import { DesignSession } from "./design-session.ts";
import type { ModelRef } from "./design-state.ts";
import { DrawingTask } from "./drawing-task.ts";
import { type EditorState, type Figures, INITIAL_FIGURES, INITIAL_STATE, type TargetSettings } from "./editor-state.ts";
import { EngineTrouble } from "./engine-trouble.ts";
import { FileCommands } from "./file-commands.ts";
import { tellOfLostGraphics } from "./graphics-loss.ts";
import { keepHistoryBudget, readHistoryBudget } from "./history-budget.ts";
import { readAligning } from "./kept-aligning.ts";
import { LayerCommands } from "./layer-commands.ts";
import { LostDecal } from "./lost-decal.ts";
import { megabytes } from "./megabytes.ts";
import { ModelSession } from "./model-session.ts";
import { NoticeBoard } from "./notice-board.ts";
import type { ProjectCommands } from "./project-commands.ts";
import { keepProjects } from "./project-keeping.ts";
import { followGradient, shownGradient } from "./shown-gradient.ts";
import { shownStamp } from "./shown-stamp.ts";
import { Store } from "./store.ts";
import { stampsBeside, surroundingsOf } from "./surroundings.ts";
import { Tasks } from "./tasks.ts";
import { TextCommands } from "./text-commands.ts";
import { UnwrapCommand, type Unwrapper } from "./unwrap-command.ts";
import { UpdateRouter } from "./update-router.ts";
import { VariantCommand } from "./variant-command.ts";
import { ViewCommands } from "./view-commands.ts";
import type { TextureMode } from "./view-state.ts";

/** Pixels of the pictures in the list of projects: twice what is shown. */
const THUMBNAIL_WIDTH = 288;
const THUMBNAIL_HEIGHT = 216;

export interface EditorParts {
  readonly engine: Engine;
  readonly viewer: ModelViewer;
  readonly textureView: TextureView;
  /** Whether the browser keeps what is worked on; default true. */
  readonly keeps?: boolean;
  /** What the page around it says of files; null: it has none, and whatever can be opened may be. */
  readonly admission?: Admission | null;
  /** Default "en". */
  readonly language?: Language;
  /** Null: the page does not unwrap models. */
  readonly unwrap?: Unwrapper | null;
}

export class Editor {
  readonly engine: Engine;
  readonly viewer: ModelViewer;
  readonly textureView: TextureView;
  readonly store: Store<EditorState>;
  readonly figures = new Store<Figures>(INITIAL_FIGURES);
  readonly board: NoticeBoard;
  readonly tasks: Tasks;
  readonly library: AssetLibrary;
  readonly layers: LayerCommands;
  readonly decals: DecalCommands;
  readonly clipboard: ClipboardCommands;
  readonly files: FileCommands;
  readonly session: DesignSession;
  readonly tools: Toolbox;
  readonly palettes: PaletteCommands;
  readonly tips: TipCommands;
  readonly views: ViewCommands;
  readonly texts: TextCommands;
  readonly projects: ProjectCommands;
  /** Null where models are not unwrapped. */
  readonly unwrapping: UnwrapCommand | null;
  /** Null where the model is not the user's to change. */
  readonly variants: VariantCommand | null;
  readonly autosave: Autosave;
  readonly #models: ModelSession;
  readonly #router: UpdateRouter;
  readonly #drawing: DrawingTask;
  readonly #lost: LostDecal;
  readonly #trouble: EngineTrouble;
  #modeRequest = 0;

  constructor(parts: EditorParts) {
    const { engine, viewer, textureView, keeps = true, admission = null, language = "en", unwrap = null } = parts;
    this.store = new Store<EditorState>({ ...INITIAL_STATE, language });
    this.board = new NoticeBoard(this.store);
    this.tasks = new Tasks(this.store);
    this.engine = engine;
    this.viewer = viewer;
    this.textureView = textureView;
    const { store, board, tasks } = this;
    this.#drawing = new DrawingTask({ engine, tasks, label: () => this.strings.tasks.drawing });
    this.#lost = new LostDecal(viewer, board);
    this.library = new AssetLibrary(engine);
    this.#router = new UpdateRouter(engine, viewer, textureView, this.figures);
    this.session = new DesignSession({
      ...{ engine, library: this.library, store },
      viewer: { setDecals: (decals, selectedId) => this.decals.show(decals, selectedId) },
      later: (work) => this.#attempt(this.strings.errors.engineFault, work),
    });
    const send = this.session.send.bind(this.session);
    this.#trouble = new EngineTrouble({
      ...{ engine, board, store },
      send: () => send(this.session.design),
      undo: () => void this.files.travel("undo"),
    });
    const coming = this.session.recordsLater.bind(this.session);
    this.#models = new ModelSession({ engine, viewer, router: this.#router, store, tasks, send, coming });
    const { session, library } = this;
    const finishWork = (): void => this.tools.finish();
    this.layers = new LayerCommands({ session, viewer, store, board, admission, finishWork });
    const models = this.#models;
    const succeed = (before: ModelRef, after: ModelRef): void => this.autosave.succeed(before, after);
    this.unwrapping = unwrap && new UnwrapCommand({ store, session, models, board, tasks, unwrap, succeed });
    this.variants = unwrap && new VariantCommand({ store, session, models, board, succeed });
    const bare = new BareParts({ store, board, tasks, unwrapping: this.unwrapping });
    this.decals = new DecalCommands({ session, viewer, store, board, layers: this.layers, bare });
    const { decals, layers } = this;
    this.clipboard = new ClipboardCommands({ session, library, layers, store, board, tasks, admission });
    const projects = (): ProjectCommands => this.projects;
    this.files = new FileCommands({
      engine,
      store,
      session,
      models,
      decals,
      library,
      board,
      tasks,
      projects,
      admission,
      unwrapping: this.unwrapping,
      texts: () => this.texts,
      palettes: () => this.palettes,
      giveUp: () => this.tools.cancel(),
      finishWork,
    });
    const keeping = keepProjects({
      ...{ store, library, files: this.files, board, tasks, keeps },
      session,
      texts: () => this.texts,
      thumbnail: () => viewer.picture(THUMBNAIL_WIDTH, THUMBNAIL_HEIGHT),
    });
    this.projects = keeping.commands;
    this.autosave = keeping.autosave;
    session.setHistoryBudget(readHistoryBudget());
    store.set({ view: { ...store.state.view, aligns: readAligning() } });
    this.tools = new Toolbox({ viewer, textureView, store, board });
    const { tools } = this;
    const reach = new DecalReach(viewer, () => store.state.model?.info.materials ?? []);
    this.palettes = new PaletteCommands(tools, board);
    this.tips = new TipCommands({ library, store, tools, board, admission });
    registerTools({ engine, viewer, textureView, session, library, store, board, tools, reach, bare });
    tools.register(new PartsTool({ engine, viewer, textureView, store, board, layers: this.layers }));
    const showMaterial = (material: number): void => this.showMaterial(material);
    this.views = new ViewCommands({
      engine,
      viewer,
      textureView,
      store,
      figures: this.figures,
      board,
      tasks,
      showMaterial,
    });
    this.texts = new TextCommands({
      engine,
      viewer,
      session,
      store,
      board,
      library,
      decals,
      admission,
      tasks: this.tasks,
    });
    tools.register(textTool(this.texts, { viewer, textureView, store, board, tools }));
    this.#connect();
    // The page around an embedded editor has its own way.
    if (keeps) tellOfLostGraphics({ viewer, textureView, board, keep: () => this.autosave.flush() });
  }

  /** The view that is worked in. */
  get work(): HTMLElement {
    return (this.store.state.view.layout === "texture" ? this.textureView : this.viewer).element;
  }

  /** What it says, in its language. */
  get strings(): Strings {
    return stringsIn(this.store.state.language);
  }

  /**
   * Opens what this tab showed before, else the project that was open last, else (and for an address that ends in "?new")
   * the first demo, or says what to do without one.
   */
  async start(page: string): Promise<void> {
    // So the engine's code is fetched beside the model, not after it. Where it cannot be, whoever needs it is told.
    this.engine.idle().catch(() => undefined);
    try {
      await this.#openFirst(page);
    } finally {
      this.store.set({ starting: false });
    }
  }

  async #openFirst(page: string): Promise<void> {
    const demos = await this.#loadDemos(page);
    const address = new URL(page);
    const fresh = address.searchParams.has("new");
    if (!fresh && (await this.projects.openLast())) return;
    const [first] = demos?.models ?? [];
    if (first) await this.files.openDemo(first);
    // What begins here is a project like any other: the next visit shall bring it back.
    if (fresh) history.replaceState(history.state, "", withoutNew(address));
  }

  async #loadDemos(page: string): Promise<DemoCatalogue | null> {
    try {
      const demos = await loadDemoCatalogue(page, this.strings);
      this.store.set({ demos });
      return demos;
    } catch (thrown) {
      this.board.error(this.strings.errors.noDemosTitle, thrown);
      return null;
    }
  }

  /**
   * Opens a model with a design that is whole, as the first step of the history. Rejects with a TexelcastError.
   *
   * @param settings of its targets, by material
   */
  async open(ref: ModelRef, design: Design, settings: ReadonlyMap<number, TargetSettings> = new Map()): Promise<void> {
    await this.files.openProject({ name: fileStem(ref.title), model: ref, design, targets: settings });
  }

  configureTarget(settings: TargetSettings): void {
    const { material } = this.store.state;
    if (material === null) return;
    this.#attempt(this.strings.errors.couldNotBake, this.#models.configure(material, settings));
  }

  /** Gives every target that nobody has set otherwise that size; null: the model's own. */
  resizeTargets(size: number | null): void {
    const { targets, targetSettings } = this.store.state;
    this.store.set({ usualTarget: { size, gutter: null } });
    for (const material of targets.keys()) {
      if (!targetSettings.has(material)) this.#attempt(this.strings.errors.couldNotBake, this.#models.reopen(material));
    }
  }

  showMaterial(material: number): void {
    this.#attempt(this.strings.errors.couldNotBake, this.#models.showMaterial(material));
  }

  /** Shows the texture or one of the maps behind it. */
  setTextureMode(mode: TextureMode): void {
    this.store.set({ textureMode: mode });
    this.#modeRequest += 1;
    const { material, targets } = this.store.state;
    if (mode === "texture" || material === null || !targets.has(material)) this.textureView.setMode("texture");
    else this.#attempt(this.strings.errors.couldNotShowMap, this.#showMap(material, mode, this.#modeRequest));
  }

  async #showMap(material: number, view: MapView, request: number): Promise<void> {
    const picture = await this.engine.viewMap(material, view);
    // A newer choice may have overtaken this one.
    if (request === this.#modeRequest) this.textureView.setMode(view, picture);
  }

  /** Gives the views a target's whole picture again: their graphics context was lost. */
  refresh(material: number): void {
    this.#attempt(this.strings.errors.couldNotShow, this.#models.reopen(material));
  }

  /** Bytes. */
  setHistoryBudget(bytes: number): void {
    keepHistoryBudget(bytes);
    this.session.setHistoryBudget(bytes);
  }

  setOutlines(visible: boolean): void {
    this.store.set({ outlines: visible });
    this.textureView.setOutlinesVisible(visible);
  }

  /** Settles when no task runs and the engine has reported everything. Rejects where not all of it could be drawn. */
  async idle(): Promise<void> {
    let drawn: Promise<void>;
    do {
      await this.session.settled();
      drawn = this.engine.idle();
      await drawn.catch(() => undefined);
      // A frame, in which the views take up what was reported.
      await new Promise((resolve) => setTimeout(resolve, 0));
    } while (this.tasks.running);
    await drawn;
  }

  #connect(): void {
    this.viewer.setSurroundings((id) => {
      const { model, view } = this.store.state;
      return model && view.aligns ? surroundingsOf(this.decals.draggedWith(id), model.info) : null;
    });
    this.textureView.setSurroundings((id) => {
      const { material, view } = this.store.state;
      return view.aligns ? stampsBeside(this.decals.draggedWith(id), material) : null;
    });
    this.textureView.on("gesture", (gesture) => this.decals.followGesture(gesture));
    this.viewer.on("gradient", ({ place, phase }) =>
      followGradient(this.store.state, this.layers, place, phase, this.strings.gradient.moved),
    );
    this.viewer.on("needsFullUpdate", ({ material }) => this.refresh(material));
    this.engine.onError((error) => this.#trouble.tell(error));
    let seen = this.store.state;
    this.store.subscribe(() => {
      const before = seen;
      seen = this.store.state;
      this.#react(before, seen);
    });
  }

  /** What follows from a change of the state. While models are being switched, nothing does: the switch sees to it. */
  #react(before: EditorState, now: EditorState): void {
    // A new map is behind the picture that the texture view shows.
    if (shownTarget(before) !== shownTarget(now) && now.textureMode !== "texture") this.setTextureMode(now.textureMode);
    if (before.model !== now.model) this.textureView.setMode("texture");
    if (before.history.dropped === 0 && now.history.dropped > 0) this.#tellOfDroppedSteps(now);
    if (before.history !== now.history) this.#drawing.follow();
    if (now.switching) return;
    if (before.design !== now.design) {
      if (before.model === now.model) this.board.dismissInfos(before.notices);
      this.#attempt(this.strings.errors.couldNotBake, this.#models.ensureTargets(now.design));
    }
    if (before.history !== now.history) this.#lost.follow(now.model, this.session.recordedDesign, now.selectedId);
    this.textureView.setStamp(shownStamp(now, this.decals.movable));
    this.#showGradient(now);
    if (now.selectedId !== before.selectedId || now.editingMask !== before.editingMask) this.session.expectChange();
    const selected = layerById(now.design, now.selectedId);
    const other = now.selectedId !== before.selectedId;
    const movedOn = selected?.material !== layerById(before.design, before.selectedId)?.material;
    if (selected && (other || movedOn)) this.#follow(selected, now);
  }

  #showGradient(state: EditorState): void {
    const { from, to, center, radius, handle } = this.strings.gradient;
    const place = shownGradient(state);
    const names = place?.kind === "radial" ? ([center, radius] as const) : ([from, to] as const);
    this.viewer.setGradient(place, [handle(names[0]), handle(names[1])]);
  }

  /** The texture view and the target settings follow the selected layer to its material, or stay on one of them. */
  #follow(layer: DesignLayer, { model, material: shown }: EditorState): void {
    const materials = materialsIn(layer);
    if (shown !== null && materials.includes(shown)) return;
    const paintable = model?.info.materials.filter(({ refusal }) => refusal === null).map(({ index }) => index);
    const first = materials.find((material) => paintable?.includes(material));
    if (first !== undefined) this.showMaterial(first);
  }

  /** Once, and not at each step that goes. */
  #tellOfDroppedSteps({ history }: EditorState): void {
    const message = this.strings.history.dropped(this.strings.history.megabytes(megabytes(history.budget)));
    this.board.info({ title: this.strings.history.droppedTitle, message });
  }

  #attempt(title: string, work: Promise<void>): void {
    void this.tasks.quietly(work.catch((thrown: unknown) => this.board.error(title, thrown)));
  }
}

function shownTarget({ targets, material }: EditorState): TargetInfo | undefined {
  return material === null ? undefined : targets.get(material);
}

function withoutNew(address: URL): string {
  address.searchParams.delete("new");
  return address.href;
}
