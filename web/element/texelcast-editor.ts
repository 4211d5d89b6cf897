/**
 * `<texelcast-editor>`: the element that a page writes. Light until it is seen or touched; then it brings the mode that the
 * page asks for, and opens the page's model and design in it. Importing this file registers nothing and runs in bare Node.
 */
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Design } from "../editor/document/design.ts";
import { controls } from "../editor/ui/theme.ts";
import { ANY_ORBIT, type Orbit, parseOrbit } from "../viewer/camera-orbit.ts";
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
  TexelcastEditorEventMap,
  TexelcastEditorProperties,
  TextOptions,
} from "./element-api.ts";
import { cover, notice } from "./element-cover.ts";
import { errorDetail, isCancelled, type ShownError, typedError } from "./element-errors.ts";
import { DEFAULTS, PROPERTIES, wholeNumber } from "./element-properties.ts";
import { FETCHED, Run } from "./element-run.ts";
import { elementStyles } from "./element-styles.ts";
import type { Mode, ModeHost } from "./mode.ts";
import { tokens } from "./shop/tokens.ts";
import { english, languageOf, type Words, wordsIn } from "./words/words.ts";

/** Milliseconds of rest after which a change is told. */
const CHANGE_REST = 120;
/** How far beyond the window the element counts as about to be seen. */
const NEAR = "200px";

type EventName = keyof TexelcastEditorEventMap;
type Detail<Name extends EventName> = TexelcastEditorEventMap[Name]["detail"];

type Events = Omit<HTMLElementEventMap, EventName> & TexelcastEditorEventMap;
type Listener<Type extends keyof Events> = (this: TexelcastEditor, event: Events[Type]) => unknown;

