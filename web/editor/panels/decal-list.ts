/**
 * The layers, the topmost first. A row is chosen with click or arrow keys, reordered by its grip, by Alt and the
 * arrows, or by its buttons.
 */
import { css, html, nothing, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { repeat } from "lit/directives/repeat.js";
import { ArrowDown, ArrowUp, Copy, Eye, EyeOff, GripVertical, type IconNode, Trash } from "lucide";
import { BLEND_MODES, type BlendMode, type DesignLayer } from "../document/index.ts";
import type { EditorState } from "../state/editor-state.ts";
import { strings } from "../strings.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import { controls } from "../ui/theme.ts";
import { thumbnail, thumbnailStyles } from "../ui/thumbnail.ts";

const words = strings.decals;

interface RowDrag {
  readonly id: string;
  readonly pointer: number;
  /** Row (from the top) before which the layer would be put. */
  readonly slot: number;
}

export class DecalList extends EditorElement {
  static override properties = { drag: { state: true } };
  declare drag: RowDrag | null;

  static override styles = [
    controls,
    thumbnailStyles,
    css`
      .header {
        display: flex;
        align-items: center;
        min-height: var(--target);
      }
      .header h2 {
        flex: 1;
      }
      ul {
        margin: var(--space-1) calc(-1 * var(--space-2)) 0;
        user-select: none;
        padding: 0;
        list-style: none;
      }
      li {
        position: relative;
        display: grid;
        grid-template-columns: auto minmax(0, 1fr) auto;
        align-items: center;
        border-radius: var(--radius);
      }
      li:hover {
        background: var(--hover);
      }
      li.selected {
        background: var(--accent-soft);
      }
      li.dragged {
        opacity: 0.5;
      }
      li.slot::before,
      li.slot-after::after {
        content: "";
        position: absolute;
        z-index: 1;
        inset-inline: 0;
        inset-block-start: -1px;
        height: 2px;
        border-radius: 1px;
        background: var(--accent);
      }
      li.slot-after::after {
        inset-block: auto -1px;
      }
      .empty {
        line-height: 1.45;
      }
      .grip {
        display: grid;
        place-items: center;
        width: 20px;
        min-height: 40px;
        color: var(--line-strong);
        cursor: grab;
        touch-action: none;
        opacity: 0;
      }
      li:hover .grip,
      li.selected .grip {
        opacity: 1;
      }
      @media (pointer: coarse) {
        .grip {
          width: 32px;
          opacity: 1;
        }
      }
      .row {
        justify-content: start;
        gap: var(--space-3);
        min-width: 0;
        min-height: 44px;
        padding: 0;
        background: none;
        text-align: start;
      }
      .row span {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      .selected .row {
        font-weight: 550;
      }
      .off .row {
        color: var(--text-quiet);
      }
      .off .thumbnail {
        opacity: 0.45;
      }
      .actions {
        display: flex;
        align-items: center;
        padding-inline-end: 2px;
      }
      .actions select {
        field-sizing: content;
        max-width: 6.25rem;
        color: var(--text-quiet);
        background: none;
        font-size: var(--text-small);
        cursor: pointer;
      }
    `,
  ];

  constructor() {
    super();
    this.drag = null;
  }

  protected watched({ design, selectedId, model }: EditorState): readonly unknown[] {
    return [design.assets, selectedId, model === null, ...design.layers.flatMap(shownOf)];
  }

  override render(): TemplateResult {
    const { design, model } = this.state;
    const layers = design.layers.toReversed();
    return html`
      <div class="header" @keydown=${this.#reorderKey}>
        <h2>${words.title}</h2>
        ${this.#actions()}
      </div>
      ${layers.length === 0 ? html`<p class="quiet empty">${model ? words.emptyBody : words.emptyWithoutModel}</p>` : nothing}
      <ul aria-label=${words.list} @keydown=${this.#key} ?hidden=${layers.length === 0}>
        ${repeat(
          layers,
          ({ id }) => id,
          (layer, index) => this.#row(layer, index, layers.length),
        )}
      </ul>
    `;
  }

  #row(layer: DesignLayer, index: number, count: number): TemplateResult {
    const { id, name, visible } = layer;
    const selected = id === this.state.selectedId;
    const { decals } = this.editor;
    const classes = [
      selected ? "selected" : "",
      visible ? "" : "off",
      this.drag?.id === id ? "dragged" : "",
      this.drag?.slot === index ? "slot" : "",
      this.drag?.slot === count && index === count - 1 ? "slot-after" : "",
    ];
    const reachable = selected || (index === 0 && this.state.selectedId === null);
    return html`
      <li class=${classes.join(" ").trim()} data-id=${id}>
        <span
          class="grip"
          title=${words.drag(name)}
          @pointerdown=${(event: PointerEvent) => this.#grab(event, id)}
          @pointermove=${this.#move}
          @pointerup=${this.#drop}
          @pointercancel=${() => {
            this.drag = null;
          }}
          >${icon(GripVertical)}</span
        >
        <button
          class="row"
          tabindex=${reachable ? 0 : -1}
          aria-current=${selected ? "true" : nothing}
          aria-label=${[name, words.order(index + 1, count), visible ? "" : words.hiddenNote].filter(Boolean).join(", ")}
          @click=${() => decals.select(id)}
          @dblclick=${() => this.editor.viewer.frameDecal(id)}
        >
          ${thumbnail(this.editor.library, this.state.design, layer)}
          <span>${name}</span>
        </button>
        <div class="actions">
          ${this.#blend(layer)}
          <button
            class="icon"
            data-action="visible"
            aria-pressed=${nothing}
            aria-label=${visible ? words.hide(name) : words.show(name)}
            title=${visible ? words.hide(name) : words.show(name)}
            @click=${() => decals.toggleVisible(id)}
          >
            ${icon(visible ? Eye : EyeOff)}
          </button>
        </div>
      </li>
    `;
  }

  #blend({ id, name, blend }: DesignLayer): TemplateResult {
    const choose = (event: Event): void => {
      const chosen = (event.target as HTMLSelectElement).value as BlendMode;
      this.editor.decals.change(id, { blend: chosen }, strings.steps.change(words.blend));
    };
    return html`
      <select data-action="blend" aria-label=${words.blendOf(name)} title=${words.blend} .value=${live(blend)} @change=${choose}>
        ${BLEND_MODES.map(
          (mode) => html`<option value=${mode} ?selected=${mode === blend}>${words.blendModes[mode]}</option>`,
        )}
      </select>
    `;
  }

  /** What can be done with the selected layer. `place` counts from the bottom, as the design does. */
  #actions(): TemplateResult {
    const { design, selectedId } = this.state;
    const { decals } = this.editor;
    const place = design.layers.findIndex(({ id }) => id === selectedId);
    const { id, name } = design.layers[place] ?? { id: "", name: "" };
    const button = (action: string, label: string, drawing: IconNode, run: () => void, disabled = false) => html`
      <button class="icon" data-action=${action} aria-label=${label} title=${label} aria-disabled=${disabled} @click=${run}>
        ${icon(drawing)}
      </button>
    `;
    if (place < 0) return html``;
    return html`
      ${button("up", words.up(name), ArrowUp, () => decals.move(id, place + 1), place === design.layers.length - 1)}
      ${button("down", words.down(name), ArrowDown, () => decals.move(id, place - 1), place === 0)}
      ${button("duplicate", words.duplicate(name), Copy, () => decals.duplicate(id))}
      ${button("delete", words.remove(name), Trash, () => decals.remove(id))}
    `;
  }

  #key(event: KeyboardEvent): void {
    const step = stepOf(event);
    // A choice keeps its arrows.
    if (step === 0 || event.target instanceof HTMLSelectElement) return;
    if (event.altKey) {
      this.#reorderKey(event);
    } else {
      taken(event);
      const rows = this.state.design.layers.toReversed();
      const index = rows.findIndex(({ id }) => id === this.state.selectedId);
      const next = rows[Math.max(0, Math.min(rows.length - 1, index + step))];
      if (next) this.editor.decals.select(next.id);
    }
    void this.#focusSelected();
  }

  #reorderKey(event: KeyboardEvent): void {
    const step = stepOf(event);
    if (step === 0 || !event.altKey) return;
    taken(event);
    const { design, selectedId } = this.state;
    const place = design.layers.findIndex(({ id }) => id === selectedId);
    if (selectedId !== null) this.editor.decals.move(selectedId, place - step);
  }

  async #focusSelected(): Promise<void> {
    // The state reaches this element a microtask after the command.
    await Promise.resolve();
    await this.updateComplete;
    this.renderRoot.querySelector<HTMLElement>(".selected .row")?.focus();
  }

  #grab(event: PointerEvent, id: string): void {
    if (event.button !== 0) return;
    event.preventDefault();
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.editor.decals.select(id);
    this.drag = { id, pointer: event.pointerId, slot: -1 };
  }

  #move(event: PointerEvent): void {
    if (this.drag?.pointer === event.pointerId) this.drag = { ...this.drag, slot: this.#slotAt(event.clientY) };
  }

  #slotAt(clientY: number): number {
    const rows = [...this.renderRoot.querySelectorAll("li")];
    const below = rows.findIndex((row) => {
      const box = row.getBoundingClientRect();
      return clientY < box.top + box.height / 2;
    });
    return below < 0 ? rows.length : below;
  }

  #drop(event: PointerEvent): void {
    const { drag } = this;
    if (drag?.pointer !== event.pointerId) return;
    this.drag = null;
    const slot = this.#slotAt(event.clientY);
    const rows = this.state.design.layers.toReversed();
    const from = rows.findIndex(({ id }) => id === drag.id);
    const to = slot > from ? slot - 1 : slot;
    this.editor.decals.move(drag.id, rows.length - 1 - to);
  }
}
customElements.define("tc-decal-list", DecalList);

/** What a row reads of its layer: of a decal all but its place, which changes in each frame of a drag. */
function shownOf(layer: DesignLayer): readonly unknown[] {
  if (layer.type !== "decal") return [layer];
  const { id, name, visible, blend, asset } = layer;
  return [id, name, visible, blend, asset];
}

/** Rows down the list; 0 for other keys. */
function stepOf({ key }: KeyboardEvent): number {
  if (key === "ArrowUp") return -1;
  return key === "ArrowDown" ? 1 : 0;
}

/** Neither the page nor the browser, which scrolls by these keys, shall see it. */
function taken(event: KeyboardEvent): void {
  event.preventDefault();
  event.stopPropagation();
}
