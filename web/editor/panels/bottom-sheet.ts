/**
 * The panels on a phone: tabs at the bottom edge, and one panel above them. The sheet takes room from the view
 * instead of covering it, and never more than half of the screen: the model stays in sight.
 */
import { css, html, type TemplateResult } from "lit";
import { Grid2x2, History, Layers, Settings2, SlidersHorizontal } from "lucide";
import type { EditorState } from "../state/editor-state.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import { openToolPanel, toolPanel } from "./tool-panel.ts";

export type SheetTab = "layers" | "properties" | "history" | "texture" | "target";

const TABS = [
  { id: "layers", drawing: Layers },
  { id: "properties", drawing: SlidersHorizontal },
  { id: "history", drawing: History },
  { id: "texture", drawing: Grid2x2 },
  { id: "target", drawing: Settings2 },
] as const satisfies readonly { id: SheetTab; drawing: unknown }[];

export class BottomSheet extends EditorElement {
  static override properties = { tab: { state: true }, open: { type: Boolean, reflect: true } };
  declare tab: SheetTab;
  declare open: boolean;
  /** The text that the sheet was opened for last. */
  #typed: string | null = null;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        grid-template: minmax(0, 1fr) auto / minmax(0, 1fr);
        min-height: 0;
        background: var(--surface);
        border-top: 1px solid var(--line);
        padding-bottom: env(safe-area-inset-bottom);
      }
      .panel {
        display: grid;
        grid-template-rows: auto minmax(0, 1fr);
        /* In a low window, as of a page at 400 %, the view keeps the height of a tool's settings above the tools. */
        height: min(
          0.42 * var(--box-height, 100dvh),
          24rem,
          max(4.5rem, var(--box-height, 100dvh) - 7.75rem - 2.2 * var(--target))
        );
        min-height: 0;
        overflow: hidden;
        border-bottom: 1px solid var(--line);
      }
      /* Beside the view, with its buttons at the page's edge. */
      :host([sideways]) {
        grid-template: minmax(0, 1fr) / auto auto;
        border-width: 0;
        border-inline-start: 1px solid var(--line);
      }
      :host([sideways]) .panel {
        width: min(20rem, 0.44 * var(--box-width, 100vw));
        height: auto;
        border-width: 0;
        border-inline-end: 1px solid var(--line);
      }
      :host([sideways]) nav {
        grid-column: 2;
        grid-auto-flow: row;
        align-content: start;
        padding: var(--space-1) 2px;
        overflow-y: auto;
        scrollbar-width: none;
      }
      /* As wide as the widest of their words when it is bold. */
      :host([sideways]) nav button {
        width: 4.75rem;
        padding-inline: 2px;
      }
      /* The hint, where there is one, has the row before it. */
      .panel > :last-child {
        grid-row: 2;
        min-height: 0;
      }
      /* Of a texture without height nothing is seen: a panel as low is scrolled. */
      tc-texture-panel {
        grid-template-rows: auto minmax(7rem, 1fr) auto;
        overflow: hidden auto;
        overscroll-behavior: contain;
      }
      .tool {
        display: grid;
        grid-template-rows: auto minmax(0, 1fr);
      }
      .tool header {
        display: flex;
        align-items: center;
        justify-content: space-between;
        padding-inline: var(--space-4) var(--space-1);
      }
      tc-view-settings {
        padding: 0 var(--space-4) var(--space-4);
        overflow: hidden auto;
        overscroll-behavior: contain;
      }
      @media (max-width: 22rem) {
        tc-view-settings {
          padding-inline: var(--space-3);
        }
      }
      nav {
        display: grid;
        grid-auto-flow: column;
        grid-auto-columns: 1fr;
        padding: 2px var(--space-1);
      }
      nav button {
        flex-direction: column;
        gap: 2px;
        min-height: 48px;
        color: var(--text-quiet);
        font-size: var(--text-small);
      }
      nav button[aria-expanded="true"] {
        color: var(--accent);
        font-weight: 550;
      }
      /* Fifths would be too narrow for a long word. */
      @media (max-width: 22rem) {
        nav {
          display: flex;
        }
        nav button {
          flex: auto;
          padding-inline: 3px;
        }
      }
      /* Letters twice as large as usual have no room beside each other on a phone. */
      @media (max-width: 15rem) {
        nav {
          flex-wrap: wrap;
        }
      }
    `,
  ];

  constructor() {
    super();
    this.tab = "layers";
    this.open = true;
  }

  protected watched({ view, textToType, tool, toolPanel, optionsGivenWay }: EditorState): readonly unknown[] {
    return [view.layout, textToType, tool, toolPanel, optionsGivenWay];
  }

  /** Words that were put on the model just now are typed; and the texture is no panel while it has the place of the model. */
  override willUpdate(): void {
    const { textToType } = this.state;
    if (textToType !== null && textToType !== this.#typed) {
      this.tab = "properties";
      this.open = true;
    }
    // What the chosen tool or the view lays open is in front of the tabs' panels until it is closed.
    if (openToolPanel(this.editor)) this.open = true;
    this.#typed = textToType;
    if (this.tab === "texture" && this.state.view.layout === "texture") this.tab = "layers";
  }

  override render(): TemplateResult {
    const laidOpen = openToolPanel(this.editor);
    return html`
      <div class="panel" id="panel" ?hidden=${!this.open}>
        ${this.open ? html`<slot name="hint"></slot>${laidOpen ? toolPanel(this.editor, laidOpen) : this.#panel()}` : ""}
      </div>
      <nav aria-label=${this.strings.sheet.label}>
        ${TABS.filter(({ id }) => id !== "texture" || this.state.view.layout !== "texture").map(
          ({ id, drawing }) => html`<button
            id=${`sheet-${id}`}
            aria-expanded=${this.open && !laidOpen && this.tab === id}
            aria-controls="panel"
            @click=${() => this.#choose(id)}
          >
            ${icon(drawing)}${this.strings.sheet[id]}
          </button>`,
        )}
      </nav>
    `;
  }

  #panel(): TemplateResult {
    const { editor, tab } = this;
    if (tab === "texture")
      return html`<tc-texture-panel .editor=${editor}><slot name="texture" slot="texture"></slot></tc-texture-panel>`;
    return html`<tc-side-panel .editor=${editor} .only=${tab}></tc-side-panel>`;
  }

  /** The open tab's own button closes the sheet. */
  #choose(tab: SheetTab): void {
    this.open = openToolPanel(this.editor) !== null || !(this.open && this.tab === tab);
    this.tab = tab;
    this.editor.store.set({ toolPanel: null });
  }
}
customElements.define("tc-bottom-sheet", BottomSheet);
