/**
 * The editor page's layout: bar, views, panels; and what belongs to the page as a whole: drops and keys. The two views
 * are its children, in the slots "view" and "texture": they style the document that they stand in.
 */
import { css, html, nothing, type TemplateResult } from "lit";
import { carriesFiles, collectDrop } from "./files/file-collection.ts";
import "./panels/bottom-sheet.ts";
import { PALETTE_DRAG } from "./panels/decal-palette.ts";
import "./panels/layer-properties.ts";
import "./panels/first-hint.ts";
import "./panels/help-dialog.ts";
import "./panels/history-panel.ts";
import "./panels/layer-list.ts";
import "./panels/notice-stack.ts";
import "./panels/projects-dialog.ts";
import "./panels/side-panel.ts";
import "./panels/stage.ts";
import "./panels/status-line.ts";
import "./panels/target-settings.ts";
import "./panels/template-dialog.ts";
import "./panels/texture-panel.ts";
import "./panels/top-bar.ts";
import { handleClipboard } from "./state/clipboard-events.ts";
import type { EditorState } from "./state/editor-state.ts";
import { watchFingers } from "./state/finger-gestures.ts";
import { handleShortcut } from "./state/shortcuts.ts";
import { isSplit } from "./state/view-state.ts";
import { watchEraserEnd } from "./tools/eraser-end.ts";
import { ACCEPT } from "./ui/accepted-files.ts";
import { EditorElement } from "./ui/editor-element.ts";
import { pickFiles } from "./ui/file-picker.ts";
import { type HeldKeyboard, holdKeyboard } from "./ui/held-keyboard.ts";
import { endOpenField } from "./ui/open-field.ts";
import { tellPressAfterDrag } from "./ui/press-after-drag.ts";
import { focusPressed } from "./ui/press-focus.ts";
import { keepTabInSight } from "./ui/tab-in-sight.ts";
import "./ui/menu.ts";
import type { NumberField, Refusal } from "./ui/number-field.ts";
import "./ui/number-field.ts";
import "./ui/splitter.ts";
import type { SurfaceHit } from "../viewer/viewer-api.ts";
import { windowOf } from "../viewer/window-of.ts";
import { controls } from "./ui/controls.ts";
import { NARROW, SIDEWAYS } from "./ui/page-shapes.ts";
import { theme } from "./ui/theme.ts";

/** Pixels; of the box of one that is embedded the widths and heights of the page's shapes. */
const PHONE_WIDTH = 720;
const TABLET_WIDTH = 1000;
const SIDEWAYS_WIDTH = 560;
const SIDEWAYS_HEIGHT = 480;
/** A tablet held upright: beside each other the two views would be slits. */
const UPRIGHT = `(max-width: ${TABLET_WIDTH}px) and (orientation: portrait)`;
/** The model fills its view down to where a card in the corner would stand. */
const LOW = "(max-height: 46rem)";

export class Workbench extends EditorElement {
  static override properties = {
    compact: { state: true },
    sideways: { type: Boolean, reflect: true },
    upright: { state: true },
    low: { state: true },
    dropping: { state: true },
    textureShare: { state: true },
    embedded: { type: Boolean, reflect: true },
  };
  declare compact: boolean;
  /** Compact, and low: the sheet stands beside the view. */
  declare sideways: boolean;
  declare upright: boolean;
  declare low: boolean;
  declare dropping: boolean;
  /** Of the views' width; null until somebody chooses it. */
  declare textureShare: number | null;
  /** It is part of a page: fills its box, and leaves keys and drops elsewhere on the page alone. */
  declare embedded: boolean;
  readonly #narrow = matchMedia(NARROW);
  readonly #sideways = matchMedia(SIDEWAYS);
  readonly #tablet = matchMedia(UPRIGHT);
  readonly #lowWindow = matchMedia(LOW);
  #endFingers: () => void = () => {};
  #keyboard: HeldKeyboard | null = null;
  /** Ends what is listened to while it is in the page. */
  #connected = new AbortController();

