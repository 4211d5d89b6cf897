/**
 * The layers as a tree (WAI-ARIA treegrid), the topmost first. Rows are chosen by click or arrow keys, reordered by
 * dragging, by Alt and the arrows, or by buttons; what stands above and below the rows is for all chosen ones. Of thousands of
 * rows only those near the ones in sight are in the document; the others have their places kept.
 */
import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { repeat } from "lit/directives/repeat.js";
import { Ellipsis, Grid2x2Check, Plus } from "lucide";
import { BLEND_MODES, type BlendMode, type DesignLayer } from "../document/index.ts";
import { isLocked } from "../document/layer-tree.ts";
import { layerById } from "../state/design-edits.ts";
import type { EditorState } from "../state/editor-state.ts";
import { type LayerDrop, type LayerRow, layerRows } from "../state/layer-rows.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import type { Menu } from "../ui/menu.ts";
import type { NumberFieldEvent } from "../ui/number-field.ts";
import { readonlyFields } from "../ui/readonly-fields.ts";
import { thumbnailStyles } from "../ui/thumbnail.ts";
import { TypingEnd } from "../ui/typing-end.ts";
import { addItems, barActs, moreItems } from "./layer-acts.ts";
import { LayerDrag, type LayerDragHost } from "./layer-drag.ts";
import { handleLayerKey } from "./layer-keys.ts";
import { layerListStyles } from "./layer-list-styles.ts";
import { INDENT, layerRow, type RowActs } from "./layer-row.ts";
import { FIRST_WINDOW, renderedRows, rowWindow } from "./row-window.ts";
import { ShownRows } from "./shown-rows.ts";

type Looks = Pick<DesignLayer, "blend" | "opacity" | "lockAlpha">;

/** What is shown, and cannot be changed, while no layer is chosen. */
const PLAIN: Looks = { blend: "normal", opacity: 1, lockAlpha: false };

interface HeldRow {
  readonly id: string;
  readonly ids: ReadonlySet<string>;
}

export class LayerList extends EditorElement implements LayerDragHost {
  static override properties = { renaming: { state: true } };
  /** Id of the layer whose name is being typed. */
  declare renaming: string | null;
  rows: readonly LayerRow[] = [];
  readonly indent = INDENT;
  readonly #drag = new LayerDrag(this);
  readonly #shownRows = new ShownRows();
  #window = FIRST_WINDOW;
  readonly #sizes = new ResizeObserver(() => this.#resized());
  /** The list whose size is followed. */
  #sized: HTMLElement | null = null;
  /** Pixels of it that were seen when its size was told last. */
  #height = 0;
  /** The selected layer's row is in sight, and is to stay there when a phone is turned or the list gives way to something else. */
  #seesSelected = false;
  /** The row that the keyboard shall be on after the next render; undefined: where it is. */
  #focusNext: string | undefined;
  /** The row that it was on before this render, and the rows that there were; null: on none. */
  #held: HeldRow | null = null;

  static override styles = [controls, thumbnailStyles, layerListStyles];

  constructor() {
    super();
    new TypingEnd(this);
    this.renaming = null;
  }

