/** "New from template": the blank models that come with the page, each with a small picture. */
import { css, html, type TemplateResult } from "lit";
import { X } from "lucide";
import type { DemoTemplate } from "../files/demo-catalogue.ts";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { dialogFrame } from "../ui/dialog-frame.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";

export class TemplateDialog extends EditorElement {
  static override styles = [
    controls,
    dialogFrame,
    css`
      dialog {
        width: min(38rem, calc(100vw - 2rem));
      }
      .body {
        display: grid;
        gap: var(--space-3);
        padding: 0 var(--space-4) var(--space-4);
      }
      ul {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(10rem, 1fr));
        gap: var(--space-2);
        margin: 0;
        padding: 0;
        list-style: none;
      }
      li button {
        display: grid;
        grid-template-columns: minmax(0, 1fr);
        gap: 2px;
        width: 100%;
        height: 100%;
        align-content: start;
        padding: var(--space-2);
        border: 1px solid var(--line);
        border-radius: var(--radius-large);
        text-align: start;
      }
      li button:hover {
        border-color: var(--line-strong);
      }
      img {
        justify-self: stretch;
        height: 7rem;
        margin-block-end: var(--space-1);
        padding: var(--space-2);
        border-radius: var(--radius);
        background: var(--surface-low);
        object-fit: contain;
      }
      .name {
        font-weight: 550;
      }
      .hint {
        color: var(--text-quiet);
        font-size: var(--text-small);
      }
    `,
  ];

  get #words(): Strings["templates"] {
    return this.strings.templates;
  }

  show(): void {
    this.#dialog?.showModal();
  }

  close(): void {
    this.#dialog?.close();
  }

  protected watched({ demos }: EditorState): readonly unknown[] {
    return [demos];
  }

  get #dialog(): HTMLDialogElement | null {
    return this.renderRoot.querySelector("dialog");
  }

  override render(): TemplateResult {
    const { demos } = this.state;
    const close = (): void => this.#dialog?.close();
    const outside = (event: Event): void => {
      if (event.target === event.currentTarget) close();
    };
    return html`
      <dialog aria-labelledby="title" aria-describedby="about" @click=${outside}>
        <header>
          <h2 id="title">${this.#words.title}</h2>
          <button class="icon" aria-label=${this.#words.close} title=${this.#words.close} @click=${close}>${icon(X)}</button>
        </header>
        <div class="body">
          <p class="quiet" id="about">${demos?.templates.length ? this.#words.hint : this.#words.none}</p>
          <ul>
            ${(demos?.templates ?? []).map((template) => this.#entry(template, demos?.page ?? ""))}
          </ul>
        </div>
      </dialog>
    `;
  }

  #entry(template: DemoTemplate, page: string): TemplateResult {
    const { id, name, hint, picture, size } = template;
    const choose = (): void => {
      this.#dialog?.close();
      void this.editor.files.openTemplate(template);
    };
    return html`
      <li>
        <button data-template=${id} @click=${choose}>
          <img src=${new URL(picture, page).href} alt="" loading="lazy" />
          <span class="name">${name}</span>
          <span class="hint">${hint}</span>
          <span class="hint">${this.#words.size(size[0], size[1])}</span>
        </button>
      </li>
    `;
  }
}
customElements.define("tc-template-dialog", TemplateDialog);

declare global {
  interface HTMLElementTagNameMap {
    "tc-template-dialog": TemplateDialog;
  }
}
