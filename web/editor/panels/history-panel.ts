/**
 * The steps of the history, the oldest first, with the present one marked; a step is gone to by click or by key. Rows are
 * made for what is in sight alone, since steps may be thousands.
 */
import { css, html, nothing, type TemplateResult } from "lit";
import type { EditorState } from "../state/editor-state.ts";
import { HISTORY_BUDGETS } from "../state/history-budget.ts";
import { megabytes } from "../state/megabytes.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";

/** Rows above and below what is in sight, so that a scroll does not show bare ground. */
const SPARE_ROWS = 8;
const PAGE = 10;

export class HistoryPanel extends EditorElement {
  static override properties = { top: { state: true } };
  /** How far the list is scrolled, pixels. */
  declare top: number;
  #rowHeight = 28;
  #height = 0;
  #followed = -1;
  readonly #resize = new ResizeObserver(() => this.#measure());

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        grid-template-rows: minmax(0, 1fr) auto;
        min-height: 0;
      }
      .list {
        position: relative;
        min-height: 0;
        overflow: hidden auto;
        overscroll-behavior: contain;
        padding-block: var(--space-1);
        scrollbar-width: thin;
        scrollbar-color: var(--line-strong) transparent;
      }
      .list:focus-visible {
        outline-offset: -2px;
      }
      .steps {
        position: relative;
      }
      .step {
        position: absolute;
        inset-inline: var(--space-2);
        display: flex;
        align-items: center;
        height: var(--target);
        padding-inline: var(--space-2);
        border-radius: var(--radius);
        overflow: hidden;
        white-space: nowrap;
        cursor: pointer;
        -webkit-user-select: none;
        user-select: none;
      }
      .step span {
        overflow: hidden;
        text-overflow: ellipsis;
      }
      @media (hover: hover) {
        .step:hover {
          background: var(--hover);
        }
      }
      .step.undone {
        color: var(--text-quiet);
        font-style: italic;
      }
      .step[aria-selected="true"] {
        background: var(--accent-soft);
        font-weight: 550;
      }
      footer {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 0 var(--space-2);
        padding: var(--space-1) var(--space-4);
        border-top: 1px solid var(--line);
        color: var(--text-quiet);
        font-size: var(--text-small);
        font-variant-numeric: tabular-nums;
      }
      footer p {
        flex: 1;
        text-align: end;
      }
      footer .dropped {
        flex: 1 0 100%;
        padding-top: var(--space-1);
        text-align: start;
      }
      footer select {
        width: auto;
        font-size: inherit;
      }
    `,
  ];

  constructor() {
    super();
    this.top = 0;
  }

  get #words(): Strings["history"] {
    return this.strings.history;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#resize.disconnect();
    this.#followed = -1;
  }

  protected watched({ history, switching }: EditorState): readonly unknown[] {
    return [history, switching];
  }

  override render(): TemplateResult {
    const { labels, position } = this.state.history;
    const first = Math.max(0, Math.floor(this.top / this.#rowHeight) - SPARE_ROWS);
    const count = Math.ceil(this.#height / this.#rowHeight) + 2 * SPARE_ROWS;
    const shown = labels.slice(first, first + count);
    return html`
      <div
        class="list"
        role="listbox"
        tabindex="0"
        aria-disabled=${this.state.readonly}
        aria-label=${this.#words.list}
        aria-activedescendant=${`step-${position}`}
        @scroll=${(event: Event) => {
          this.top = (event.target as HTMLElement).scrollTop;
        }}
        @keydown=${this.#key}
      >
        <div class="steps" role="presentation" .style=${`height: ${labels.length * this.#rowHeight}px`}>
          ${shown.map((label, index) => this.#step(label, first + index, position, labels.length))}
        </div>
      </div>
      ${this.#footer()}
    `;
  }

  #step(label: string, place: number, position: number, count: number): TemplateResult {
    return html`<div
      class=${place > position ? "step undone" : "step"}
      role="option"
      id=${`step-${place}`}
      aria-selected=${place === position}
      aria-posinset=${place + 1}
      aria-setsize=${count}
      .style=${`top: ${place * this.#rowHeight}px`}
      @click=${() => void this.editor.files.travelTo(place)}
    >
      <span>${this.#words.step(label)}</span>
    </div>`;
  }

  #footer(): TemplateResult {
    const { heldBytes, budget, dropped } = this.state.history;
    const choose = (event: Event): void =>
      this.editor.setHistoryBudget(Number((event.target as HTMLSelectElement).value));
    return html`
      <footer title=${this.#words.heldHint}>
        ${dropped > 0 ? html`<span class="dropped">${this.#words.droppedNote(dropped)}</span>` : nothing}
        <p id="held">${this.#words.held(this.#words.megabytes(megabytes(heldBytes)))}</p>
        <select id="budget" aria-label=${this.#words.budget} @change=${choose}>
          ${HISTORY_BUDGETS.map(
            (bytes) =>
              html`<option value=${bytes} .selected=${bytes === budget}>${this.#words.megabytes(megabytes(bytes))}</option>`,
          )}
        </select>
      </footer>
    `;
  }

  override firstUpdated(): void {
    this.#measure();
  }

  override updated(): void {
    const list = this.#list();
    if (list) this.#resize.observe(list);
    const { position } = this.state.history;
    if (list && position !== this.#followed) {
      this.#followed = position;
      this.#bringIntoSight(list, position);
    }
  }

  #list(): HTMLElement | null {
    return this.renderRoot.querySelector<HTMLElement>(".list");
  }

  /** A finger's rows are taller than a mouse's: the theme says how tall. */
  #measure(): void {
    const list = this.#list();
    if (!list) return;
    const rowHeight = list.querySelector<HTMLElement>(".step")?.offsetHeight ?? this.#rowHeight;
    if (rowHeight === this.#rowHeight && list.clientHeight === this.#height) return;
    this.#rowHeight = rowHeight;
    this.#height = list.clientHeight;
    this.#followed = -1;
    this.requestUpdate();
  }

  #bringIntoSight(list: HTMLElement, position: number): void {
    const from = position * this.#rowHeight;
    const { scrollTop, clientHeight } = list;
    if (from < scrollTop) list.scrollTop = from;
    else if (from + 2 * this.#rowHeight > scrollTop + clientHeight)
      list.scrollTop = from + 2 * this.#rowHeight - clientHeight;
  }

  #key(event: KeyboardEvent): void {
    const { position, labels } = this.state.history;
    const goals: Readonly<Record<string, number>> = {
      ArrowUp: position - 1,
      ArrowDown: position + 1,
      PageUp: position - PAGE,
      PageDown: position + PAGE,
      Home: 0,
      End: labels.length - 1,
    };
    const goal = goals[event.key];
    if (goal === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    void this.editor.files.travelTo(Math.max(0, Math.min(labels.length - 1, goal)));
  }
}
customElements.define("tc-history-panel", HistoryPanel);
