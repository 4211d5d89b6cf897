/**
 * `<texelcast-editor>`: the element that a page writes. Light until it is seen or touched; then it brings the mode that the
 * page asks for, and opens the page's model and design in it. Importing this file registers nothing and runs in bare Node.
 */
import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { RemElement } from "../editor/ui/rem-element.ts";
import { plainControls } from "../editor/ui/theme.ts";
import type {
  DecalSource,
  ExportedDesign,
  ExportedTexture,
  ExportModelOptions,
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
import type { EditorEvents } from "./element-events.ts";
import { DEFAULTS, PROPERTIES } from "./element-properties.ts";
import { readSettings } from "./element-settings.ts";
import { Sight } from "./element-sight.ts";
import { elementStyles } from "./element-styles.ts";
import { Voice } from "./element-voice.ts";
import { Work } from "./element-work.ts";
import { keepRem } from "./keep-rem.ts";
import type { AtDesk, Mode } from "./mode.ts";
import { tokens } from "./shop/tokens.ts";

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
 * @attr {string} wording - Address of words in another language, or of the shop's own, in JSON.
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
export class TexelcastEditor extends RemElement implements TexelcastEditorApi {
  /** @internal */
  static override properties = PROPERTIES;
  /** @internal */
  static override styles = [tokens, plainControls, elementStyles];

  declare src: TexelcastEditorProperties["src"];
  declare design: TexelcastEditorProperties["design"];
  declare zones: TexelcastEditorProperties["zones"];
  declare mode: TexelcastEditorProperties["mode"];
  declare material: TexelcastEditorProperties["material"];
  declare size: TexelcastEditorProperties["size"];
  declare locale: TexelcastEditorProperties["locale"];
  declare wording: TexelcastEditorProperties["wording"];
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

  readonly #voice = new Voice(this);
  readonly #work = new Work({ element: this, voice: this.#voice, idle: () => this.#watchSight() });
  /** Taken out of the page; one that never was in it stays open until it has been. */
  #gone = false;
  /** Methods that are at work. */
  #calls = 0;
  readonly #sight = new Sight(this, () => void this.start());

  constructor() {
    super();
    Object.assign(this, DEFAULTS);
  }

  get loaded(): boolean {
    return this.#work.phase === "ready";
  }
  get selected(): string | null {
    return this.#work.mode?.desk?.store.state.selectedId ?? null;
  }
  get canUndo(): boolean {
    return (this.#work.mode?.desk?.store.state.undoLabel ?? null) !== null;
  }
  get canRedo(): boolean {
    return (this.#work.mode?.desk?.store.state.redoLabel ?? null) !== null;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    keepRem(this.renderRoot as ShadowRoot);
    this.#gone = false;
    this.addEventListener("pointerdown", this.#touched);
    this.addEventListener("focusin", this.#touched);
    this.#watchSight();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener("pointerdown", this.#touched);
    this.removeEventListener("focusin", this.#touched);
    this.#sight.end();
    // What is only moved to another place of the page goes on as it is.
    setTimeout(() => {
      this.#gone = !this.isConnected;
      if (this.#gone) this.#work.close();
    });
  }

  /** @internal */
  override adoptedCallback(): void {
    super.adoptedCallback();
    // Its graphics and listeners are those of another window; it opens anew in this one.
    if (this.renderRoot) this.#work.close();
  }

  /** Begins to load, whatever `loading` says. */
  start(): Promise<void> {
    // What the page has set before it asks holds for what it asks: another product is begun by then.
    return this.#held(this.updateComplete.then(() => this.#work.start()));
  }

  addDecal(source: DecalSource, options?: PlaceOptions): Promise<string> {
    return this.#with((mode) => mode.addDecal(source, options));
  }

  addText(text: string, options?: TextOptions): Promise<string> {
    return this.#with((mode) => mode.addText(text, options));
  }

  select(id: string | null): boolean {
    return this.#work.mode?.desk?.select(id) ?? false;
  }

  removeLayer(id: string): boolean {
    return this.#voice.tried(() => this.#work.mode?.desk?.remove(id));
  }

  undo(): boolean {
    return this.#voice.tried(() => this.#work.mode?.desk?.travel(-1));
  }

  redo(): boolean {
    return this.#voice.tried(() => this.#work.mode?.desk?.travel(1));
  }

  exportTexture(options: ExportTextureOptions = {}): Promise<ExportedTexture> {
    return this.#atDesk(async (mode) => {
      const { exportAsAsked } = await import("./desk/check-print.ts");
      return await exportAsAsked(mode, options);
    });
  }

  exportModel(options: ExportModelOptions = {}): Promise<Uint8Array<ArrayBuffer>> {
    return this.#atDesk(async (mode) => {
      const { exportModel } = await import("./desk/export-model.ts");
      return await exportModel(mode, options);
    });
  }

  exportDesign(): Promise<ExportedDesign> {
    return this.#atDesk(async (mode) => {
      const { exportShown } = await import("./desk/export-design.ts");
      return await exportShown(mode);
    });
  }

  snapshot(view?: SnapshotView, options?: SnapshotOptions): Promise<Blob>;
  snapshot(views: readonly SnapshotView[], options?: SnapshotOptions): Promise<Blob[]>;
  snapshot(
    views: SnapshotView | readonly SnapshotView[] = "current",
    options: SnapshotOptions = {},
  ): Promise<Blob | Blob[]> {
    return this.#with(async (mode) => {
      const { snapshot } = await import("./desk/snapshots.ts");
      return await snapshot(mode, views, options, this.#voice.words);
    });
  }

  validate(): Promise<PrintReport> {
    return this.#atDesk(async (mode) => {
      const { printReport } = await import("./desk/prints.ts");
      return await printReport(mode);
    });
  }

  submit(): Promise<SubmitDetail> {
    return this.#called(this.#work.submit());
  }

  restart(): Promise<void> {
    this.#work.close();
    return this.start();
  }

  /** @internal */
  override render(): TemplateResult {
    const { words, shownError, announcement } = this.#voice;
    const { phase, share, made, view } = this.#work;
    const { poster } = this;
    const start = (): void => void this.start();
    // Under the cover already: the view has its place and size when the model comes.
    return html`
      ${made?.render() ?? view}
      ${phase === "ready" ? nothing : cover({ words, poster, phase, share, error: shownError, start })}
      ${phase === "ready" && shownError ? notice(shownError, words, () => this.#voice.dismiss()) : nothing}
      <div class="visually-hidden" role="status" lang=${words.lang}>${announcement}</div>
    `;
  }

  /** @internal */
  protected override update(changed: PropertyValues<this>): void {
    const root = this.renderRoot as ShadowRoot;
    const had = root.activeElement;
    super.update(changed);
    const { made, view } = this.#work;
    // What had the keyboard is gone: it goes on in the view, and not at the top of the page.
    if (had && !root.activeElement) (made?.viewer.element ?? view)?.focus({ preventScroll: true });
  }

  /** @internal */
  protected override updated(changed: PropertyValues<this>): void {
    const has = (...names: (keyof TexelcastEditorProperties)[]): boolean => names.some((name) => changed.has(name));
    const speaks = has("locale", "wording");
    const speaking = speaks ? this.#voice.speak() : Promise.resolve();
    // In the language that was just asked for.
    void speaking.then(() => {
      if (speaks) this.#work.configure();
      const { faults } = readSettings(this, this.#voice.words);
      const told = new Set([...faults].flatMap(([name, fault]) => (has(name) ? [fault] : [])));
      for (const fault of told) this.#voice.report(fault);
    });
    if (has("loading", "src")) this.#watchSight();
    if (changed.size > 0) this.#work.follow(has);
  }

  /** Does something with what is open, which is begun where it is not; the page is told where it fails. */
  #with<T>(act: (mode: Mode) => Promise<T>): Promise<T> {
    return this.#called(this.#work.ready().then(act));
  }

  #atDesk<T>(act: (mode: AtDesk) => Promise<T>): Promise<T> {
    return this.#called(this.#work.atDesk().then(act));
  }

  #called<T>(work: Promise<T>): Promise<T> {
    return this.#voice.told(this.#held(work));
  }

  #held<T>(work: Promise<T>): Promise<T> {
    this.#calls += 1;
    const ended = (): void => {
      this.#calls -= 1;
      // What a page asks of an element that it has taken out brings its worker back.
      if (this.#gone && this.#calls === 0) this.#work.close();
    };
    work.then(ended, ended);
    return work;
  }

  readonly #touched = (): void => {
    if (this.#work.phase === "idle" && this.src) void this.start();
  };

  #watchSight(): void {
    this.#sight.end();
    if (this.#work.phase !== "idle" || !this.src || !this.isConnected) return;
    if (this.loading === "eager") void this.start();
    else if (this.loading !== "lazy") this.#sight.watch();
  }
}
