/** Notices (calm, dismissible), the progress of long work, and the page's live region. */
import { css, html, nothing, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { Info, TriangleAlert, X } from "lucide";
import type { EditorState, Task } from "../state/editor-state.ts";
import type { Notice } from "../state/notices.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import { sentence } from "../ui/sentence.ts";
import { plainControls } from "../ui/theme.ts";
import { TypingIn } from "../ui/typing-in.ts";

export class NoticeStack extends EditorElement {
  static override properties = { since: { attribute: false } };
  /** Shows only what has come after the notice of this number, and announces nothing: a dialog's own. Null: all, and the page's. */
  declare since: number | null;

  constructor() {
    super();
    this.since = null;
  }

  static override styles = [
    plainControls,
    css`
      :host {
        display: grid;
        gap: var(--space-2);
        justify-items: center;
        pointer-events: none;
      }
      .alerts {
        display: grid;
        gap: var(--space-2);
        justify-items: center;
        width: 100%;
      }
      .card {
        pointer-events: auto;
        width: min(30rem, 100%);
        padding: var(--space-3);
        border: 1px solid var(--line);
        border-radius: var(--radius-large);
        background: var(--surface-high);
        box-shadow: var(--shadow);
      }
      .notice {
        display: grid;
        grid-template-columns: auto 1fr auto;
        gap: var(--space-1) var(--space-3);
      }
      .notice tc-icon {
        margin-top: 2px;
      }
      .error > tc-icon {
        color: var(--danger);
      }
      .info > tc-icon {
        color: var(--accent);
      }
      .words {
        display: grid;
        gap: var(--space-1);
        min-width: 0;
        overflow-wrap: anywhere;
        line-height: 1.45;
      }
      /* Three in full would cover a phone: those before the newest are their headings until it is closed. */
      :host([compact]) .notice:not(:last-child) {
        align-items: center;
        padding-block: var(--space-1);
      }
      :host([compact]) .notice:not(:last-child) .words > :not(h2) {
        display: none;
      }
      :host([compact]) .notice:not(:last-child) .dismiss {
        margin-block: 0;
      }
      /* Beside what is typed there is room for what happened and what to do: the rest is seen when that ends, and heard at once. */
      :host([terse]) .info .words > p {
        position: absolute;
        width: 1px;
        height: 1px;
        overflow: hidden;
        clip-path: inset(50%);
      }
      .where {
        color: var(--text-quiet);
        font-size: var(--text-small);
      }
      .words details {
        color: var(--text-quiet);
        font-size: var(--text-small);
      }
      .words summary {
        width: fit-content;
        padding-block: max(3px, (var(--target) - 1.45em) / 2);
        cursor: pointer;
      }
      .dismiss {
        align-self: start;
        margin: -6px -6px 0 0;
      }
      .action {
        justify-self: start;
        margin-top: var(--space-1);
      }
      .task {
        display: grid;
        grid-template-columns: 1fr auto;
        align-items: center;
        gap: var(--space-2) var(--space-3);
        width: min(20rem, 100%);
        padding-block: var(--space-2);
      }
      progress {
        grid-column: 1 / -1;
        width: 100%;
        height: 4px;
        margin-bottom: var(--space-1);
        border: 0;
        border-radius: 2px;
        overflow: hidden;
        background: var(--line);
        accent-color: var(--accent);
        appearance: none;
        forced-color-adjust: none;
      }
      progress::-webkit-progress-bar {
        background: var(--line);
      }
      progress::-webkit-progress-value {
        border-radius: 2px;
        background: var(--accent);
        transition: width 120ms linear;
      }
      progress::-moz-progress-bar {
        background: var(--accent);
      }
      progress:indeterminate {
        background: linear-gradient(90deg, var(--line) 30%, var(--accent) 50%, var(--line) 70%) 0 0 / 300% 100%;
        animation: wander 1.6s linear infinite;
      }
      progress:indeterminate::-webkit-progress-bar {
        background: transparent;
      }
      @keyframes wander {
        from {
          background-position: 150% 0;
        }
        to {
          background-position: -150% 0;
        }
      }
    `,
  ];

  protected watched({ notices, tasks, announcement }: EditorState): readonly unknown[] {
    return [notices, tasks, announcement];
  }

  /** What is told of words while they are typed on a phone would lie over their field. */
  readonly #typing = new TypingIn(this, "tc-bottom-sheet");

  /** Place among its buttons of the one that had the focus before a render; -1: none. */
  #focused = -1;

  get #buttons(): HTMLElement[] {
    return [...this.renderRoot.querySelectorAll<HTMLElement>("button")];
  }

  override willUpdate(): void {
    this.#focused = this.#buttons.indexOf(this.shadowRoot?.activeElement as HTMLElement);
  }

  /** From what has gone the keyboard goes on to what stands there now, or back to the work. */
  override updated(): void {
    if (this.#focused < 0 || this.shadowRoot?.activeElement) return;
    const buttons = this.#buttons;
    const before = this.closest("dialog")?.querySelector("button") ?? this.editor.work;
    (buttons[this.#focused] ?? buttons.at(-1) ?? before).focus({ preventScroll: true });
  }

  override render(): TemplateResult {
    const { tasks, announcement } = this.state;
    const { since } = this;
    const notices = this.state.notices.filter(({ id }) => since === null || id > since);
    const shown = since !== null ? [] : tasks.filter(({ visible }) => visible);
    this.toggleAttribute("filled", notices.length + shown.length > 0);
    this.toggleAttribute("terse", this.#typing.now);
    return html`
      ${since === null ? html`<div class="visually-hidden" id="announcer" aria-live="polite">${announcement}</div>` : nothing}
      ${repeat(
        shown,
        ({ id }) => id,
        (task) => this.#task(task),
      )}
      <div class="alerts" role="region" aria-label=${this.strings.notices.label}>
        ${repeat(
          notices,
          ({ id }) => id,
          (notice) => this.#notice(notice),
        )}
      </div>
    `;
  }

  #task({ label, share, cancel }: Task): TemplateResult {
    return html`
      <div class="card task" role="status">
        <span>${label}</span>
        ${cancel ? html`<button class="outlined" @click=${cancel}>${this.strings.tasks.cancel}</button>` : html`<span></span>`}
        <progress aria-label=${label} max="1" value=${share ?? nothing}></progress>
      </div>
    `;
  }

  /** In the engine's English, which a screen reader is told of. */
  #exact(text: string, subject?: string): TemplateResult {
    return html`<details>
      <summary>${this.strings.notices.exact}</summary>
      <p lang="en">${sentence(text, subject)}</p>
    </details>`;
  }

  #notice(notice: Notice): TemplateResult {
    const { id, tone, title, code, subject, message, where, hint, exact, action } = notice;
    const dismiss = (): void => this.editor.board.dismiss(id);
    const act = (): void => {
      dismiss();
      action?.run();
    };
    return html`
      <section class="card notice ${tone}" role=${tone === "error" ? "alert" : "status"} data-code=${code}>
        ${icon(tone === "error" ? TriangleAlert : Info)}
        <div class="words">
          <h2>${title}</h2>
          <p>${sentence(message, subject)}${hint ? ` ${sentence(hint)}` : ""}</p>
          ${where ? html`<p class="where">${where}</p>` : nothing}
          ${exact ? this.#exact(exact, subject) : nothing}
          ${action ? html`<button class="outlined action" @click=${act}>${action.label}</button>` : nothing}
        </div>
        <button class="icon dismiss" aria-label=${this.strings.notices.dismiss} title=${this.strings.notices.dismiss} @click=${dismiss}>
          ${icon(X)}
        </button>
      </section>
    `;
  }
}
customElements.define("tc-notice-stack", NoticeStack);
