/** The shop mode's face: the view with its few tools, what is on the product, the fields of what is chosen, and the way out. */
import { html, nothing, type TemplateResult } from "lit";
import { ImagePlus, Maximize, Redo2, ScanEye, Type, Undo2 } from "lucide";
import type { DesignLayer } from "../../editor/document/design.ts";
import { carriesFiles } from "../../editor/files/file-collection.ts";
import { ACCEPT, pickFiles } from "../../editor/ui/file-picker.ts";
import { icon } from "../../editor/ui/icon.ts";
import type { Desk } from "../desk/desk.ts";
import { addPicture } from "../desk/placing.ts";
import type { Texts } from "../desk/texts.ts";
import type { ModeHost } from "../mode.ts";
import { badgeStyles } from "./badge-styles.ts";
import { HeatMap } from "./heat-map.ts";
import { layerFields } from "./layer-fields.ts";
import { layerRows } from "./layer-rows.ts";
import { layerFindings, verdict } from "./print-badges.ts";
import { handleKey } from "./shop-keys.ts";
import { shopStyles } from "./shop-styles.ts";

export class ShopView {
  static readonly styles = [badgeStyles, shopStyles];
  readonly desk: Desk;
  readonly texts: Texts;
  readonly host: ModeHost;
  readonly #view: HTMLElement;
  readonly #heat: HeatMap;
  #busy = false;
  #dropping = false;

  constructor(host: ModeHost, desk: Desk, texts: Texts) {
    this.host = host;
    this.desk = desk;
    this.texts = texts;
    this.#view = host.view;
    this.#heat = new HeatMap(desk, () => host.requestUpdate());
    desk.store.subscribe(() => host.requestUpdate());
  }

  render(): TemplateResult {
    const { desk, host } = this;
    const { readonly } = desk.settings;
    return html`
      <div
        class="shop"
        ?data-alone=${readonly}
        @keydown=${this.#key}
        @dragover=${this.#dragOver}
        @dragleave=${this.#dragLeave}
        @drop=${this.#drop}
      >
        <div class="stage" part="stage">
          ${this.#view}
          <div class="bar" part="toolbar">
            ${this.#tools(readonly)}
            <slot name="toolbar"></slot>
          </div>
          ${this.#heat.shown ? this.#legend() : nothing}
          ${this.#dropping ? html`<div class="own drop">${host.words.drop}</div>` : nothing}
        </div>
        ${readonly ? nothing : this.#panel()}
      </div>
    `;
  }

  #tools(readonly: boolean): TemplateResult {
    const { desk } = this;
    const { words } = this.host;
    const { undoLabel, redoLabel } = desk.store.state;
    const step = (by: 1 | -1): void => void this.desk.travel(by);
    return html`
      <div class="own tools" role="toolbar" aria-label=${words.panel}>
        ${
          readonly
            ? nothing
            : html`
                ${this.#tool("undo", words.undo, icon(Undo2), undoLabel === null, () => step(-1))}
                ${this.#tool("redo", words.redo, icon(Redo2), redoLabel === null, () => step(1))}
              `
        }
        ${desk.zones === null ? nothing : this.#heatSwitch()}
        ${this.#tool("fit", words.fit, icon(Maximize), false, () => this.desk.viewer.frameModel())}
      </div>
    `;
  }

  #heatSwitch(): TemplateResult {
    const { words } = this.host;
    const label = this.#heat.shown ? words.heatMapOff : words.heatMap;
    return html`<button
      class="icon"
      part="button heat-button"
      data-act="heat"
      aria-pressed=${this.#heat.shown}
      aria-label=${label}
      title=${label}
      @click=${() => this.#attempt(this.#heat.toggle())}
    >
      ${icon(ScanEye)}
    </button>`;
  }