  get #words(): Strings["layers"] {
    return this.strings.layers;
  }

  protected watched(state: EditorState): readonly unknown[] {
    const { design, selectedId, selection, collapsed, editingMask, model, material, starting } = state;
    const shown = this.#shownRows.of(layerRows(design, collapsed));
    const { holds } = this.editor.clipboard;
    return [design.assets, selectedId, selection, collapsed, editingMask, model, material, starting, holds, shown];
  }

  get list(): HTMLElement | null {
    return this.renderRoot.querySelector<HTMLElement>(".rows");
  }

  get content(): HTMLElement | null {
    return this.list?.firstElementChild as HTMLElement | null;
  }

  override render(): TemplateResult {
    const { design, collapsed, model, starting, readonly } = this.state;
    const without = starting ? "" : this.#words.emptyWithoutModel;
    this.rows = layerRows(design, collapsed);
    return html`
      ${this.rows.length === 0 ? nothing : readonlyFields(readonly, this.strings.readonly.why, html`${this.#looks()}`)}
      ${this.rows.length === 0 ? html`<p class="quiet empty">${model ? this.#words.emptyBody : without}</p>` : this.#tree()}
      ${model && !readonly ? this.#bar() : nothing}
    `;
  }

  #tree(): TemplateResult {
    const { selectedId, selection, design, editingMask, targets } = this.state;
    const { library, engine } = this.editor;
    const thumbnails = { library, design, engine, targets };
    const { drop, ids } = this.#drag;
    const twists = this.rows.some(({ layer }) => layer.type === "group");
    const reachable = this.rows.find(({ layer }) => layer.id === selectedId) ?? this.rows[0];
    // What the keyboard or a finger is on, or comes to, must not go while the list is scrolled.
    const needed = new Set([reachable?.layer.id, this.#held?.id, this.#focusNext, this.renaming, this.#drag.pressed]);
    const rendered = renderedRows(this.rows, this.#window, ({ layer }) => needed.has(layer.id));
    const chosen = new Set(selection);
    return html`
      <div
        class="rows"
        role="treegrid"
        aria-label=${this.#words.list}
        aria-multiselectable="true"
        aria-rowcount=${this.rows.length}
        @keydown=${this.#key}
        @contextmenu=${this.#contextMenu}
        @scroll=${this.#scrolled}
      >
        <div class="content" role="presentation" .style=${`--rows: ${this.rows.length}`}>
          ${repeat(
            rendered.map((at) => [at, this.rows[at] as LayerRow] as const),
            ([, { layer }]) => layer.id,
            ([at, row]) =>
              layerRow(
                row,
                {
                  at,
                  thumbnails,
                  chosen: chosen.has(row.layer.id),
                  primary: row.layer.id === selectedId,
                  reachable: row === reachable,
                  renaming: row.layer.id === this.renaming,
                  dragged: ids.includes(row.layer.id),
                  into: drop?.gap === null && drop.parentId === row.layer.id,
                  editsMask: editingMask === row.layer.id,
                  twists,
                  words: this.#words,
                  readonly: this.state.readonly,
                },
                this.#acts,
              ),
          )}
          ${drop && drop.gap !== null ? this.#line(drop, drop.gap) : nothing}
        </div>
      </div>
    `;
  }

  #line({ depth }: LayerDrop, gap: number): TemplateResult {
    const start = (depth - 1) * INDENT + 4;
    return html`<div class="line" .style=${`--at: ${gap}; inset-inline-start: ${start}px`}></div>`;
  }

  /**
   * Blending, opacity and locked transparency of what is chosen. Its place is kept while nothing is: if the rows made way for
   * it, the second press of a double click would meet another row than the first, which chose one.
   */
  #looks(): TemplateResult {
    const { selection, design, selectedId } = this.state;
    const layer = layerById(design, selectedId) ?? PLAIN;
    const chosen = selection.map((id) => layerById(design, id)).filter((each) => each !== undefined);
    const disabled = selection.every((id) => isLocked(design, id));
    return html`<div class="looks">
      ${this.#blend(layer, chosen, disabled)}${this.#opacity(layer, disabled)}
      <button
        class="icon"
        data-action="lockAlpha"
        aria-pressed=${layer.lockAlpha}
        aria-label=${this.#words.lockAlpha}
        title=${`${this.#words.lockAlpha}. ${this.#words.lockAlphaHint}`}
        ?disabled=${disabled}
        @click=${() => this.#change({ lockAlpha: !layer.lockAlpha }, this.#words.lockAlpha)}
      >
        ${icon(Grid2x2Check)}
      </button>
    </div>`;
  }

  #blend({ blend }: Looks, chosen: readonly DesignLayer[], disabled: boolean): TemplateResult {
    const same = chosen.every((layer) => layer.blend === blend);
    const choose = (event: Event): void =>
      this.#change({ blend: (event.target as HTMLSelectElement).value as BlendMode }, this.#words.blend);
    return html`
      <select
        data-action="blend"
        aria-label=${this.#words.blend}
        title=${this.#words.blend}
        ?disabled=${disabled}
        .value=${live(same ? blend : "")}
        @change=${choose}
      >
        ${same ? nothing : html`<option value="" disabled selected>${this.#words.mixed}</option>`}
        ${BLEND_MODES.map(
          (mode) =>
            html`<option value=${mode} ?selected=${same && mode === blend}>${this.#words.blendModes[mode]}</option>`,
        )}
      </select>
    `;
  }

  #opacity({ opacity }: Looks, disabled: boolean): TemplateResult {
    const { layers } = this.editor;
    // What is being typed is for those.
    const { selection } = this.state;
    const detail = (event: Event): NumberFieldEvent => (event as CustomEvent<NumberFieldEvent>).detail;
    const change = (event: Event): void => {
      const { value, repeated } = detail(event);
      this.#change({ opacity: value / 100 }, this.#words.opacity, repeated ? "layer-opacity" : undefined, selection);
    };
    return html`<tc-number
      data-field="layer-opacity"
      .label=${this.#words.opacity}
      .name=${this.#words.opacity}
      .unit=${this.strings.properties.percent}
      .value=${Math.round(opacity * 1000) / 10}
      .step=${1}
      .min=${0}
      .max=${100}
      ?disabled=${disabled}
      @field-preview=${(event: Event) => layers.preview(selection, { opacity: detail(event).value / 100 })}
      @field-change=${change}
      @field-cancel=${() => layers.cancelPreview()}
    ></tc-number>`;
  }

  #change(patch: Partial<Looks>, field: string, mergeKey?: string, ids = this.state.selection): void {
    this.editor.layers.change(ids, patch, this.strings.steps.change(field), mergeKey);
  }

  #bar(): TemplateResult {
    const { editor } = this;
    return html`<div class="bar" role="toolbar" aria-label=${this.#words.title} @keydown=${this.#barKey}>
      <tc-menu class="add" .name=${this.#words.add} .icon=${Plus} .items=${addItems(editor)}></tc-menu>
      <span class="gap"></span>
      ${barActs(editor).map(
        ({ action, label, drawing, disabled, run }) => html`<button
          class="icon"
          data-action=${action === "mask" ? "add-mask" : action}
          aria-label=${label}
          title=${label}
          aria-disabled=${disabled}
          @click=${() => disabled || run()}
        >
          ${icon(drawing)}
        </button>`,
      )}
      <tc-menu class="more" .name=${this.#words.more} .icon=${Ellipsis} .items=${moreItems(editor, (id) => this.#acts.startRename(id))} alignEnd></tc-menu>
    </div>`;
  }

  /** Where the keyboard is, before rows are moved, which lets go of it, or taken out. */
  override willUpdate(): void {
    const row = this.shadowRoot?.activeElement?.closest<HTMLElement>(".row");
    this.#held = row ? { id: row.dataset.id ?? "", ids: new Set(this.rows.map(({ layer }) => layer.id)) } : null;
  }

  /** A row that was made for what is chosen now takes the keyboard over, as does any when its own is gone. */
  #follow({ id, ids }: HeldRow): void {
    const { selectedId } = this.state;
    const isNew = selectedId !== this.#shown && selectedId !== null && !ids.has(selectedId);
    const row = this.#rowElement(id);
    if (isNew || !row) this.#focusNext ??= "";
    else if (!row.matches(":focus-within")) row.focus({ preventScroll: true });
  }

  override updated(changed: PropertyValues<this>): void {
    this.#followSize();
    if (this.#held && this.renaming === null) this.#follow(this.#held);
    if (changed.has("renaming") && this.renaming !== null) {
      const field = this.renderRoot.querySelector<HTMLInputElement>("input.name");
      field?.focus();
      field?.select();
    }
    if (this.#focusNext === undefined) {
      this.#keepInSight();
      return;
    }
    const { selectedId } = this.state;
    const row = this.#rowElement(this.#focusNext) ?? this.renderRoot.querySelector<HTMLElement>(".row[tabindex='0']");
    this.#focusNext = undefined;
    this.#shown = selectedId;
    // Where the last row has gone, to what makes the next one.
    (row ?? this.renderRoot.querySelector<Menu>("tc-menu.add"))?.focus({ preventScroll: true });
    this.#bringIntoSight(row);
  }

  #shown: string | null = null;

  /** A layer that was chosen elsewhere, on the model, is shown here. */
  #keepInSight(): void {
    const { selectedId } = this.state;
    if (selectedId === this.#shown) return;
    this.#shown = selectedId;
    if (selectedId !== null) this.#bringIntoSight(this.#rowElement(selectedId));
  }

  /** With the rows around it, in the same frame. */
  #bringIntoSight(row: HTMLElement | null): void {
    row?.scrollIntoView({ block: "nearest" });
    this.#seesSelected ||= row !== null;
    this.#look();
  }

  #resized(): void {
    const height = this.list?.clientHeight ?? 0;
    const hasGivenWay = height !== this.#height;
    this.#height = height;
    const { selectedId } = this.state;
    if (hasGivenWay && height > 0 && this.#seesSelected && selectedId !== null) {
      this.#bringIntoSight(this.#rowElement(selectedId));
    } else this.#look();
  }

  #scrolled(): void {
    const { list } = this;
    // A list that has another height by now is told of below, and what was seen before that counts.
    if (list?.clientHeight === this.#height) {
      const { top, bottom } = list.getBoundingClientRect();
      const row = this.#rowElement(this.state.selectedId ?? "")?.getBoundingClientRect();
      const middle = row && (row.top + row.bottom) / 2;
      this.#seesSelected = middle !== undefined && middle > top && middle < bottom;
    }
    this.#look();
  }

  #followSize(): void {
    if (this.list === this.#sized) return;
    this.#sizes.disconnect();
    this.#sized = this.list;
    if (this.list && this.content) for (const part of [this.list, this.content]) this.#sizes.observe(part);
  }

  /** Renders again where rows have come into sight, or near it, that are not there. */
  #look(): void {
    const { list, content } = this;
    const rowHeight = content ? content.offsetHeight / this.rows.length : 0;
    // Not shown.
    if (!list || rowHeight === 0) return;
    const seen = rowWindow(list.scrollTop / rowHeight, list.clientHeight / rowHeight);
    if (seen.first === this.#window.first && seen.end === this.#window.end) return;
    this.#window = seen;
    this.requestUpdate();
  }

  /** @internal */
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#sizes.disconnect();
    this.#sized = null;
  }

  #rowElement(id: string): HTMLElement | null {
    return this.renderRoot.querySelector<HTMLElement>(`.row[data-id="${CSS.escape(id)}"]`);
  }

  /** The keyboard follows the selected layer, whose row may be a new one; without one, it goes to the list's first. */
  focusSelected(): void {
    this.#focusNext = "";
    this.requestUpdate();
  }

  /** At once where the row is there, so that the next key is for it. */
  #focusRow(id: string): void {
    const row = this.#rowElement(id);
    if (row) {
      row.focus();
      return;
    }
    this.#focusNext = id;
    this.requestUpdate();
  }

  dragged(id: string): readonly string[] {
    const { selection } = this.state;
    if (selection.includes(id)) return selection;
    this.editor.layers.select(id);
    return [id];
  }

  move(ids: readonly string[], { parentId, index }: LayerDrop): void {
    this.editor.layers.move(ids, { parentId, index });
  }

  longPress(id: string): void {
    this.editor.layers.toggleSelected(id);
  }

  readonly #acts: RowActs = {
    press: (event, id, byGrip) => {
      const onControl = (event.target as Element).closest("button, input") !== null;
      if (!onControl && !this.state.readonly) this.#drag.press(event, id, byGrip);
    },
    choose: (event, id) => this.#choose(event, id),
    show: (id) => this.editor.viewer.frameDecal(id),
    startRename: (id) => {
      if (!this.state.readonly) this.renaming = id;
    },
    endRename: (id, name, byKey) => {
      // Leaving the field comes after its key, which has ended it.
      if (this.renaming !== id) return;
      this.renaming = null;
      if (name !== null) this.editor.layers.rename(id, name);
      // Who left it by a press elsewhere is there.
      if (byKey) this.#focusNext = id;
    },
    setCollapsed: (id, collapsed) => this.editor.layers.setCollapsed(id, collapsed),
    editMask: (id, on) => this.editor.layers.editMask(id, on),
    toggleVisible: (id) => this.editor.layers.toggleVisible(this.#withChosen(id)),
    toggleLocked: (id) => this.editor.layers.toggleLocked(this.#withChosen(id)),
  };

  /** A switch of a chosen row is for all that are chosen. */
  #withChosen(id: string): readonly string[] {
    const { selection } = this.state;
    return selection.includes(id) ? [id, ...selection.filter((each) => each !== id)] : [id];
  }

  #choose(event: MouseEvent, id: string): void {
    if (this.#drag.takeClick() || (event.target as Element).closest("input, [data-action=mask]")) return;
    const { layers } = this.editor;
    if (event.shiftKey) layers.selectTo(id);
    else if (event.ctrlKey || event.metaKey) layers.toggleSelected(id);
    else layers.select(id);
  }

  /** By the right button, or by the keyboard, which has no place of its own: then at the row. */
  #contextMenu(event: MouseEvent): void {
    const row = (event.target as Element).closest<HTMLElement>(".row");
    // A finger that is held chooses several.
    if (!row || this.state.readonly || (event as PointerEvent).pointerType === "touch") return;
    event.preventDefault();
    const id = row.dataset.id ?? "";
    if (!this.state.selection.includes(id)) this.editor.layers.select(id);
    const { left, bottom } = row.getBoundingClientRect();
    const byKey = event.clientX === 0 && event.clientY === 0;
    const menu = this.renderRoot.querySelector<Menu>("tc-menu.more");
    void this.updateComplete.then(() =>
      menu?.openAt(byKey ? left + INDENT : event.clientX, byKey ? bottom : event.clientY),
    );
  }

  #key(event: KeyboardEvent): void {
    handleLayerKey(event, {
      layers: this.editor.layers,
      rows: this.rows,
      state: this.state,
      rename: (id) => this.#acts.startRename(id),
      focusSelected: () => this.focusSelected(),
      focusRow: (id) => this.#focusRow(id),
      show: (id) => this.#acts.show(id),
    });
  }

  /** The acts' own keys work from their buttons, too. */
  #barKey(event: KeyboardEvent): void {
    if (!event.altKey || (event.key !== "ArrowUp" && event.key !== "ArrowDown")) return;
    event.preventDefault();
    event.stopPropagation();
    this.editor.layers.step(event.key === "ArrowUp" ? 1 : -1);
  }
}
customElements.define("tc-layer-list", LayerList);