  static override styles = [
    theme,
    controls,
    css`
      :host {
        position: relative;
        display: grid;
        grid-template: auto minmax(0, 1fr) auto auto / minmax(0, 1fr) 19.5rem;
        grid-template-areas:
          "bar bar"
          "views panel"
          "hint panel"
          "status panel";
        height: 100dvh;
        /* A phone's camera takes some of a side. */
        padding: 0 env(safe-area-inset-right) 0 env(safe-area-inset-left);
        /* Not even what takes the focus scrolls the page itself. */
        overflow: clip;
        background: var(--surface);
        color: var(--text);
        font: var(--text-normal) / 1.3 var(--font);
        -webkit-font-smoothing: antialiased;
      }
      /* A model has its own colours, whatever the page's: 3 : 1 and more beside a white mug as beside the dark stage. */
      @media (prefers-color-scheme: dark) {
        :host {
          --viewer-accent: #6b75ee;
        }
      }
      /* At 400 % a window may be lower than the tools, their settings and a panel: it is scrolled then. Not so above a phone's keyboard. */
      @media (pointer: fine) {
        :host {
          min-height: 256px;
        }
      }
      @media (pointer: coarse) {
        :host {
          grid-template-columns: minmax(0, 1fr) 23rem;
        }
      }
      :host([embedded]) {
        min-height: 0;
        position: absolute;
        inset: 0;
        height: auto;
        /* As the languages do that it speaks, whatever the page's is. */
        direction: ltr;
      }
      :host([compact]) {
        grid-template: auto minmax(0, 1fr) auto / minmax(0, 1fr);
        grid-template-areas: "bar" "views" "panel";
      }
      :host([sideways]) {
        grid-template: auto minmax(0, 1fr) / minmax(0, 1fr) auto;
        grid-template-areas: "bar bar" "views panel";
      }
      /* What is a stacking context keeps its painting while its neighbours change: in a drag the view changes in each frame. */
      tc-top-bar,
      .views,
      .views > *,
      tc-side-panel,
      tc-status-line {
        isolation: isolate;
      }
      tc-top-bar {
        grid-area: bar;
        z-index: 20;
      }
      .views {
        grid-area: views;
        display: grid;
        min-width: 0;
        min-height: 0;
      }
      tc-side-panel {
        grid-area: panel;
        border-inline-start: 1px solid var(--line);
      }
      tc-bottom-sheet {
        grid-area: panel;
      }
      /* What it is grabbed by reaches over the pane after it. */
      .views tc-splitter {
        z-index: 1;
      }
      tc-status-line {
        grid-area: status;
      }
      .views > :first-child,
      tc-notice-stack,
      tc-first-hint {
        grid-area: 1 / 1;
      }
      :host > tc-first-hint {
        grid-area: hint;
      }
      .views tc-first-hint {
        z-index: 9;
        align-self: end;
        justify-self: start;
        padding: var(--space-3);
      }
      /* It would lie over the card, and is read first. Not by :has(), which WebKit does not ask again when the attribute comes. */
      tc-notice-stack[filled] + tc-first-hint {
        visibility: hidden;
      }
      /* The bar of a model that moves has the foot of the views. */
      .moving tc-first-hint {
        padding-block-end: calc(var(--target) + 8px + 2 * var(--space-3));
      }
      tc-notice-stack {
        z-index: 10;
        align-self: end;
        justify-self: center;
        width: 100%;
        padding: var(--space-4);
      }
      /* Over the sheet, not over the model, unless somebody types in the sheet. */
      :host([compact]) tc-notice-stack:not([terse]) {
        position: absolute;
        inset-block-end: calc(3.25rem + env(safe-area-inset-bottom));
      }
      :host([compact]) tc-notice-stack {
        padding: var(--space-2);
      }
      :host([sideways]) tc-notice-stack:not([terse]) {
        inset-block: auto 0;
        inset-inline: auto 0;
        width: min(24rem, 56vw);
      }
      :host([compact]) .views {
        z-index: 10;
      }
      .drop {
        position: absolute;
        z-index: 30;
        inset: 0;
        display: grid;
        place-content: center;
        justify-items: center;
        gap: var(--space-1);
        border: 2px solid var(--accent);
        background: color-mix(in oklab, var(--surface), transparent 35%);
        pointer-events: none;
        text-align: center;
      }
      .drop h2 {
        font-size: 1.125rem;
      }
    `,
  ];

