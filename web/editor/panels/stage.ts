/** The 3D view with its few controls, and what to do while it is empty. */
import { css, html, nothing, type TemplateResult } from "lit";
import { Maximize, Play } from "lucide";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import { ACCEPT } from "../ui/accepted-files.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { pickFiles } from "../ui/file-picker.ts";
import { icon } from "../ui/icon.ts";
import "./animation-bar.ts";
import type { ModelMenu } from "./model-menu.ts";
import "./model-menu.ts";
import "./tool-options.ts";
import "./tool-rail.ts";
import "./view-menu.ts";

export class Stage extends EditorElement {
  static override styles = [
    controls,
    css`
      :host {
        position: relative;
        display: block;
        container-type: size;
        min-width: 0;
        min-height: 0;
        overflow: hidden;
        background: radial-gradient(ellipse at 50% 38%, color-mix(in oklab, var(--stage), white 55%), var(--stage) 78%);
        --inwards: right;
        --rail: calc(max(32px, var(--target)) + 8px + 2 * var(--space-2));
        --side: calc(var(--target) + 2 * var(--space-2));
        --head: calc(var(--target) + var(--space-2));
      }
      @media (prefers-color-scheme: dark) {
        :host {
          background: radial-gradient(ellipse at 50% 38%, color-mix(in oklab, var(--stage), white 9%), var(--stage) 78%);
        }
      }
      :host(:dir(rtl)) {
        --inwards: left;
      }
      /*
       * Tools and buttons stand beside it: a handle that lay under them could not be taken. On a phone, where it needs all
       * of the width, the buttons stand above it.
       */
      .view {
        position: absolute;
        inset: 0;
        inset-inline: var(--rail) var(--side);
        inset-block-end: calc(var(--foot, 0px) + var(--bar, 0px));
        isolation: isolate;
        /* A model that reaches beyond it goes on under them, to the stage's edge; lines and handles fade out there. */
        --viewer-start: var(--rail);
        --viewer-end: var(--side);
        --viewer-above: 0px;
        --viewer-below: calc(var(--foot, 0px) + var(--bar, 0px));
        --viewer-fade: linear-gradient(to right, transparent, #000 12px calc(100% - 12px), transparent);
      }
      /* A model that walks stands above its bar, where there is the height for both: on any phone that is held upright. */
      @container (min-height: 18em) {
        .moving {
          --bar: calc(var(--target) + 8px + 2 * var(--space-2));
        }
      }
      .tools {
        position: absolute;
        inset-block-start: var(--space-2);
        inset-inline-end: var(--space-2);
        display: flex;
        flex-direction: column;
        gap: var(--space-1);
      }
      .tools button {
        background: color-mix(in oklab, var(--surface), transparent 15%);
      }
      @media (forced-colors: active) {
        .tools button {
          border: 1px solid ButtonBorder;
        }
      }
      @media (hover: hover) {
        .tools button:hover {
          background: var(--surface);
        }
      }
      tc-tool-rail {
        position: absolute;
        inset-block: 4rem;
        inset-inline-start: var(--space-2);
      }
      /* Below it nothing stands, so where the height is dear the tools have it. */
      @container (max-height: 39em) {
        tc-tool-rail {
          inset-block-end: var(--space-2);
        }
      }
      tc-animation-bar {
        position: absolute;
        inset-block-end: var(--space-3);
        inset-inline: var(--rail) var(--space-2);
      }
      :host([data-tone="light"]) {
        background: #f4f5f6;
      }
      :host([data-tone="grey"]) {
        background: #8b8e93;
      }
      :host([data-tone="dark"]) {
        background: #17181b;
      }
      tc-tool-options {
        position: absolute;
        z-index: 1;
        inset-block-start: var(--space-2);
        inset-inline: var(--space-2) var(--side);
      }
      /* What is low has the width for it. */
      :host([data-sheet="beside"]) .tools.beside {
        flex-direction: row;
      }
      :host([data-sheet="beside"]) .view {
        inset-block-start: var(--head);
        inset-inline-end: 0;
        --viewer-end: 0px;
        --viewer-above: var(--head);
        --viewer-fade: linear-gradient(transparent, #000 12px), linear-gradient(to var(--inwards), transparent, #000 12px);
      }
      :host([data-sheet="beside"]) tc-tool-options {
        inset-inline-start: var(--rail);
      }
      :host([data-sheet="beside"]) tc-tool-rail {
        inset-block-start: var(--space-2);
      }
      :host([data-sheet="below"]) .view {
        --foot: var(--rail);
        inset-block-start: var(--head);
        inset-inline: 0;
        --viewer-start: 0px;
        --viewer-end: 0px;
        --viewer-above: var(--head);
        --viewer-fade: linear-gradient(transparent, #000 12px calc(100% - 12px), transparent);
      }
      /* One beside the other, while no tool's settings need that place: with a tool, decals have no handles. */
      :host([data-sheet="below"]) .tools.beside {
        flex-direction: row;
      }
      /* Where the height is not dear, they stand one below the other. */
      @container (max-aspect-ratio: 3 / 4) {
        :host([data-sheet="below"]) .tools.beside {
          flex-direction: column;
        }
        :host([data-sheet="below"]) .view {
          --viewer-above: calc(var(--space-2) + var(--buttons, 2) * (var(--target) + var(--space-1)));
          inset-block-start: var(--viewer-above);
        }
        :host([data-sheet="below"]) .still {
          --buttons: 3;
        }
      }
      :host([data-sheet="below"]) tc-tool-rail {
        inset-block: auto var(--space-2);
        inset-inline: var(--space-2);
      }
      /* So low that the buttons, and a tool's settings, come down to the tools: those end before them. */
      @container (max-height: 10em) {
        :host([data-sheet="below"]) tc-tool-rail {
          inset-inline-end: calc(2 * var(--target) + var(--space-1) + 2 * var(--space-2));
        }
      }
      :host([data-sheet="below"]) tc-animation-bar {
        inset-block-end: calc(var(--target) + 3 * var(--space-2));
        inset-inline: var(--space-2);
      }
      .empty {
        position: absolute;
        inset: 0;
        display: grid;
        place-content: center;
        justify-items: center;
        gap: var(--space-3);
        padding: var(--space-4);
        text-align: center;
      }
      .empty p {
        max-width: 22rem;
        color: var(--text-quiet);
      }
      .hidden {
        inset: 40% 0 auto;
        width: fit-content;
        margin-inline: auto;
        border-radius: var(--radius-large);
        background: var(--surface);
        box-shadow: var(--shadow);
      }
      .ways {
        display: flex;
        flex-wrap: wrap;
        justify-content: center;
        gap: var(--space-2);
      }
      h2 {
        font-size: 1.125rem;
      }
    `,
  ];

