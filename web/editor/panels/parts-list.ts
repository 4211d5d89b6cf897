/** The model's parts: shown or hidden, alone or with the others. What is hidden is out of the pointer's way, and no more. */
import { css, html, nothing, type TemplateResult } from "lit";
import { Eye, EyeOff, Focus } from "lucide";
import type { ModelPart } from "../../viewer/viewer-api.ts";
import type { EditorState } from "../state/editor-state.ts";
import { letterOf } from "../state/letter-key.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";

export class PartsList extends EditorElement {
  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: var(--space-1);
      }
      .head {
        display: flex;
        align-items: center;
        gap: var(--space-2);
      }
      .head p {
        flex: 1;
        color: var(--text-quiet);
        font-size: var(--text-small);
        line-height: 1.4;
      }
      .head button {
        flex: none;
      }
      ul {
        max-height: 22rem;
        margin: 0 calc(-1 * var(--space-2));
        padding: 0;
        overflow: auto;
        list-style: none;
        scrollbar-width: thin;
      }
      li button:focus-visible {
        outline-offset: -2px;
      }
      li {
        display: grid;
        grid-template-columns: auto minmax(0, 1fr) auto;
        align-items: center;
        border-radius: var(--radius);
      }
      li.chosen {
        background: var(--accent-soft);
      }
      li.off .name {
        color: var(--text-quiet);
      }
      li.group {
        margin-block-start: var(--space-1);
      }
      li.group .name {
        color: var(--text-quiet);
        font-size: var(--text-small);
        font-weight: 550;
      }
      li.inside {
        padding-inline-start: var(--space-4);
      }
      .name {
        justify-content: start;
        gap: var(--space-2);
        min-width: 0;
        padding-inline: var(--space-1);
        text-align: start;
      }
      .name span {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      .isolate {
        opacity: 0;
      }
      li:hover .isolate,
      li:focus-within .isolate,
      li.chosen .isolate {
        opacity: 1;
      }
      @media (pointer: coarse) {
        .isolate {
          opacity: 1;
        }
      }
    `,
  ];

  get #words(): Strings["modelParts"] {
    return this.strings.modelParts;
  }

  protected watched({ shown, model }: EditorState): readonly unknown[] {
    return [shown, model];
  }

  override render(): TemplateResult {
    const { parts, hidden } = this.state.shown;
    const groups = [...new Set(parts.map(({ group }) => group))].sort(
      (a, b) => Number(a !== null) - Number(b !== null),
    );
    return html`
      <div class="head">
        <p>${hidden.size > 0 ? this.#words.hiddenCount(hidden.size, parts.length) : this.#words.note}</p>
        <button class="outlined" id="show-all-parts" aria-disabled=${hidden.size === 0} @click=${() => hidden.size === 0 || this.editor.views.showAllParts()}>
          ${this.#words.showAll}
        </button>
      </div>
      <ul aria-label=${this.#words.list} @keydown=${this.#key}>
        ${groups.map((group) => {
          const members = parts.filter((part) => part.group === group);
          return html`
            ${group === null ? nothing : this.#group(group, members)}
            ${members.map((part) => this.#part(part, group !== null))}
          `;
        })}
      </ul>
    `;
  }

  #group(name: string, members: readonly ModelPart[]): TemplateResult {
    const { hidden } = this.state.shown;
    const shown = members.every(({ id }) => !hidden.has(id));
    const label = shown ? this.#words.hide(name) : this.#words.show(name);
    return html`
      <li class="group">
        <button class="icon" data-group=${name} aria-pressed=${nothing} aria-label=${label} title=${label} @click=${() => this.editor.views.toggleGroup(name)}>
          ${icon(shown ? Eye : EyeOff)}
        </button>
        <span class="name">${name}</span>
      </li>
    `;
  }

  #part({ id, name, material }: ModelPart, inside: boolean): TemplateResult {
    const { model, shown } = this.state;
    const { views } = this.editor;
    const off = shown.hidden.has(id);
    const chosen = shown.chosen === id;
    const title = name || this.#words.unnamed(id + 1);
    const own = model?.info.materials.find(({ index }) => index === material);
    const eye = off ? this.#words.show(title) : this.#words.hide(title);
    return html`
      <li class=${`${off ? "off" : ""} ${chosen ? "chosen" : ""} ${inside ? "inside" : ""}`} data-part=${id}>
        <button class="icon eye" aria-label=${eye} title=${eye} @click=${() => views.togglePart(id)}>${icon(off ? EyeOff : Eye)}</button>
        <button
          class="name"
          aria-pressed=${nothing}
          aria-current=${chosen ? "true" : nothing}
          title=${this.#words.choose(title, own ? this.strings.materialName(own.index, own.name) : "")}
          @click=${() => views.choosePart(chosen ? null : id)}
        >
          <span>${title}</span>${off ? html`<span class="visually-hidden">${this.#words.hiddenNote}</span>` : nothing}
        </button>
        <button class="icon isolate" aria-label=${this.#words.isolate(title)} title=${this.#words.isolate(title)} @click=${() => views.isolatePart(id)}>
          ${icon(Focus)}
        </button>
      </li>
    `;
  }

  /** Up and down go from name to name; H hides, I shows alone. */
  #key(event: KeyboardEvent): void {
    const row = (event.composedPath()[0] as HTMLElement).closest<HTMLElement>("li[data-part]");
    if (!row || event.ctrlKey || event.metaKey || event.altKey) return;
    const rows = [...this.renderRoot.querySelectorAll<HTMLElement>("li[data-part]")];
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const id = Number(row.dataset.part);
    if (step !== undefined) {
      rows[(rows.indexOf(row) + step + rows.length) % rows.length]?.querySelector<HTMLElement>(".name")?.focus();
    } else if (letterOf(event) === "h") this.editor.views.togglePart(id);
    else if (letterOf(event) === "i") this.editor.views.isolatePart(id);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
customElements.define("tc-parts-list", PartsList);