  #tool(name: string, label: string, face: TemplateResult, disabled: boolean, act: () => void): TemplateResult {
    return html`<button
      class="icon"
      part=${`button ${name}-button`}
      data-act=${name}
      aria-label=${label}
      title=${label}
      aria-disabled=${disabled}
      @click=${() => !disabled && act()}
    >
      ${face}
    </button>`;
  }

  #legend(): TemplateResult {
    const { good, least } = this.host.words.heatLegend;
    return html`<div class="own legend"><span class="good">${good}</span><span class="bad">${least}</span></div>`;
  }

  #panel(): TemplateResult {
    const { desk, host } = this;
    const { words } = host;
    const full = desk.room <= 0;
    const { design, selectedId } = desk.store.state;
    const selected = desk.selected;
    return html`
      <section class="panel" part="panel" aria-label=${words.panel}>
        <div class="own add" part="add">
          <button
            class="filled"
            part="button upload-button"
            data-act="upload"
            aria-disabled=${full}
            @click=${() => !full && this.#upload()}
          >
            ${icon(ImagePlus)} ${words.addPicture}
          </button>
          <button
            class="outlined"
            part="button text-button"
            data-act="text"
            aria-disabled=${full}
            @click=${() => !full && this.#attempt(this.#addText())}
          >
            ${icon(Type)} ${words.addText}
          </button>
        </div>
        <div class="own scroll" part="list">
          ${full ? html`<p class="quiet" role="status">${words.full(desk.settings.maxDecals ?? 0)}</p>` : nothing}
          ${
            design.layers.length === 0
              ? html`<slot name="empty">
                  <div class="empty" part="empty">
                    <h2>${words.emptyTitle}</h2>
                    <p>${words.emptyBody}</p>
                  </div>
                </slot>`
              : layerRows(this, design, selectedId)
          }
          ${selected ? layerFields(this, selected) : nothing} ${selected ? layerFindings(desk, selected.id, words) : nothing}
        </div>
        <div class="own foot" part="foot">
          ${verdict(desk, words)}
          <button
            class="filled"
            part="button submit-button"
            data-act="submit"
            aria-disabled=${this.#busy}
            @click=${() => !this.#busy && this.#attempt(this.#submit())}
          >
            <slot name="submit">${this.#busy ? words.submitting : words.submit}</slot>
          </button>
        </div>
      </section>
    `;
  }

  /** Printed metres a metre of the model. */
  get printScale(): number {
    return this.desk.zones?.printScale ?? 1;
  }

  select(layer: DesignLayer): void {
    const { words } = this.host;
    this.desk.select(this.desk.store.state.selectedId === layer.id ? null : layer.id);
    if (this.desk.selected) this.desk.hooks.announce(words.announce.selected(layer.name));
  }

  remove(layer: DesignLayer): void {
    try {
      this.desk.remove(layer.id);
    } catch (thrown) {
      this.host.tell(thrown);
    }
    // The row that had the focus is gone.
    this.desk.viewer.element.focus({ preventScroll: true });
  }

  #attempt(work: Promise<unknown>): void {
    this.host.dismiss();
    work.catch((thrown: unknown) => this.host.tell(thrown));
  }

  #upload(): void {
    pickFiles({ accept: ACCEPT.picture }, (files) => {
      this.#attempt(this.#addAll(files.map(({ file }) => file)));
    });
  }

  async #addAll(files: readonly File[], at: { x: number; y: number } | null = null): Promise<void> {
    const hit = at && this.desk.viewer.surfaceAtPointer(at.x, at.y);
    for (const file of files) await addPicture(this.desk, file, {}, files.length === 1 ? hit : null);
  }

  async #addText(): Promise<void> {
    await this.texts.add(this.host.words.sampleText);
    this.host.requestUpdate();
    // The field is there with the next render.
    requestAnimationFrame(() => {
      const root = this.#view.getRootNode();
      const field = root instanceof ShadowRoot ? root.querySelector<HTMLTextAreaElement>("textarea") : null;
      field?.focus();
      field?.select();
    });
  }

  async #submit(): Promise<void> {
    this.#busy = true;
    this.host.requestUpdate();
    try {
      await this.host.submit();
    } finally {
      this.#busy = false;
      this.host.requestUpdate();
    }
  }

  readonly #key = (event: KeyboardEvent): void => {
    if (handleKey(event, this.desk)) event.preventDefault();
  };

  readonly #dragOver = (event: DragEvent): void => {
    if (!carriesFiles(event.dataTransfer) || this.desk.settings.readonly) return;
    event.preventDefault();
    if (!this.#dropping) {
      this.#dropping = true;
      this.host.requestUpdate();
    }
  };

  readonly #dragLeave = (event: DragEvent): void => {
    const inside = event.relatedTarget instanceof Node && (event.currentTarget as Node).contains(event.relatedTarget);
    if (!inside) this.#endDrop();
  };

  readonly #drop = (event: DragEvent): void => {
    this.#endDrop();
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length === 0) return;
    event.preventDefault();
    this.#attempt(this.#addAll(files, { x: event.clientX, y: event.clientY }));
  };

  #endDrop(): void {
    this.#dropping = false;
    this.host.requestUpdate();
  }
}