  constructor() {
    super();
    this.compact = false;
    this.sideways = false;
    this.upright = false;
    this.low = false;
    this.dropping = false;
    this.textureShare = null;
    this.embedded = false;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    const { signal } = this.#connected;
    for (const shape of [this.#narrow, this.#sideways, this.#tablet, this.#lowWindow])
      shape.addEventListener("change", this.#resize, { signal });
    this.#resize();
    const whole: EventTarget = this.embedded ? this : window;
    whole.addEventListener("keydown", (event) => this.#key(event as KeyboardEvent), { signal });
    const { viewer, textureView, tools } = this.editor;
    watchEraserEnd(whole, [viewer.element, textureView.element], tools, signal);
    // Before a view takes the press for itself.
    const press = (event: Event): void => {
      this.editor.decals.press(event as PointerEvent);
      this.#frameViews(false);
    };
    whole.addEventListener("pointerdown", press, { capture: true, signal });
    // After a view has: it keeps from here what was a drag.
    whole.addEventListener("pointerup", (event) => this.#release(event as PointerEvent), { signal });
    whole.addEventListener("keydown", (event) => this.#keyBeforeView(event as KeyboardEvent), {
      capture: true,
      signal,
    });
    this.addEventListener(
      "field-refused",
      (event) => {
        // A page around the editor has no field of that kind.
        event.stopPropagation();
        const { name, least, most } = (event as CustomEvent<Refusal>).detail;
        const { refused, mayBe } = this.strings.announce;
        const [field] = event.composedPath() as NumberField[];
        const told = mayBe(near(least), near(most));
        field?.explain(told);
        this.editor.board.announce(refused(name, told));
      },
      { signal },
    );
    focusPressed(this, signal);
    keepTabInSight(this, signal);
    tellPressAfterDrag(whole, signal);
    this.#keyboard = holdKeyboard(whole, () => this.editor.work, signal);
    signal.addEventListener("abort", this.editor.store.subscribe(this.#keyboard.look));
    for (const type of ["copy", "cut", "paste"]) whole.addEventListener(type, this.#clipboard, { signal });
    whole.addEventListener("dragover", (event) => this.#dragOver(event as DragEvent), { signal });
    whole.addEventListener("dragleave", (event) => this.#dragLeave(event as DragEvent), { signal });
    whole.addEventListener("drop", (event) => this.#drop(event as DragEvent), { signal });
    if (!this.embedded) addEventListener("beforeunload", this.#leave, { signal });
    else {
      const box = new (windowOf(this).ResizeObserver)(this.#resize);
      box.observe(this);
      signal.addEventListener("abort", () => box.disconnect());
    }
    this.#endFingers = watchFingers(this, (gesture) => void this.editor.files.travel(gesture));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#connected.abort();
    this.#connected = new AbortController();
    this.#endFingers();
  }

  protected watched({ view, model, animation, history, design }: EditorState): readonly unknown[] {
    const isBare = design.layers.length === 0;
    return [view.layout, model === null, animation.clip === null, this.#hintsDone(history), isBare];
  }

  /** Of the first steps: a picture or words were added; and moved. */
  #hintsDone({ labels }: EditorState["history"]): number {
    const { steps } = this.strings;
    const added = labels.findIndex((label) => label === steps.add || label === steps.addText);
    if (added < 0) return 0;
    return labels.includes(steps.slide, added) ? 2 : 1;
  }

  override render(): TemplateResult {
    const { editor, compact } = this;
    this.toggleAttribute("compact", compact);
    // What inherits it writes its numbers so, and screen readers speak so.
    this.lang = this.state.language;
    return html`
      <tc-top-bar
        role=${this.embedded ? "group" : "banner"}
        aria-label=${this.strings.topBar.label}
        .editor=${editor}
        .compact=${compact}
        .embedded=${this.embedded}
        @help=${() => this.#help()}
        @templates=${this.#templates}
        @projects=${(event: CustomEvent<unknown>) => this.renderRoot.querySelector("tc-projects-dialog")?.show(event.detail === "rename")}
      ></tc-top-bar>
      ${this.#views()}
      ${
        compact
          ? html`<tc-bottom-sheet role="complementary" aria-label=${this.strings.sidePanel} .editor=${editor} ?sideways=${this.sideways}>
              <div slot="hint">${this.#hint()}</div>
              ${this.state.view.layout === "texture" ? nothing : html`<slot name="texture" slot="texture"></slot>`}
            </tc-bottom-sheet>`
          : html`
              ${this.#hintBesideViews ? this.#hint() : nothing}
              <tc-status-line .editor=${editor} role="region" aria-label=${this.strings.status.label}></tc-status-line>
              <tc-side-panel .editor=${editor} role="complementary" aria-label=${this.strings.sidePanel}></tc-side-panel>
            `
      }
      <tc-help-dialog .words=${this.strings.help} ?embedded=${this.embedded}></tc-help-dialog>
      ${
        this.embedded
          ? nothing
          : html`<tc-template-dialog .editor=${editor}></tc-template-dialog>
              <tc-projects-dialog .editor=${editor} @create=${this.#templates}></tc-projects-dialog>`
      }
      ${
        this.dropping
          ? html`<div class="drop">
              <h2>${this.strings.stage.dropModel}</h2>
              <p>${this.strings.stage.dropHint}</p>
            </div>`
          : nothing
      }
    `;
  }

  /** The main part of the page; of one that it is embedded in, whose landmarks are its own, a group. */
  #views(): TemplateResult {
    const { editor, compact, upright } = this;
    const textureShare = this.textureShare ?? 0.38;
    const { animation, view } = this.state;
    const { layout } = view;
    const split = isSplit(layout, compact);
    const flat = layout === "texture";
    const [first, second] = [`minmax(0, ${1 - textureShare}fr)`, `minmax(0, ${textureShare}fr)`];
    const whole = "minmax(0, 1fr)";
    const grid =
      split && upright ? `${first} ${second} / ${whole}` : `${whole} / ${split ? `${first} auto ${second}` : whole}`;
    const resize = (event: CustomEvent<number>): void => {
      this.textureShare = event.detail;
    };
    return html`
      <div role=${this.embedded ? "group" : "main"} class=${animation.clip === null ? "views" : "views moving"} .style=${`grid-template: ${grid}`}>
        ${
          flat
            ? html`<tc-texture-panel .editor=${editor}><slot name="texture" slot="texture"></slot></tc-texture-panel>`
            : html`<tc-stage .editor=${editor} @templates=${this.#templates}><slot name="view" slot="view"></slot></tc-stage>`
        }
        <tc-notice-stack .editor=${editor} ?compact=${compact}></tc-notice-stack>
        ${compact || this.#hintBesideViews ? nothing : this.#hint()}
        ${
          split
            ? html`
                <tc-splitter ?hidden=${upright} .name=${this.strings.splitter} .share=${textureShare} @split=${resize}></tc-splitter>
                <tc-texture-panel .editor=${editor}><slot name="texture" slot="texture"></slot></tc-texture-panel>
              `
            : nothing
        }
      </div>
    `;
  }

  /** Where a card in a view's corner would stand on the model. */
  get #hintBesideViews(): boolean {
    return this.low || this.upright;
  }

  #hint(): TemplateResult | typeof nothing {
    return this.state.model && !this.embedded
      ? html`<tc-first-hint .words=${this.strings.hint} .done=${this.#hintsDone(this.state.history)} .bare=${this.state.design.layers.length === 0} ?compact=${this.compact || this.#hintBesideViews}></tc-first-hint>`
      : nothing;
  }

  #help(): void {
    this.renderRoot.querySelector("tc-help-dialog")?.show();
  }

  readonly #templates = (): void => this.renderRoot.querySelector("tc-template-dialog")?.show();

  readonly #resize = (): void => {
    // Panels give way to a sheet, and it to them: the keyboard may be in them, or elsewhere on a page around the editor.
    if (this.shadowRoot?.activeElement) this.#keyboard?.hold(this.ownerDocument);
    const [width, height] = [this.clientWidth, this.clientHeight];
    const narrow = this.embedded ? width <= PHONE_WIDTH : this.#narrow.matches;
    this.sideways = this.embedded
      ? narrow && width >= SIDEWAYS_WIDTH && height <= SIDEWAYS_HEIGHT
      : this.#sideways.matches;
    this.compact = narrow || this.sideways;
    if (this.embedded) {
      // What the sheet takes its share of, in the place of the page's.
      this.style.setProperty("--box-width", `${width}px`);
      this.style.setProperty("--box-height", `${height}px`);
    }
    this.editor.store.set({ sheet: this.sideways ? "beside" : narrow ? "below" : null });
    this.low = this.#lowWindow.matches;
    this.upright = this.embedded ? width <= TABLET_WIDTH && height > width : this.#tablet.matches;
  };

  readonly #key = (event: KeyboardEvent): void => {
    const openModel = (): void =>
      pickFiles({ accept: ACCEPT.model }, (files) => void this.editor.files.openFiles(files));
    const help = (): void => this.#help();
    if (handleShortcut(event, this.editor, { openModel: this.embedded ? null : openModel, help }))
      event.preventDefault();
  };

  /** The right button's menu is for all that is chosen. */
  #release(event: PointerEvent): void {
    if (event.button === 0) this.editor.decals.release();
  }

  /** Browsers frame what has the keyboard after any key: whoever works by pointer, and tools by keys, is not to have it around the model. */
  #frameViews(framed: boolean): void {
    const { viewer, textureView } = this.editor;
    for (const { element } of [viewer, textureView]) element.toggleAttribute("data-pointed", !framed);
  }

  /** A view takes for its camera what moves and fades the chosen layers, where it shows no decal's handles, as of a group. */
  #keyBeforeView(event: KeyboardEvent): void {
    const { decals, store, viewer } = this.editor;
    if (/^(Tab|Arrow)/.test(event.key)) this.#frameViews(true);
    const meant = store.state.tool === "move" && /^(Arrow|[-+=0]$)/.test(event.key);
    if (!meant || !event.composedPath().includes(viewer.element)) return;
    if (event.key === "0" || decals.moveUnheld) this.#key(event);
  }

  readonly #clipboard = (event: Event): void => {
    if (handleClipboard(event as ClipboardEvent, this.editor)) event.preventDefault();
  };

  readonly #dragOver = (event: DragEvent): void => {
    const own = event.dataTransfer?.types.includes(PALETTE_DRAG) ?? false;
    if (!own && !carriesFiles(event.dataTransfer)) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = "copy";
    this.dropping = !own;
  };

  readonly #dragLeave = (event: DragEvent): void => {
    // Without a related target the pointer has left the window, not just an element in it.
    if (event.relatedTarget === null) this.dropping = false;
  };

  /** In either view; null beside the model and its charts. */
  #surfaceUnder({ clientX, clientY }: DragEvent): SurfaceHit | null {
    const { viewer, textureView, store } = this.editor;
    const { material } = store.state;
    const uv = textureView.uvAtPointer(clientX, clientY);
    if (uv === null) return viewer.surfaceAtPointer(clientX, clientY);
    return material === null ? null : viewer.surface.atUv(material, uv);
  }

  readonly #drop = (event: DragEvent): void => {
    this.dropping = false;
    const { dataTransfer } = event;
    if (!dataTransfer) return;
    const { files, store } = this.editor;
    const hit = this.#surfaceUnder(event);
    const demo = store.state.demos?.decals.find(({ id }) => id === dataTransfer.getData(PALETTE_DRAG));
    if (demo) void files.addDemoDecal(demo, hit);
    else if (carriesFiles(dataTransfer)) {
      // What comes of it would lie behind them; the projects have their own notices.
      this.renderRoot.querySelector("tc-help-dialog")?.close();
      this.renderRoot.querySelector("tc-template-dialog")?.close();
      void files.openFiles(collectDrop(dataTransfer), hit);
    } else return;
    event.preventDefault();
  };

  readonly #leave = (event: BeforeUnloadEvent): void => {
    const { autosave, session, store, texts } = this.editor;
    const { recording } = session;
    endOpenField();
    // In the browser or in a file: either is enough. What is still being written is in neither, but for words, which are noted.
    const isSafe = (autosave.leave() || !store.state.unsaved) && (!recording || texts.unmeasured);
    if (isSafe && !autosave.leaves) return;
    void autosave.flush();
    event.preventDefault();
  };
}
customElements.define("tc-workbench", Workbench);

/** A field's bound; "" for one that nobody comes to, as what the engine's arithmetic survives: a million kilometres say nothing. */
function near(bound: string): string {
  return /\d{9}/.test(bound) ? "" : bound;
}

declare global {
  interface HTMLElementTagNameMap {
    "tc-workbench": Workbench;
    "tc-help-dialog": import("./panels/help-dialog.ts").HelpDialog;
  }
}
