/**
 * The right panel: the list of layers or the history above; adding, properties and texture settings below. On a phone it is
 * one of these at a time.
 */
import { css, html, nothing, type TemplateResult } from "lit";
import { windowOf } from "../../viewer/window-of.ts";
import type { ModelRef } from "../state/design-state.ts";
import type { EditorState } from "../state/editor-state.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import "./parts-list.ts";
import { openToolPanel, toolPanel } from "./tool-panel.ts";

export type Section = "layers" | "properties" | "history" | "target";
type UpperTab = "layers" | "history";

const UPPER_TABS: readonly UpperTab[] = ["layers", "history"];

/** A longer list stays folded until it is asked for. */
const FEW_PARTS = 24;

export class SidePanel extends EditorElement {
  /** Of the tool, as it was shown last. */
  #laidOpen: EditorState["toolPanel"] = null;
  #model: ModelRef | undefined;

  static override properties = { only: { attribute: false }, tab: { state: true } };
  /** Shows one section; null shows all. */
  declare only: Section | null;
  declare tab: UpperTab;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        grid-template-rows: auto minmax(0, 1fr);
        min-width: 0;
        min-height: 0;
        background: var(--surface);
      }
      #upper {
        display: grid;
        min-height: 0;
      }
      .upper {
        display: grid;
        grid-template-rows: auto minmax(0, 1fr);
        min-height: 0;
        max-height: 46dvh;
        border-bottom: 1px solid var(--line);
        isolation: isolate;
      }
      .upper.history {
        height: 46dvh;
      }
      .lower {
        position: relative;
        min-height: 0;
        overflow: hidden auto;
        /* With its ring, what Tab comes to is in sight. */
        scroll-padding-block: var(--space-1);
        overscroll-behavior: contain;
        scrollbar-width: thin;
        scrollbar-color: var(--line-strong) transparent;
      }
      /* Firefox stops by Tab at what scrolls: at the window's edge a ring round it is cut. */
      .lower:focus-visible {
        outline-offset: -2px;
      }
      :host([single]) {
        grid-template-rows: minmax(0, 1fr);
      }
      :host([single]) .upper {
        grid-template-rows: minmax(0, 1fr) auto;
        height: 100%;
        max-height: none;
        border: 0;
      }
      /* Lower than its parts, it scrolls as a whole: the list would have no height left. */
      @media (max-height: 28rem) {
        :host([single]) .upper {
          grid-template-rows: minmax(8rem, 1fr) auto;
          overflow: hidden auto;
          overscroll-behavior: contain;
        }
      }
      :host([noted]) .upper {
        grid-template-rows: auto auto minmax(0, 1fr);
      }
      :host([noted][single]) .upper {
        grid-template-rows: auto minmax(0, 1fr);
      }
      [role="tablist"] {
        display: flex;
        gap: 2px;
        padding: var(--space-2) var(--space-2) 2px;
      }
      [role="tab"] {
        padding-inline: var(--space-2);
        color: var(--text-quiet);
        font-weight: 550;
      }
      [role="tab"][aria-selected="true"] {
        color: var(--text);
        font-weight: 600;
      }
      [role="tab"][aria-selected="true"]::after {
        content: "";
        position: absolute;
        inset-inline: var(--space-2);
        inset-block-end: 1px;
        height: 2px;
        border-radius: 1px;
        background: var(--accent);
      }
      [role="tab"] {
        position: relative;
      }
      .section > * {
        isolation: isolate;
      }
      .section {
        display: grid;
        gap: var(--space-3);
        padding: var(--space-4);
      }
      .tool {
        border-block-end: 1px solid var(--line);
      }
      .tool header {
        display: flex;
        align-items: center;
        justify-content: space-between;
        padding: var(--space-2) var(--space-1) 0 var(--space-4);
      }
      .readonly {
        display: grid;
        gap: var(--space-1);
        padding: var(--space-3) var(--space-4);
        border-block-end: 1px solid var(--line);
        line-height: 1.4;
      }
      .section.adding {
        padding-block: var(--space-3);
      }
      summary {
        display: flex;
        align-items: center;
        min-height: max(24px, var(--target));
        cursor: pointer;
        list-style: none;
      }
      summary::before {
        content: "";
        width: 6px;
        height: 6px;
        margin-inline: 2px var(--space-2);
        border: solid var(--text-quiet);
        border-width: 0 1.5px 1.5px 0;
        rotate: -45deg;
        transition: rotate 120ms;
      }
      details[open] > summary::before {
        rotate: 45deg;
      }
      details > :not(summary) {
        margin-block-start: var(--space-2);
      }
      .section + .section {
        border-top: 1px solid var(--line);
      }
      :host([single]) .upper .adding {
        padding: var(--space-1) var(--space-2);
        border-block-start: 1px solid var(--line);
      }
      /* A phone on its side: halves would be slits, so the whole panel scrolls, the list as high as it may be. */
      @media (max-height: 560px) {
        :host(:not([single])) {
          display: block;
          overflow: hidden auto;
          overscroll-behavior: contain;
          scrollbar-width: thin;
          scrollbar-color: var(--line-strong) transparent;
        }
        :host(:not([single])) .upper {
          max-height: calc(100dvh - 7rem);
        }
        :host(:not([single])) .upper.history {
          height: calc(100dvh - 7rem);
        }
        :host(:not([single])) .lower {
          overflow: visible;
        }
      }
    `,
  ];

  constructor() {
    super();
    this.only = null;
    this.tab = "layers";
  }

  protected watched({ model, shown, tool, toolPanel, optionsGivenWay }: EditorState): readonly unknown[] {
    return [model?.ref, shown.parts, tool, toolPanel, optionsGivenWay];
  }

  override render(): TemplateResult {
    this.toggleAttribute("single", this.only !== null);
    this.toggleAttribute("noted", this.state.readonly);
    if (this.only !== null) return this.#single(this.only);
    return html`
      <div class=${`upper ${this.tab}`}>
        ${this.#note()}
        ${this.#tabs()}
        <div id="upper" role="tabpanel" aria-labelledby=${`tab-${this.tab}`}>
          ${this.#upper(this.tab)}
        </div>
      </div>
      <div class="lower">${this.#tool()}${this.#adding()}${this.#properties(true)}${this.#target(true)}</div>
    `;
  }

  /** That nothing here can be changed is said once, before all that cannot. */
  #note(): TemplateResult | typeof nothing {
    const { title, message } = this.strings.readonly;
    return this.state.readonly
      ? html`<div class="readonly" role="note"><h2>${title}</h2><p class="quiet">${message}</p></div>`
      : nothing;
  }

  #single(section: Section): TemplateResult {
    switch (section) {
      case "layers":
        return html`<div class="upper">${this.#note()}${this.#upper("layers")}${this.#adding()}</div>`;
      case "history":
        return html`<div class="upper">${this.#upper("history")}</div>`;
      case "properties":
        return html`<div class="lower">${this.#properties(false)}</div>`;
      case "target":
        return html`<div class="lower">${this.#target(false)}</div>`;
    }
  }

  #tabs(): TemplateResult {
    return html`<div role="tablist" aria-label=${this.strings.layers.tabs} @keydown=${this.#key}>
      ${UPPER_TABS.map(
        (tab) => html`<button
          role="tab"
          id=${`tab-${tab}`}
          aria-selected=${tab === this.tab}
          aria-controls="upper"
          tabindex=${tab === this.tab ? 0 : -1}
          @click=${() => {
            this.tab = tab;
          }}
        >
          ${this.strings[tab].title}
        </button>`,
      )}
    </div>`;
  }

  async #key(event: KeyboardEvent): Promise<void> {
    if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
    event.preventDefault();
    event.stopPropagation();
    this.tab = this.tab === "layers" ? "history" : "layers";
    await this.updateComplete;
    this.renderRoot.querySelector<HTMLElement>("[aria-selected=true]")?.focus();
  }

  #upper(tab: UpperTab): TemplateResult {
    const { editor } = this;
    if (tab === "history") return html`<tc-history-panel .editor=${editor}></tc-history-panel>`;
    return html`<tc-layer-list .editor=${editor}></tc-layer-list>`;
  }

  /** What is laid open is seen, wherever the panel was scrolled to; and of another model what stands first. */
  override updated(): void {
    const { toolPanel, model } = this.state;
    const opened = toolPanel !== null && toolPanel !== this.#laidOpen;
    const lower = this.renderRoot.querySelector(".lower");
    if (lower && (opened || model?.ref !== this.#model)) {
      lower.scrollTo(0, 0);
      // Where the panel is low it is the panel that scrolls, and the list stands first.
      this.scrollTop += opened ? lower.getBoundingClientRect().top - this.getBoundingClientRect().top : -this.scrollTop;
    }
    this.#laidOpen = toolPanel;
    this.#model = model?.ref;
  }

  /** Where a finger is the pointer it would cover the model if it hung at its bar. */
  #tool(): TemplateResult | typeof nothing {
    const laidOpen = windowOf(this).matchMedia("(pointer: coarse)").matches ? openToolPanel(this.editor) : null;
    return laidOpen ? toolPanel(this.editor, laidOpen) : nothing;
  }

  #adding(): TemplateResult | typeof nothing {
    if (this.state.readonly) return nothing;
    return html`<div class="section adding"><tc-decal-palette ?row=${this.only !== null} .editor=${this.editor}></tc-decal-palette></div>`;
  }

  #properties(headed: boolean): TemplateResult {
    return html`<div class="section">
      ${headed ? html`<h2>${this.strings.properties.title}</h2>` : nothing}
      <tc-layer-properties .editor=${this.editor}></tc-layer-properties>
    </div>`;
  }

  #target(headed: boolean): TemplateResult | typeof nothing {
    if (!this.state.model) return nothing;
    return html`<div class="section">
      ${headed ? html`<h2>${this.strings.target.title}</h2>` : nothing}
        <tc-target-settings .editor=${this.editor}></tc-target-settings>
      </div>
      <details class="section" id="parts" ?open=${!headed || this.state.shown.parts.length < FEW_PARTS}>
        <summary><h2>${this.strings.modelParts.title}</h2></summary>
        <tc-parts-list .editor=${this.editor}></tc-parts-list>
      </details>`;
  }
}
customElements.define("tc-side-panel", SidePanel);
