/** Keys, and the licences of what the page shows. */
import { css, html, nothing, type TemplateResult } from "lit";
import { X } from "lucide";
import lucideLicence from "../../../node_modules/lucide/LICENSE?raw";
import { LANGUAGES, type Language, pageLanguage, speak } from "../strings/language.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { dialogFrame } from "../ui/dialog-frame.ts";
import { icon } from "../ui/icon.ts";
import { RemElement } from "../ui/rem-element.ts";

export class HelpDialog extends RemElement {
  static override properties = { words: { attribute: false }, embedded: { type: Boolean } };
  declare words: Strings["help"];
  /** In a page of somebody else's, who chooses the language. */
  declare embedded: boolean;

  static override styles = [
    controls,
    dialogFrame,
    css`
      dialog {
        width: min(56rem, calc(100vw - 2rem));
      }
      .body {
        display: grid;
        gap: var(--space-4);
        padding: 0 var(--space-4) var(--space-4);
      }
      .groups {
        columns: 22rem;
        column-gap: var(--space-5);
      }
      section {
        break-inside: avoid;
        padding-block-end: var(--space-4);
      }
      h3 {
        margin: 0 0 var(--space-2);
        color: var(--text-quiet);
        font-size: var(--text-small);
        font-weight: 550;
      }
      dl {
        display: grid;
        grid-template-columns: minmax(0, 9rem) minmax(0, 1fr);
        gap: var(--space-2) var(--space-4);
        margin: 0;
        line-height: 1.4;
      }
      dt {
        font-weight: 550;
      }
      dd {
        margin: 0;
        color: var(--text-quiet);
      }
      @media (max-width: 30rem) {
        dl {
          grid-template-columns: minmax(0, 1fr);
          gap: 0;
        }
        dd {
          margin-block-end: var(--space-2);
        }
      }
      .language {
        display: flex;
        align-items: center;
        gap: var(--space-2) var(--space-3);
        flex-wrap: wrap;
      }
      .language label {
        font-weight: 550;
      }
      .language select {
        width: auto;
      }
      summary {
        min-height: var(--target);
        align-content: center;
        cursor: pointer;
      }
      pre {
        margin: var(--space-2) 0 0;
        color: var(--text-quiet);
        font-size: var(--text-small);
        white-space: pre-wrap;
        overflow-wrap: anywhere;
      }
    `,
  ];

  show(): void {
    this.#dialog?.showModal();
  }

  close(): void {
    this.#dialog?.close();
  }

  get #dialog(): HTMLDialogElement | null {
    return this.renderRoot.querySelector("dialog");
  }

  #languages(): TemplateResult {
    return html`
      <div class="language">
        <label for="language">${this.words.language}</label>
        <select id="language" aria-describedby="language-hint" @change=${(event: Event) => speak((event.target as HTMLSelectElement).value as Language)}>
          ${Object.entries(LANGUAGES).map(
            ([code, name]) =>
              html`<option value=${code} lang=${code} ?selected=${code === pageLanguage}>${name}</option>`,
          )}
        </select>
        <p class="quiet" id="language-hint">${this.words.languageHint}</p>
      </div>
    `;
  }

  override render(): TemplateResult {
    const close = (): void => this.#dialog?.close();
    const outside = (event: Event): void => {
      if (event.target === event.currentTarget) close();
    };
    return html`
      <dialog aria-labelledby="title" @click=${outside}>
        <header>
          <h2 id="title">${this.words.title}</h2>
          <button class="icon" aria-label=${this.words.close} title=${this.words.close} @click=${close}>${icon(X)}</button>
        </header>
        <div class="body">
          <div class="groups">
            ${ordered(this.words.keyGroups).map(
              ({ name, keys }) =>
                html`<section>
                  <h3>${name}</h3>
                  <dl>
                    ${keys.map(
                      ([key, meaning]) =>
                        html`<dt>${key}</dt>
                          <dd>${meaning}</dd>`,
                    )}
                  </dl>
                </section>`,
            )}
          </div>
          ${this.embedded ? nothing : this.#languages()}
          <details>
            <summary>${this.words.licences}</summary>
            <pre>
${this.words.icons}

${lucideLicence}</pre
            >
          </details>
        </div>
      </dialog>
    `;
  }
}
customElements.define("tc-help-dialog", HelpDialog);

/** Where a finger is the pointer, its gestures come first. */
function ordered(keyGroups: Strings["help"]["keyGroups"]): Strings["help"]["keyGroups"] {
  if (!matchMedia("(pointer: coarse)").matches) return keyGroups;
  return [...keyGroups.slice(-1), ...keyGroups.slice(0, -1)];
}