/** Some of its events have the names of the browser's own, and carry more. */
export interface TexelcastEditor {
  addEventListener<Type extends keyof Events>(
    type: Type,
    listener: Listener<Type>,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<Type extends keyof Events>(
    type: Type,
    listener: Listener<Type>,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
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
    return this.#told(this.#ready().then((mode) => this.#exported(mode)));
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
    if (changed.has("loading") || changed.has("src")) this.#watchSight();
    if (changed.has("locale")) void this.#speak();
    if (this.#phase === "idle") return;
    // What they were when it began is known from then on: the first values are no change.
    if (this.#run && (changed.has("src") || changed.has("mode") || changed.has("wasmUrl"))) {
      void this.restart().catch(() => undefined);
      return;
    }
    const mode = this.#mode;
    if (!mode) return;
    if (changed.has("zones")) void this.#told(this.#useZones(mode));
    if (changed.has("design")) void this.#told(this.#takeDesign(mode));
    if (changed.has("size") || changed.has("material")) void this.#told(mode.resize());
    this.#tried(() => {
      mode.configure();
      return true;
    });
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
    const design = this.#kept === null ? { given: this.design } : { kept: this.#kept };
    const run = new Run({
      kind: this.mode,
      src: this.src,
      zones: this.zones === "" ? null : this.zones,
      design,
      base: document.baseURI,
      words: this.#words,
      limits: this.#settings.limits,
      host: this.#modeHost(this.#viewHost),
      progress: (share) => this.#progress(share),
    });
    this.#run = run;
    try {
      const mode = await run.open();
      if (this.#run !== run) throw new TexelcastError("cancelled", this.#words.errors.notReady);
      const { cameraOrbit } = this;
      if (cameraOrbit !== "")
        mode.desk.viewer.setCamera(parseOrbit(cameraOrbit, "camera-orbit"), this.#settings.camera);
      this.#phase = "ready";
      this.#progress(1);
      if (mode.desk.design.layers.length > 0) void this.#told(this.#measure(mode));
      const materials = (mode.desk.store.state.model?.info.materials ?? []).map(({ index, name, refusal }) => ({
        index,
        name,
        paintable: refusal === null,
      }));
      this.#send("load", { materials, milliseconds: Math.round(performance.now() - began) });
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

  async #exported(mode: Mode): Promise<ExportedDesign> {
    const { DesignExport } = await import("./desk/export-design.ts");
    return await new DesignExport().whole(mode.desk.design);
  }

  async #submit(): Promise<SubmitDetail> {
    const mode = await this.#ready();
    const { exportTexture, printOptions, printReport } = await import("./desk/prints.ts");
    const exported = await this.#exported(mode);
    const print = printOptions(mode, {}, this.#settings);
    const texture = await exportTexture(mode, print);
    const report = mode.desk.zones === null ? null : await printReport(mode);
    const detail = { ...exported, print, texture, report };
    if (this.#send("submit", detail)) this.#announce(this.#words.submitted);
    return detail;
  }

  get #settings(): DeskSettings {
    const number = (name: string, value: number | null, least: number, most: number): number | null => {
      const whole = wholeNumber(value, null, least, most);
      if (value === null || whole !== null) return whole;
      const hint = `${least} – ${most}`;
      throw new TexelcastError("bad-argument", this.#words.errors.badOption(name), {
        field: name,
        value: String(value),
        hint,
      });
    };
    const orbit = (name: string, value: string): Orbit => (value ? parseOrbit(value, name) : ANY_ORBIT);
    return {
      words: this.#words,
      material: number("material", this.material, 0, 65_535),
      size: number("size", this.size, 1, 8192),
      readonly: this.readonly,
      maxDecals: number("max-decals", this.maxDecals, 0, 10_000),
      limits: {
        megapixels: positive(this.maxMegapixels, DEFAULTS.maxMegapixels),
        bytes: positive(this.maxFileSize, DEFAULTS.maxFileSize),
      },
      camera: {
        min: orbit("min-camera-orbit", this.minCameraOrbit),
        max: orbit("max-camera-orbit", this.maxCameraOrbit),
      },
      beforeAccept: this.beforeAccept,
    };
  }

  #modeHost(view: HTMLElement): ModeHost {
    const settings = (): DeskSettings => this.#settings;
    const words = (): Words => this.#words;
    const shownError = (): ShownError | null => this.#shownError;
    const hooks: DeskHooks = {
      settings,
      changed: () => this.#changed(),
      selected: (id) => this.#send("select", { id }),
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

  /** A design that was brought along has its badges from the start, and is no change. */
  async #measure(mode: Mode): Promise<void> {
    if (mode.desk.zones === null) return;
    const { printReport } = await import("./desk/prints.ts");
    const { design } = mode.desk;
    const report = await printReport(mode);
    if (mode.desk.design === design) mode.desk.report = report;
    this.requestUpdate();
  }

  async #sendChange(): Promise<void> {
    const run = this.#run;
    const mode = run?.mode;
    if (!mode) return;
    const { countsOf, DesignExport } = await import("./desk/export-design.ts");
    const { layerAreas, printReport } = await import("./desk/prints.ts");
    const { design } = mode.desk;
    this.#exports ??= new DesignExport();
    const named = await this.#exports.named(design);
    const report = await printReport(mode);
    // A newer change tells itself.
    if (this.#run !== run || mode.desk.design !== design) return;
    mode.desk.report = report;
    this.requestUpdate();
    const areas = layerAreas(mode, report);
    const { canUndo, canRedo } = this;
    const totalArea = areas.reduce((sum, { area }) => sum + area, 0);
    this.#send("change", { design: named, counts: countsOf(design), areas, totalArea, canUndo, canRedo });
  }

  async #speak(): Promise<void> {
    const wishes = [this.locale, this.closest("[lang]")?.getAttribute("lang"), ...navigator.languages];
    this.#words = await wordsIn(languageOf(wishes));
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
    if (!isCancelled(thrown)) this.#send("error", errorDetail(typedError(thrown, this.#words)));
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
    this.#send("progress", { share });
    this.requestUpdate();
  }

  /** False where a listener has prevented what follows. */
  #send<Name extends EventName>(type: Name, detail: Detail<Name>): boolean {
    const bubbles = type === "change" || type === "select";
    return this.dispatchEvent(
      new CustomEvent(type, { detail, bubbles, composed: bubbles, cancelable: type === "submit" }),
    );
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

const positive = (value: number | null, otherwise: number): number =>
  value !== null && value > 0 && Number.isFinite(value) ? value : otherwise;

function makeViewHost(): HTMLElement {
  const view = document.createElement("div");
  view.className = "own view";
  return view;
}
