/** Three steps for the first visit, in a corner of the views: what one could do, in nobody's way, gone for good when closed. */
import { css, html, nothing, type TemplateResult } from "lit";
import { X } from "lucide";
import type { Strings } from "../strings.ts";
import { icon } from "../ui/icon.ts";
import { RemElement } from "../ui/rem-element.ts";
import { plainControls } from "../ui/theme.ts";

const SEEN = "texelcast-hint-seen";

export class FirstHint extends RemElement {
  static override properties = { words: { attribute: false }, step: { state: true }, seen: { state: true } };
  declare words: Strings["hint"];
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
      p,
      footer span {
        color: var(--text-quiet);
      }
      /* A strip of the phone's sheet, with its buttons beside the words. */
      :host([compact]) section {
        grid-template: auto minmax(0, 1fr) / minmax(0, 1fr) auto;
        gap: 0 var(--space-2);
        width: 100%;
        border-width: 0 0 1px;
        border-radius: 0;
        padding: var(--space-1) var(--space-2) var(--space-2) var(--space-4);
        background: var(--accent-soft);
        box-shadow: none;
      }
      :host([compact]) header,
      :host([compact]) footer {
        display: contents;
      }
      :host([compact]) h3 {
        align-self: center;
        color: var(--text);
      }
      :host([compact]) #dismiss {
        justify-self: end;
        margin: 0;
      }
      :host([compact]) p {
        color: var(--text);
      }
      :host([compact]) footer span {
        display: none;
      }
      :host([compact]) #next {
        align-self: end;
        color: var(--accent);
        font-weight: 550;
      }
    `,
  ];

  constructor() {
    super();
    this.step = 0;
    this.seen = wasSeen();
  }

  override render(): TemplateResult | typeof nothing {
    const current = this.words.steps[this.step];
    if (this.seen || !current) return nothing;
    const [title, body] = current;
    const isLast = this.step === this.words.steps.length - 1;
    return html`
      <section aria-label=${this.words.label}>
        <header>
          <h3>${title}</h3>
          <button class="icon small" id="dismiss" aria-label=${this.words.dismiss} title=${this.words.dismiss} @click=${this.#close}>
            ${icon(X)}
          </button>
        </header>
        <p aria-live="polite">${body}</p>
        <footer>
          <span>${this.words.place(this.step + 1, this.words.steps.length)}</span>
          <button id="next" @click=${isLast ? this.#close : this.#next}>${isLast ? this.words.done : this.words.next}</button>
        </footer>
      </section>
    `;
  }

  readonly #next = (): void => {
    this.step += 1;
  };

  readonly #close = (): void => {
    this.seen = true;
    try {
      localStorage.setItem(SEEN, "yes");
    } catch {
      // A browser that keeps nothing shows it again.
    }
  };
}
customElements.define("tc-first-hint", FirstHint);

function wasSeen(): boolean {
  try {
    return localStorage.getItem(SEEN) !== null;
  } catch {
    return false;
  }
}
