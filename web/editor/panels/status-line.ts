/**
 * Quiet figures under the views. They are not announced: they change in every frame of a drag. What that cost is for whoever
 * asks: it shows over the figure of the painted texels, and is in the test handle's `stats()`.
 */
import { css, html, nothing, type TemplateResult } from "lit";
import type { Editor } from "../state/editor.ts";
import type { EditorState, Figures } from "../state/editor-state.ts";
import { StoreController } from "../state/store.ts";
import type { Strings } from "../strings.ts";
import { RemElement } from "../ui/rem-element.ts";

/** Milliseconds between two changes of the figures: faster ones nobody reads. */
const PACE = 150;

export class StatusLine extends RemElement {
  static override properties = { editor: { attribute: false } };
  declare editor: Editor;

  static override styles = css`
    :host {
      display: block;
      height: 26px;
      border-top: 1px solid var(--line);
      background: var(--surface);
      color: var(--text-quiet);
      font-size: var(--text-small);
      font-variant-numeric: tabular-nums;
      white-space: nowrap;
    }
    /* Its figures change all the time: they lay out this line and not the page. */
    .line {
      display: flex;
      align-items: center;
      gap: var(--space-4);
      height: 100%;
      padding: 0 var(--space-3);
      contain: strict;
    }
  `;

  constructor() {
    super();
    new StoreController<EditorState>(
      this,
      () => this.editor?.store,
      ({ targets, material, model, keeping }) => [targets, material, model, keeping],
    );
    new StoreController<Figures>(
      this,
      () => this.editor?.figures,
      ({ updates }) => [updates],
      { milliseconds: PACE },
    );
  }

  get strings(): Strings {
    return this.editor.strings;
  }

  get #words(): Strings["status"] {
    return this.strings.status;
  }

  #cost(engine: number, upload: number): string {
    const { tenths } = this.strings.numbers;
    return `${this.#words.engine(tenths(engine))}, ${this.#words.upload(tenths(upload))}`;
  }

  override render(): TemplateResult {
    const { targets, material, model, keeping } = this.editor.store.state;
    const kept = this.strings.projects.keeping[keeping];
    const target = material === null ? undefined : targets.get(material);
    const { update, uploadMilliseconds } = this.editor.figures.state;
    if (!target) return html`<div class="line"><span>${model ? this.#words.ready : this.#words.noModel}</span></div>`;
    return html`<div class="line">
      <span>${this.#words.size(target.width, target.height)}</span>
      ${kept ? html`<span id="keeping">${kept}</span>` : nothing}
      ${
        update
          ? html`<span title=${this.#cost(update.milliseconds, uploadMilliseconds)}
              >${this.#words.painted(this.strings.numbers.whole(update.projectedTexels))}</span
            >`
          : nothing
      }
    </div>`;
  }
}
customElements.define("tc-status-line", StatusLine);
