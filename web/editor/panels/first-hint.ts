/**
 * Three steps for the first visit: what one could do, in nobody's way, gone for good when closed. What the user has done is not
 * told any more. A card in the views' corner where the model leaves that free, else a strip beside the views.
 */
import { css, html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { X } from "lucide";
import { keepChoice, keptChoice } from "../storage/kept-choice.ts";
import type { Strings } from "../strings.ts";
import { icon } from "../ui/icon.ts";
import { RemElement } from "../ui/rem-element.ts";
import { plainControls } from "../ui/theme.ts";
import { unseen } from "../ui/unseen.ts";

const CHOOSE = 0;
const DRAG = 1;

const SEEN = "texelcast-hint-seen";

export class FirstHint extends RemElement {
  static override properties = {
    words: { attribute: false },
    done: { attribute: false },
    bare: { attribute: false },
    step: { state: true },
    seen: { state: true },
  };
  declare words: Strings["hint"];
  /** How many of the steps the user has taken without being told. */
  declare done: number;
  /** There is nothing to drag: the model has no layers. */
  declare bare: boolean;
  declare step: number;
  declare seen: boolean;

  static override styles = [
    plainControls,
    css`
      :host {
        pointer-events: none;
      }
      section {
        display: grid;
        gap: var(--space-1);
        box-sizing: border-box;
        width: min(17rem, 100%);
        padding: var(--space-3);
        border: 1px solid var(--line);
        border-radius: var(--radius-large);
        background: var(--surface-high);
        box-shadow: var(--shadow);
        line-height: 1.4;
        pointer-events: auto;
      }
      header,
      footer {
        display: flex;
        align-items: center;
        justify-content: space-between;
        gap: var(--space-2);
      }
      header button {
        margin: calc(-1 * var(--space-1));
      }
      h2 {
        font-size: var(--text-small);
        font-weight: 550;
      }
      h2,
      p,
      footer span {
        color: var(--text-quiet);
      }
      /* A strip of the phone's sheet, or under the views, with its buttons beside the words. */
      :host([compact]) section {
        grid-template: auto auto / minmax(0, 1fr) auto auto;
        align-items: center;
        gap: 0 var(--space-1);
        width: 100%;
        border-width: 0 0 1px;
        border-radius: 0;
        padding: var(--space-1) var(--space-2) var(--space-1) var(--space-4);
        background: var(--accent-soft);
        box-shadow: none;
      }
      :host([compact]) header,
      :host([compact]) footer {
        display: contents;
      }
      :host([compact]) h2 {
        align-self: end;
        padding-block-start: var(--space-1);
        color: var(--text);
      }
      :host([compact]) #dismiss {
        grid-area: 1 / 3 / 3 / 4;
        margin: 0;
      }
      :host([compact]) p {
        grid-area: 2 / 1;
        align-self: start;
        padding-block-end: var(--space-1);
        color: var(--text);
      }
      :host([compact]) footer span {
        display: none;
      }
      :host([compact]) #next {
        grid-area: 1 / 2 / 3 / 3;
        color: var(--accent);
        font-weight: 550;
      }
      /* Where the layers would have no room beside it, its heading is all that is seen of it. */
      @media (max-height: 30rem), (max-width: 720px) and (max-height: 44rem) {
        :host([compact]) h2 {
          align-self: center;
          grid-row: 1 / 3;
          padding: 0;
        }
        :host([compact]) p {
          ${unseen}
        }
      }
    `,
  ];

  constructor() {
    super();
    this.done = 0;
    this.bare = false;
    this.step = 0;
    this.seen = keptChoice(SEEN) !== null;
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("done")) this.step = Math.max(this.step, this.done);
  }

  /** Another model may have come after a picture was chosen for the one before. */
  get #shown(): number {
    return this.bare && this.step === DRAG ? CHOOSE : this.step;
  }

  override render(): TemplateResult | typeof nothing {
    const shown = this.#shown;
    const current = this.words.steps[shown];
    if (this.seen || !current) return nothing;
    const [title, body] = current;
    const isLast = shown === this.words.steps.length - 1;
    return html`
      <section aria-label=${this.words.label}>
        <header>
          <h2>${title}</h2>
          <button class="icon small" id="dismiss" aria-label=${this.words.dismiss} title=${this.words.dismiss} @click=${this.#close}>
            ${icon(X)}
          </button>
        </header>
        <p aria-live="polite">${body}</p>
        <footer>
          <span>${this.words.place(shown + 1, this.words.steps.length)}</span>
          <button id="next" @click=${isLast ? this.#close : this.#next}>${isLast ? this.words.done : this.words.next}</button>
        </footer>
      </section>
    `;
  }

  readonly #next = (): void => {
    this.step += 1;
    if (this.#shown < this.step) this.step += 1;
  };

  readonly #close = (): void => {
    this.seen = true;
    keepChoice(SEEN, "yes");
  };
}
customElements.define("tc-first-hint", FirstHint);
