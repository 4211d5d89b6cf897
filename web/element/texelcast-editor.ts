/**
 * `<texelcast-editor>`: the element that a page writes. Light until it is seen or touched; then it brings the mode that the
 * page asks for, and opens the page's model and design in it. Importing this file registers nothing and runs in bare Node.
 */
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Design } from "../editor/document/design.ts";
import { controls } from "../editor/ui/theme.ts";
import type { DeskHooks, DeskSettings } from "./desk/desk-settings.ts";
import type { DesignExport } from "./desk/export-design.ts";
import type {
  DecalSource,
  ExportedDesign,
  ExportedTexture,
  ExportTextureOptions,
  PlaceOptions,
  PrintReport,
  SnapshotOptions,
  SnapshotView,
  SubmitDetail,
  TexelcastEditorApi,
  TexelcastEditorProperties,
  TextOptions,
} from "./element-api.ts";
import { cover, notice } from "./element-cover.ts";
import { errorDetail, isCancelled, type ShownError, typedError } from "./element-errors.ts";
import { type EditorEvents, sendEvent } from "./element-events.ts";
import { DEFAULTS, PROPERTIES } from "./element-properties.ts";
import { FETCHED, Run } from "./element-run.ts";
import { readSettings } from "./element-settings.ts";
import { elementStyles } from "./element-styles.ts";
import type { Mode, ModeHost } from "./mode.ts";
import { tokens } from "./shop/tokens.ts";
import { english, languageOf, type Words, wordsIn } from "./words/words.ts";

/** Milliseconds of rest after which a change is told. */
const CHANGE_REST = 120;
/** How far beyond the window the element counts as about to be seen. */
const NEAR = "200px";

type Listener<Type extends keyof EditorEvents> = (this: TexelcastEditor, event: EditorEvents[Type]) => unknown;
type AnyListener = EventListenerOrEventListenerObject;
type Options = boolean | AddEventListenerOptions;

export interface TexelcastEditor {
  addEventListener<Type extends keyof EditorEvents>(type: Type, listener: Listener<Type>, options?: Options): void;
  addEventListener(type: string, listener: AnyListener, options?: Options): void;
  removeEventListener<Type extends keyof EditorEvents>(type: Type, listener: Listener<Type>, options?: Options): void;
  removeEventListener(type: string, listener: AnyListener, options?: Options): void;
}