  get #words(): Strings["stage"] {
    return this.strings.stage;
  }

  protected watched(state: EditorState): readonly unknown[] {
    const { model, tool, animation, tasks, view, shown, starting, demos, sheet } = state;
    return [
      model,
      tool,
      animation.clips,
      animation.clip === null,
      tasks.length === 0,
      view.background,
      shown,
      starting,
      demos,
      sheet,
    ];
  }

  override render(): TemplateResult {
    const { model, tasks, view, starting, animation, sheet } = this.state;
    const empty = tasks.length === 0 && !starting;
    this.dataset.tone = view.background;
    this.dataset.sheet = sheet ?? "";
    return html`
      <div
        class="view ${animation.clip !== null ? "moving" : animation.clips.length > 0 ? "still" : ""}"
        @pointerdown=${(event: PointerEvent) => this.#menu?.press(event)}
        @pointerup=${(event: PointerEvent) => this.#menu?.release(event)}
        @contextmenu=${(event: MouseEvent) => this.#menu?.ask(event)}
        @dblclick=${() => this.#type()}
      >
        <slot name="view"></slot>
      </div>
      <tc-model-menu .editor=${this.editor}></tc-model-menu>
      ${model ? this.#tools() : empty ? this.#empty() : nothing}
    `;
  }

  get #menu(): ModelMenu | null {
    return this.renderRoot.querySelector("tc-model-menu");
  }

  /** The words that were pressed twice: the first press has chosen them. */
  #type(): void {
    const { store, texts } = this.editor;
    if (texts.selected && store.state.tool === "move" && !store.state.readonly)
      store.set({ textToType: texts.selected.id });
  }

  #tools(): TemplateResult {
    const { animation } = this.state;
    const { viewer } = this.editor;
    const offersPlay = animation.clips.length > 0 && animation.clip === null;
    return html`
      ${
        this.state.readonly
          ? nothing
          : html`<tc-tool-options .editor=${this.editor}></tc-tool-options>
              <tc-tool-rail .editor=${this.editor}></tc-tool-rail>`
      }
      <div class="tools ${this.state.tool === "move" ? "beside" : ""}">
        <button class="icon" aria-label=${this.#words.frame} title=${this.#words.frame} @click=${() => viewer.frameModel()}>${icon(Maximize)}</button>
        <tc-view-menu .editor=${this.editor}></tc-view-menu>
        ${
          offersPlay
            ? html`<button class="icon" id="play" aria-label=${this.#words.play} title=${this.#words.play} @click=${this.#play}>
                ${icon(Play)}
              </button>`
            : nothing
        }
      </div>
      ${this.#nothingShown()}
      <tc-animation-bar .editor=${this.editor} @rest=${this.#rest}></tc-animation-bar>
    `;
  }

  /** What has been pressed and gives way, once the view has taken that up: the button to the bar, or the bar to the button. */
  #givesWay: "button" | "bar" | null = null;

  #play(): void {
    this.#givesWay = "button";
    this.editor.views.animate({ playing: true });
  }

  #rest(): void {
    this.#givesWay = "bar";
    this.editor.views.animate({ clip: null });
  }

  /** The keyboard goes from one to the other. */
  override updated(): void {
    const moves = this.state.animation.clip !== null;
    this.#nameView();
    if (this.#givesWay === null || moves !== (this.#givesWay === "button")) return;
    this.#givesWay = null;
    if (!moves) this.renderRoot.querySelector<HTMLElement>("#play")?.focus();
    else {
      const bar = this.renderRoot.querySelector("tc-animation-bar");
      void bar?.updateComplete.then(() => bar.focus());
    }
  }

  /** What its keys do is another thing with another tool in hand. */
  #nameView(): void {
    const { tools, viewer } = this.editor;
    const { active } = tools;
    const { view, viewWithTool } = this.#words;
    viewer.element.ariaLabel = !active || active.id === "move" ? view : viewWithTool(active.label(this.strings));
  }

  #showAll(): void {
    const { views, viewer } = this.editor;
    views.showAllParts();
    viewer.element.focus({ preventScroll: true });
  }

  #nothingShown(): TemplateResult | typeof nothing {
    const { parts, hidden } = this.state.shown;
    if (parts.length === 0 || hidden.size < parts.length) return nothing;
    return html`
      <div class="empty hidden">
        <p>${this.#words.allHidden}</p>
        <button class="outlined" @click=${this.#showAll}>${this.strings.modelParts.showAll}</button>
      </div>
    `;
  }

  #empty(): TemplateResult {
    const open = (): void => pickFiles({ accept: ACCEPT.model }, (files) => void this.editor.files.openFiles(files));
    const { demos } = this.state;
    const templates = (): boolean => this.dispatchEvent(new CustomEvent("templates"));
    return html`
      <div class="empty">
        <h2>${this.#words.emptyTitle}</h2>
        <p>${this.#words.emptyBody}</p>
        <div class="ways">
          <button class="filled" @click=${open}>${this.strings.topBar.openModel}</button>
          <button class="outlined" ?hidden=${!demos?.templates.length} @click=${templates}>${this.strings.topBar.newFromTemplate}</button>
        </div>
      </div>
    `;
  }
}
customElements.define("tc-stage", Stage);
