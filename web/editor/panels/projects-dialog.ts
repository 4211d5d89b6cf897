/** The projects that the browser keeps: open, rename, duplicate, delete and bring back. */
import { css, html, nothing, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { Copy, Image, Pencil, Plus, Trash2, Undo2, X } from "lucide";
import type { EditorState, ListedProject } from "../state/editor-state.ts";
import { megabytes } from "../state/megabytes.ts";
import type { Strings } from "../strings.ts";
import { isComposed } from "../ui/composed-key.ts";
import { controls } from "../ui/controls.ts";
import { dialogFrame } from "../ui/dialog-frame.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import "./notice-stack.ts";

export class ProjectsDialog extends EditorElement {
  static override properties = { shown: { state: true }, renaming: { state: true } };
  declare shown: boolean;
  /** Id of the project whose name is being typed. */
  declare renaming: string | null;

  static override styles = [
    controls,
    dialogFrame,
    css`
      dialog {
        width: min(40rem, calc(100vw - 2rem));
      }
      h2 {
        flex: 1;
      }
      ul {
        display: grid;
        gap: 2px;
        margin: 0;
        padding: 0 var(--space-2) var(--space-3);
        list-style: none;
      }
      /* What fails meanwhile: the page's own notices lie behind, where nothing is pressed or heard. */
      tc-notice-stack[filled] {
        position: sticky;
        inset-block-end: 0;
        padding: 0 var(--space-2) var(--space-2);
      }
      .empty {
        padding: var(--space-2) var(--space-4) var(--space-5);
        line-height: 1.5;
      }
      li {
        display: grid;
        grid-template-columns: minmax(0, 1fr) auto;
        align-items: center;
        gap: var(--space-1);
        padding-inline-end: var(--space-1);
        border-radius: var(--radius-large);
      }
      @media (hover: hover) {
        li:hover {
          background: var(--hover);
        }
      }
      .open,
      .still {
        display: grid;
        grid-template-columns: auto minmax(0, 1fr);
        align-items: center;
        justify-content: start;
        gap: var(--space-3);
        padding: var(--space-2);
        text-align: start;
      }
      .open:hover {
        background: none;
      }
      .picture {
        display: grid;
        place-items: center;
        width: 72px;
        height: 54px;
        overflow: hidden;
        border-radius: var(--radius);
        background: var(--stage);
        color: var(--text-quiet);
      }
      .picture img {
        width: 100%;
        height: 100%;
        object-fit: cover;
      }
      .words {
        display: grid;
        gap: 3px;
        min-width: 0;
      }
      .name {
        overflow: hidden;
        font-weight: 550;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      .about {
        color: var(--text-quiet);
        font-size: var(--text-small);
        line-height: 1.4;
      }
      .here {
        color: var(--accent);
        font-weight: 550;
      }
      .acts {
        display: flex;
        gap: 2px;
      }
      .deleted .picture {
        opacity: 0.55;
      }
      /* Its words are read as any other's. */
      .deleted .name {
        color: var(--text-quiet);
        text-decoration: line-through;
      }
      @media (max-width: 560px) {
        li:not(.deleted) {
          grid-template-columns: minmax(0, 1fr);
        }
        .acts {
          justify-content: end;
          margin-block: calc(-1 * var(--space-2)) var(--space-1);
        }
      }
    `,
  ];

  constructor() {
    super();
    this.shown = false;
    this.renaming = null;
  }

  get #words(): Strings["projects"] {
    return this.strings.projects;
  }

  /** What was said before it was opened. */
  #saidBefore = "";
  #noticedBefore = 0;

  /** @param naming with the open project's name to be typed */
  show(naming = false): void {
    this.#saidBefore = this.state.announcement;
    this.#noticedBefore = Math.max(0, ...this.state.notices.map(({ id }) => id));
    this.shown = true;
    this.#dialog?.showModal();
    void this.#refresh(naming);
  }

  async #refresh(naming: boolean): Promise<void> {
    const { projects } = this.editor;
    await projects.refresh();
    const here = this.state.projects?.find(({ open }) => open === "here");
    if (naming && here && this.shown) this.#rename(here.id);
    await projects.refreshThumbnail();
  }

  protected watched({ projects, switching, keeping, announcement }: EditorState): readonly unknown[] {
    return [projects, switching, keeping, announcement];
  }

  get #dialog(): HTMLDialogElement | null {
    return this.renderRoot.querySelector("dialog");
  }

  override render(): TemplateResult {
    const outside = (event: Event): void => {
      if (event.target === event.currentTarget) this.#close();
    };
    // The page's own live region lies behind the dialog, where nothing is heard.
    const { announcement } = this.state;
    return html`
      <dialog aria-labelledby="title" @click=${outside} @close=${this.#closed}>
        <header>
          <h2 id="title">${this.#words.title}</h2>
          <button class="outlined" id="new-project" @click=${this.#create}>${icon(Plus)}${this.#words.create}</button>
          <button class="icon" aria-label=${this.#words.close} title=${this.#words.close} @click=${this.#close}>${icon(X)}</button>
        </header>
        <div class="visually-hidden" aria-live="polite">${announcement === this.#saidBefore ? nothing : announcement}</div>
        ${this.shown ? this.#list(this.state.projects) : nothing}
        ${this.shown ? html`<tc-notice-stack .editor=${this.editor} .since=${this.#noticedBefore}></tc-notice-stack>` : nothing}
      </dialog>
    `;
  }

  #list(projects: EditorState["projects"]): TemplateResult {
    if (projects === null) return html`<p class="empty quiet">${this.#words.loading}</p>`;
    const none = this.state.keeping === "refused" ? this.strings.storage.refusedTitle : this.#words.empty;
    if (projects.length === 0) return html`<p class="empty quiet">${none}</p>`;
    return html`
      <ul aria-label=${this.#words.list}>
        ${repeat(
          projects,
          ({ id }) => id,
          (project) => (project.deleted ? this.#deletedRow(project) : this.#row(project)),
        )}
      </ul>
    `;
  }

  #row(project: ListedProject): TemplateResult {
    const { id, name, open } = project;
    const commands = this.editor.projects;
    const renaming = this.renaming === id;
    return html`
      <li data-project=${id} aria-current=${open === "here" ? "true" : nothing}>
        ${
          renaming
            ? html`<div class="still">${picture(project)}${this.#nameField(project)}</div>`
            : html`
                <button class="open" @click=${() => this.#open(project)}>
                  <span class="visually-hidden">${this.#words.openBefore}</span>
                  ${picture(project)}
                  <span class="words">
                    <span class="name" dir="auto">${name}</span>
                    <span class="about">
                      ${open ? html`<span class="here">${open === "here" ? this.#words.openHere : this.#words.openElsewhere}</span> · ` : nothing}${aboutOf(project, this.strings)}
                    </span>
                  </span>
                </button>
              `
        }
        <div class="acts">
          ${action("rename", this.#words.rename(name), Pencil, () => this.#rename(id))}
          ${action("duplicate", this.#words.duplicate(name), Copy, () => void commands.duplicate(project))}
          ${action("delete", this.#words.remove(name), Trash2, () => this.#remove(project))}
        </div>
      </li>
    `;
  }

  #deletedRow(project: ListedProject): TemplateResult {
    const restore = (): void => void this.#restore(project);
    return html`
      <li class="deleted" data-project=${project.id}>
        <div class="still">
          ${picture(project)}
          <span class="words">
            <span class="name" dir="auto">${project.name}</span>
            <span class="about">${this.#words.deleted}</span>
          </span>
        </div>
        <button class="outlined" data-action="restore" aria-label=${this.#words.undoRemoveOf(project.name)} @click=${restore}>
          ${icon(Undo2)}${this.#words.undoRemove}
        </button>
      </li>
    `;
  }

  #nameField({ id, name }: ListedProject): TemplateResult {
    const end = (keep: boolean, input: HTMLInputElement): void => {
      if (this.renaming !== id) return;
      this.renaming = null;
      if (keep && input.value !== name) void this.editor.projects.rename(id, input.value);
      void this.#focus(id, "[data-action=rename]");
    };
    const key = (event: KeyboardEvent): void => {
      if (isComposed(event) || (event.key !== "Enter" && event.key !== "Escape")) return;
      // Escape ends the typing, not the dialog.
      event.preventDefault();
      event.stopPropagation();
      end(event.key === "Enter", event.target as HTMLInputElement);
    };
    const leave = (event: FocusEvent): void => end(true, event.target as HTMLInputElement);
    return html`
      <input type="text" dir="auto" aria-label=${this.#words.nameOf(name)} .value=${name} maxlength="120" @keydown=${key} @blur=${leave} />
    `;
  }

  #rename(id: string): void {
    this.renaming = id;
    void this.#focus(id, "input").then((input) => (input as HTMLInputElement | null)?.select());
  }

  async #remove(project: ListedProject): Promise<void> {
    await this.editor.projects.remove(project);
    await this.#focus(project.id, "[data-action=restore]");
  }

  async #restore(project: ListedProject): Promise<void> {
    await this.editor.projects.restore(project);
    await this.#focus(project.id, ".open");
  }

  async #focus(id: string, selector: string): Promise<HTMLElement | null> {
    await this.updateComplete;
    const element = this.renderRoot.querySelector<HTMLElement>(`[data-project="${id}"] ${selector}`);
    element?.focus();
    return element;
  }

  #open({ id, open }: ListedProject): void {
    this.#close();
    if (open !== "here") void this.editor.projects.open(id);
  }

  readonly #create = (): void => {
    this.#close();
    this.dispatchEvent(new CustomEvent("create"));
  };

  readonly #close = (): void => this.#dialog?.close();

  readonly #closed = (): void => {
    this.shown = false;
    this.renaming = null;
    void this.editor.projects.sweep();
  };
}
customElements.define("tc-projects-dialog", ProjectsDialog);

function action(name: string, label: string, node: Parameters<typeof icon>[0], run: () => void): TemplateResult {
  return html`
    <button class="icon" data-action=${name} aria-label=${label} title=${label} @click=${run}>${icon(node)}</button>
  `;
}

function picture({ thumbnail }: ListedProject): TemplateResult {
  return html`<span class="picture">${thumbnail ? html`<img src=${thumbnail} alt="" draggable="false" />` : icon(Image)}</span>`;
}

function aboutOf({ layers, modelTitle, size, modified }: ListedProject, strings: Strings): string {
  const { projects: words, numbers } = strings;
  return [words.layers(layers), modelTitle, words.megabytes(megabytes(size)), numbers.moment(modified)].join(" · ");
}

declare global {
  interface HTMLElementTagNameMap {
    "tc-projects-dialog": ProjectsDialog;
  }
}