/**
 * A product that customers put pictures and words on, in a shop's page.
 *
 * @tagname texelcast-editor
 * @attr {string} src - Address of the model: a .glb, or a .gltf with its files beside it.
 * @attr {string} design - Address of a design's JSON.
 * @attr {string} zones - Address of the product's zones file.
 * @attr {"shop" | "full"} mode - Pictures and words on a product, or the whole editor. Default "shop".
 * @attr {number} material - glTF material index that new things go on, and that is printed. Default: the model's largest.
 * @attr {number} size - Texels of the texture's side. Default: the model's own.
 * @attr {string} locale - Language of the element: "en", "de". Default: the page's.
 * @attr {boolean} readonly - Shows the design and lets nobody change it.
 * @attr {string} poster - Address of a picture that is shown until the model is.
 * @attr {"auto" | "lazy" | "eager"} loading - When it begins: about to be seen, touched, or at once. Default "auto".
 * @attr {number} max-decals - Pictures and texts that may be put on the product.
 * @attr {number} max-megapixels - Millions of pixels of a picture. Default 64.
 * @attr {number} max-file-size - Bytes of an uploaded file. Default 20971520.
 * @attr {string} camera-orbit - Where the camera begins: "30deg 75deg 105%".
 * @attr {string} min-camera-orbit - The least of each part; "auto" is no limit.
 * @attr {string} max-camera-orbit - The most of each part; "auto" is no limit.
 * @attr {string} wasm-url - Address of the engine's WebAssembly. Default: beside the script.
 *
 * @fires {CustomEvent<LoadDetail>} load - The model is shown and can be worked on.
 * @fires {CustomEvent<ProgressDetail>} progress - How far loading has come, 0 to 1.
 * @fires {CustomEvent<ChangeDetail>} change - The design is another one: with counts and printed areas.
 * @fires {CustomEvent<SelectDetail>} select - Another layer is chosen, or none.
 * @fires {CustomEvent<ErrorDetail>} error - Something did not work; nothing of the design is lost.
 * @fires {CustomEvent<SubmitDetail>} submit - The user is done: the design, its files, the print file and its hash.
 *
 * @slot poster - Shown until the model is.
 * @slot progress - In place of the bar while it loads.
 * @slot toolbar - Beside the view's own tools.
 * @slot empty - In place of what is said while nothing is on the product.
 * @slot submit - The words of the button that hands the design in.
 *
 * @csspart cover - All of the element before the model is shown.
 * @csspart poster - The poster's picture.
 * @csspart progress - The bar.
 * @csspart stage - The view's ground.
 * @csspart toolbar - Over the view.
 * @csspart panel - Beside the view, or under it.
 * @csspart add - The buttons that add something.
 * @csspart list - What is on the product, and its fields.
 * @csspart row - One thing on the product.
 * @csspart fields - Fields of what is chosen.
 * @csspart findings - What the printer would say of what is chosen.
 * @csspart badge - The same in a word.
 * @csspart empty - What is said while nothing is on the product.
 * @csspart foot - Around the button that hands the design in.
 * @csspart button - Every button with words, and the tools.
 * @csspart start-button - Begins to load.
 * @csspart upload-button - Adds a picture.
 * @csspart text-button - Adds a text.
 * @csspart undo-button - One step back.
 * @csspart redo-button - One step forth.
 * @csspart heat-button - Shows the print's quality.
 * @csspart fit-button - Shows the whole product.
 * @csspart submit-button - Hands the design in.
 * @csspart notice - An error.
 * @csspart full - The whole editor.
 *
 * @cssprop --texelcast-height - Height of the element. Default min(44rem, 85svh).
 * @cssprop --texelcast-accent - Buttons, marks, the decal's handles.
 * @cssprop --texelcast-accent-text - On the accent.
 * @cssprop --texelcast-surface - The panel.
 * @cssprop --texelcast-surface-low - Fields on the panel.
 * @cssprop --texelcast-stage - Behind the product.
 * @cssprop --texelcast-text - Words.
 * @cssprop --texelcast-text-quiet - Words of lesser weight.
 * @cssprop --texelcast-line - Borders.
 * @cssprop --texelcast-radius - Corners. Default 8px.
 * @cssprop --texelcast-font - Families of the type.
 */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: only overloads of what every element has.
export class TexelcastEditor extends LitElement implements TexelcastEditorApi {
  static override properties = PROPERTIES;
  static override styles = [tokens, controls, elementStyles];

  declare src: TexelcastEditorProperties["src"];
  declare design: TexelcastEditorProperties["design"];
  declare zones: TexelcastEditorProperties["zones"];
  declare mode: TexelcastEditorProperties["mode"];
  declare material: TexelcastEditorProperties["material"];
  declare size: TexelcastEditorProperties["size"];
  declare locale: TexelcastEditorProperties["locale"];
  declare readonly: TexelcastEditorProperties["readonly"];
  declare poster: TexelcastEditorProperties["poster"];
  declare loading: TexelcastEditorProperties["loading"];
  declare maxDecals: TexelcastEditorProperties["maxDecals"];
  declare maxMegapixels: TexelcastEditorProperties["maxMegapixels"];
  declare maxFileSize: TexelcastEditorProperties["maxFileSize"];
  declare cameraOrbit: TexelcastEditorProperties["cameraOrbit"];
  declare minCameraOrbit: TexelcastEditorProperties["minCameraOrbit"];
  declare maxCameraOrbit: TexelcastEditorProperties["maxCameraOrbit"];
  declare wasmUrl: TexelcastEditorProperties["wasmUrl"];
  declare beforeAccept: TexelcastEditorProperties["beforeAccept"];

  #phase: "idle" | "loading" | "failed" | "ready" = "idle";
  #share = 0;
  #shownError: ShownError | null = null;
  #announcement = "";
  #words: Words = english;
  #run: Run | null = null;
  #starting: Promise<void> | null = null;
  /** What was worked on when the mode was closed last. */
  #kept: Design | null = null;
  #viewHost: HTMLElement | null = null;
  #sight: IntersectionObserver | null = null;
  #changeTimer: ReturnType<typeof setTimeout> | undefined;
  #exports: DesignExport | null = null;

  constructor() {
    super();
    Object.assign(this, DEFAULTS);
  }

