/** Which views are there: the model, the model and its texture, the texture. On a phone the two swap places. */
import { css, html, type TemplateResult } from "lit";
import { Box, Columns2, Grid2x2, type IconNode } from "lucide";
import type { EditorState } from "../state/editor-state.ts";
import { VIEW_LAYOUTS, type ViewLayout } from "../state/view-state.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";

const DRAWINGS: Readonly<Record<ViewLayout, IconNode>> = { model: Box, both: Columns2, texture: Grid2x2 };
const STEPS: Readonly<Record<string, number>> = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

export class LayoutSwitch extends EditorElement {
  static override properties = { compact: { type: Boolean } };
  /** One view at a time: the texture beside the model is the sheet's matter. */
  declare compact: boolean;

  static override styles = [
    controls,
    css`
      :host {
        display: block;
      }
      [role="radiogroup"] {
        display: flex;
        gap: 2px;
        padding: 2px;
        border-radius: var(--radius);
        background: var(--surface-low);
      }
      [role="radio"] {
        min-height: calc(var(--target) - 4px);
        border-radius: 4px;
      }
      @media (pointer: coarse) {
        [role="radiogroup"] {
          padding-block: 0;
        }
        [role="radio"] {
          min-height: var(--target);
        }
      }
      button[aria-checked="true"] {
        background: var(--surface-high);
        color: var(--text);
        box-shadow: 0 1px 2px rgb(20 24 32 / 14%);
      }
    `,
  ];

  constructor() {
    super();
    this.compact = false;
  }

  get #words(): Strings["views"] {
    return this.strings.views;
  }

  protected watched({ view }: EditorState): readonly unknown[] {
    return [view.layout];
  }

  override render(): TemplateResult {
    const { layout } = this.state.view;
    const { views } = this.editor;
    if (this.compact) {
      const other = layout === "texture" ? "model" : "texture";
      return html`<button
        class="icon"
        id="swap-views"
        aria-label=${this.#words.showInstead[other]}
        title=${this.#words.showInstead[other]}
        @click=${() => views.setLayout(other)}
      >
        ${icon(DRAWINGS[other])}
      </button>`;
    }
    return html`
      <div role="radiogroup" aria-label=${this.#words.layout} @keydown=${this.#key}>
        ${VIEW_LAYOUTS.map(
          (value, index) => html`<button
            class="icon"
            role="radio"
            id=${`layout-${value}`}
            aria-checked=${value === layout}
            aria-label=${this.#words.layouts[value]}
            aria-keyshortcuts=${`Alt+${index + 1}`}
            tabindex=${value === layout ? 0 : -1}
            title=${this.#words.withKey(this.#words.layouts[value], `Alt ${index + 1}`)}
            @click=${() => views.setLayout(value)}
          >
            ${icon(DRAWINGS[value])}
          </button>`,
        )}
      </div>
    `;
  }

  #key(event: KeyboardEvent): void {
    const step = STEPS[event.key];
    if (step === undefined || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const count = VIEW_LAYOUTS.length;
    const next = VIEW_LAYOUTS[(VIEW_LAYOUTS.indexOf(this.state.view.layout) + step + count) % count];
    if (!next) return;
    this.editor.views.setLayout(next);
    this.renderRoot.querySelector<HTMLElement>(`#layout-${next}`)?.focus();
  }
}
customElements.define("tc-layout-switch", LayoutSwitch);