  get loaded(): boolean {
    return this.#phase === "ready";
  }
  get selected(): string | null {
    return this.#mode?.desk.store.state.selectedId ?? null;
  }
  get canUndo(): boolean {
    return (this.#mode?.desk.store.state.undoLabel ?? null) !== null;
  }
  get canRedo(): boolean {
    return (this.#mode?.desk.store.state.redoLabel ?? null) !== null;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.addEventListener("pointerdown", this.#touched);
    this.addEventListener("focusin", this.#touched);
    this.#watchSight();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener("pointerdown", this.#touched);
    this.removeEventListener("focusin", this.#touched);
    this.#sight?.disconnect();
    this.#sight = null;
    // What is only moved to another place of the page goes on as it is.
    setTimeout(() => {
      if (!this.isConnected) this.#close();
    });
  }

  /** Begins to load, whatever `loading` says. */
  start(): Promise<void> {
    this.#starting ??= this.#told(this.#start()).finally(() => {
      if (this.#phase === "failed" || this.#phase === "idle") this.#starting = null;
    });
    this.#starting.catch(() => undefined);
    return this.#starting;
  }

  addDecal(source: DecalSource, options?: PlaceOptions): Promise<string> {
    return this.#told(this.#ready().then((mode) => mode.addDecal(source, options)));
  }

  addText(text: string, options?: TextOptions): Promise<string> {
    return this.#told(this.#ready().then((mode) => mode.addText(text, options)));
  }

  select(id: string | null): boolean {
    return this.#mode?.desk.select(id) ?? false;
  }

  removeLayer(id: string): boolean {
    return this.#tried(() => this.#mode?.desk.remove(id));
  }

  undo(): boolean {
    return this.#tried(() => this.#mode?.desk.travel(-1));
  }

  redo(): boolean {
    return this.#tried(() => this.#mode?.desk.travel(1));
  }

  exportTexture(options: ExportTextureOptions = {}): Promise<ExportedTexture> {
    return this.#told(
      this.#ready().then(async (mode) => {
        const { exportTexture, printOptions } = await import("./desk/prints.ts");
        return await exportTexture(mode, printOptions(mode, options, this.#settings));
      }),
    );
  }

  exportModel(): Promise<Uint8Array> {
    return this.#told(
      this.#ready().then(async (mode) => {
        await mode.idle();
        return await mode.desk.engine.exportGlb();
      }),
    );
  }

  exportDesign(): Promise<ExportedDesign> {
    return this.#told(
      this.#ready().then(async (mode) => {
        const { DesignExport } = await import("./desk/export-design.ts");
        return await new DesignExport().whole(mode.desk.design);
      }),
    );
  }

  snapshot(view?: SnapshotView, options?: SnapshotOptions): Promise<Blob>;
  snapshot(views: readonly SnapshotView[], options?: SnapshotOptions): Promise<Blob[]>;
  snapshot(
    views: SnapshotView | readonly SnapshotView[] = "current",
    options: SnapshotOptions = {},
  ): Promise<Blob | Blob[]> {
    return this.#told(
      this.#ready().then(async (mode): Promise<Blob | Blob[]> => {
        const { takeSnapshots } = await import("./desk/snapshots.ts");
        if (typeof views !== "string") return await takeSnapshots(mode, views, options, this.#words);
        const [picture] = await takeSnapshots(mode, [views], options, this.#words);
        return picture as Blob;
      }),
    );
  }

  validate(): Promise<PrintReport> {
    return this.#told(
      this.#ready().then(async (mode) => {
        const { printReport } = await import("./desk/prints.ts");
        return await printReport(mode);
      }),
    );
  }

  submit(): Promise<SubmitDetail> {
    return this.#told(this.#submit());
  }

  async restart(): Promise<void> {
    this.#close();
    await this.start();
  }

  override render(): TemplateResult {
    const words = this.#words;
    const dismiss = (): void => this.#dismiss();
    // Under the cover already: the view has its place and size when the model comes.
    const face = this.#run?.made?.render() ?? this.#viewHost;
    return html`
      ${face}
      ${
        this.#phase === "ready"
          ? nothing
          : cover({
              words,
              poster: this.poster,
              phase: this.#phase,
              share: this.#share,
              error: this.#shownError,
              start: () => void this.start(),
            })
      }
      ${this.#phase === "ready" && this.#shownError ? notice(this.#shownError, words, dismiss) : nothing}
      <div class="visually-hidden" role="status">${this.#announcement}</div>
    `;
  }

  protected override updated(changed: PropertyValues<this>): void {
    const has = (...names: (keyof TexelcastEditorProperties)[]): boolean => names.some((name) => changed.has(name));
    for (const [name, fault] of readSettings(this, this.#words).faults) if (has(name)) this.#report(fault);
    if (has("loading", "src")) this.#watchSight();
    if (has("locale")) void this.#speak();
    const mode = this.#mode;
    // Another design takes the place of the one that was worked on before.
    if (has("design") && !mode) this.#kept = null;
    if (this.#phase === "idle" || changed.size === 0) return;
    const anew = has("src", "mode", "wasmUrl");
    if (anew || (has("design") && !mode)) {
      // What they were when it began is known from then on: the first values are no change.
      if (this.#run === null && this.#phase === "loading") return;
      this.#close();
      if (has("design")) this.#kept = null;
      void this.start();
      return;
    }
    if (!mode) return;
    if (has("zones")) void this.#told(this.#useZones(mode));
    if (has("design")) void this.#told(this.#takeDesign(mode));
    if (has("size", "material")) void this.#told(mode.resize());
    if (has("readonly", "minCameraOrbit", "maxCameraOrbit")) {
      this.#tried(() => {
        mode.configure();
        return true;
      });
    }
  }

  get #mode(): Mode | null {
    return this.#run?.mode ?? null;
  }

  async #start(): Promise<void> {
    const began = performance.now();
    this.#phase = "loading";
    this.#shownError = null;
    this.#progress(0);
    this.#viewHost ??= makeViewHost();
    await this.#speak();
    await this.updateComplete;
    const run = new Run({
      kind: this.mode,
      src: this.src,
      zones: this.zones === "" ? null : this.zones,
      design: this.#kept === null ? { given: this.design } : { kept: this.#kept },
      base: document.baseURI,
      words: this.#words,
      limits: this.#settings.limits,
      host: this.#modeHost(this.#viewHost),
      progress: (share) => this.#progress(share),
    });
    this.#run = run;
    try {
      const mode = await run.open();
      const { orbit, settings } = readSettings(this, this.#words);
      if (orbit !== null) mode.desk.viewer.setCamera(orbit, settings.camera);
      this.#phase = "ready";
      this.#progress(1);
      if (mode.desk.design.layers.length > 0 && mode.desk.zones !== null) void this.#told(this.#sendChange(false));
      const { loadDetail } = await import("./desk/hand-over.ts");
      sendEvent(this, "load", loadDetail(mode, began));
    } catch (thrown) {
      if (this.#run === run) {
        this.#run = null;
        this.#phase = "failed";
        const { message, hint = "" } = typedError(thrown, this.#words);
        this.#shownError = { message, hint };
      }
      throw thrown;
    } finally {
      this.requestUpdate();
    }
  }

  /** Ends what runs; what was designed stays. */
  #close(): void {
    clearTimeout(this.#changeTimer);
    const mode = this.#mode;
    if (mode) this.#kept = mode.desk.design;
    this.#run?.close();
    this.#run = null;
    this.#starting = null;
    this.#viewHost?.replaceChildren();
    this.#phase = "idle";
    this.#shownError = null;
    this.requestUpdate();
    this.#watchSight();
  }

  async #ready(): Promise<Mode> {
    await this.start();
    const mode = this.#mode;
    if (!mode) throw new TexelcastError("cancelled", this.#words.errors.notReady);
    return mode;
  }

  #adopt({ styles }: Mode): void {
    const root = this.renderRoot;
    if (!(root instanceof ShadowRoot)) return;
    for (const { styleSheet } of styles) {
      if (styleSheet && !root.adoptedStyleSheets.includes(styleSheet)) root.adoptedStyleSheets.push(styleSheet);
    }
  }

  async #takeDesign(mode: Mode): Promise<void> {
    const run = this.#run;
    const design = await run?.readDesign(mode.desk.library, this.design ?? undefined);
    if (design && this.#run === run) mode.desk.takeDesign(design);
  }

  async #useZones({ desk }: Mode): Promise<void> {
    const { zones } = this;
    const read = zones === null || zones === "" ? null : await this.#run?.readZones(zones);
    if (this.zones !== zones || read === undefined || desk.closed) return;
    await desk.useZones(read);
    this.#changed();
  }

  async #submit(): Promise<SubmitDetail> {
    const mode = await this.#ready();
    const { submitDetail } = await import("./desk/hand-over.ts");
    const detail = await submitDetail(mode);
    if (sendEvent(this, "submit", detail)) this.#announce(this.#words.submitted);
    return detail;
  }

  get #settings(): DeskSettings {
    return readSettings(this, this.#words).settings;
  }

  #modeHost(view: HTMLElement): ModeHost {
    const settings = (): DeskSettings => this.#settings;
    const words = (): Words => this.#words;
    const shownError = (): ShownError | null => this.#shownError;
    const hooks: DeskHooks = {
      settings,
      changed: () => this.#changed(),
      selected: (id) => sendEvent(this, "select", { id }),
      failed: (thrown) => this.#tell(thrown),
      progress: (share) => this.#progress(FETCHED + (1 - FETCHED) * share),
      announce: (text) => this.#announce(text),
    };
    return {
      hooks,
      view,
      wasm: this.wasmUrl,
      get words() {
        return words();
      },
      get shownError() {
        return shownError();
      },
      tell: (thrown) => this.#tell(thrown),
      dismiss: () => this.#dismiss(),
      submit: () => this.#submit(),
      requestUpdate: () => this.requestUpdate(),
      made: async (mode) => {
        this.#adopt(mode);
        this.requestUpdate();
        await this.updateComplete;
      },
    };
  }

  #changed(): void {
    clearTimeout(this.#changeTimer);
    this.#changeTimer = setTimeout(() => void this.#told(this.#sendChange()), CHANGE_REST);
  }

  /** A design that was brought along is measured for its badges, and is no change. */
  async #sendChange(tell = true): Promise<void> {
    const run = this.#run;
    const mode = run?.mode;
    if (!mode) return;
    const { changeDetail, DesignExport } = await import("./desk/hand-over.ts");
    this.#exports ??= new DesignExport();
    const detail = await changeDetail(mode, this.#exports);
    // A newer change tells itself.
    if (this.#run !== run || detail === null) return;
    this.requestUpdate();
    if (tell) sendEvent(this, "change", detail);
  }

  async #speak(): Promise<void> {
    const wishes = [this.locale, this.closest("[lang]")?.getAttribute("lang"), ...navigator.languages];
    this.#words = await wordsIn(languageOf(wishes));
    this.#mode?.configure();
    this.requestUpdate();
  }

  /** Tells the page of a call that fails; whoever made the call is told by its promise, and need not listen. */
  #told<T>(work: Promise<T>): Promise<T> {
    const told = work.catch((thrown: unknown) => {
      this.#report(thrown);
      throw thrown;
    });
    told.catch(() => undefined);
    return told;
  }

  #tried(act: () => boolean | undefined): boolean {
    try {
      return act() ?? false;
    } catch (thrown) {
      this.#report(thrown);
      return false;
    }
  }

  #report(thrown: unknown): void {
    if (!isCancelled(thrown)) sendEvent(this, "error", errorDetail(typedError(thrown, this.#words)));
  }

  /** Tells the user, too. */
  #tell(thrown: unknown): void {
    if (isCancelled(thrown)) return;
    const { message, hint = "" } = typedError(thrown, this.#words);
    this.#shownError = { message, hint };
    this.requestUpdate();
    this.#report(thrown);
  }

  #dismiss(): void {
    this.#shownError = null;
    this.requestUpdate();
  }

  #announce(text: string): void {
    // A live region speaks only when its text changes, which a space at the end does without being heard.
    this.#announcement = this.#announcement === text ? `${text}\u00a0` : text;
    this.requestUpdate();
  }

  #progress(share: number): void {
    this.#share = share;
    sendEvent(this, "progress", { share });
    this.requestUpdate();
  }

  readonly #touched = (): void => {
    if (this.#phase === "idle" && this.src) void this.start();
  };

  #watchSight(): void {
    this.#sight?.disconnect();
    this.#sight = null;
    if (this.#phase !== "idle" || !this.src || !this.isConnected) return;
    if (this.loading === "eager") void this.start();
    else if (this.loading !== "lazy") {
      this.#sight = new IntersectionObserver(
        (entries) => {
          if (entries.some(({ isIntersecting }) => isIntersecting)) void this.start();
        },
        { rootMargin: NEAR },
      );
      this.#sight.observe(this);
    }
  }
}

function makeViewHost(): HTMLElement {
  const view = document.createElement("div");
  view.className = "own view";
  return view;
}
