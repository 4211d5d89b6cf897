/** The shop mode's face: the view with its few tools, what is on the product, the fields of what is chosen, and the way out. */
import { html, nothing, type TemplateResult } from "lit";
import type { DesignLayer } from "../../editor/document/design.ts";
import { icon } from "../../editor/ui/icon.ts";
import type { ModeHost } from "../mode.ts";
import { FirstTouch } from "./first-touch.ts";
import { ImagePlus, Maximize, Redo2, Type, Undo2 } from "./icons.ts";
import type { ShopBench } from "./shop-bench.ts";
import type { ShopProduct } from "./shop-product.ts";
import { shopStyles } from "./shop-styles.ts";
import type { ShopTools } from "./shop-tools.ts";

export class ShopView {
  static readonly styles = [shopStyles];
  readonly #host: ModeHost;
  readonly #product: ShopProduct;
  /** How often each is under way: a picture takes seconds until it is on the product, and a shop's say on it minutes. */
  readonly #underWay = { pictures: 0, text: 0, submit: 0 };
  #dropping = false;
  #open = false;
  /** Somebody touched it before it was open. */
  #awaited = false;
  readonly #firstTouch: FirstTouch;
  #bench: ShopBench | null = null;
  #takingBench: Promise<ShopBench> | null = null;
  #tools: ShopTools | null = null;
  #takingTools: Promise<ShopTools> | null = null;
  /** Keys that came before what they are for. */
  #keys: { readonly target: EventTarget; readonly event: KeyboardEvent }[] = [];

  constructor(host: ModeHost, product: ShopProduct) {
    this.#host = host;
    this.#product = product;
    this.#firstTouch = new FirstTouch(product.viewer.element, this.#touched);
  }

  /** Null while there is nothing to work on. */
  get bench(): ShopBench | null {
    return this.#bench;
  }

  render(): TemplateResult {
    const host = this.#host;
    const { readonly } = host.hooks.settings();
    return html`
      <div
        class="shop"
        lang=${host.words.lang}
        ?data-alone=${readonly}
        @focusin=${this.#touched}
        @pointerenter=${this.#touched}
        @keydown=${this.#key}
        @dragover=${this.#dragOver}
        @dragleave=${this.#dragLeave}
        @drop=${this.#drop}
      >
        <div class="stage" part="stage">
          ${host.view}
          <div class="bar" part="toolbar">
            ${this.#viewTools(readonly)}
            <slot name="toolbar"></slot>
          </div>
          ${this.#bench?.legend()}
          ${this.#dropping ? html`<div class="own drop">${host.words.drop}</div>` : nothing}
        </div>
        ${readonly ? nothing : this.#panel()}
      </div>
    `;
  }

  /** The product is shown: from now on a touch brings what it needs. */
  opened(): void {
    this.#open = true;
    if (this.#awaited) this.#touched();
  }

  /** Loads what a design is worked on with, if nobody did yet. */
  takeBench(): Promise<ShopBench> {
    this.#takingBench ??= this.#loadBench().catch((thrown: unknown) => {
      this.#takingBench = null;
      throw thrown;
    });
    return this.#takingBench;
  }

  /** Loads what puts things on the product, and what takes hold of it, if nobody did yet. */
  takeTools(): Promise<ShopTools> {
    this.#takingTools ??= this.#loadTools().catch((thrown: unknown) => {
      this.#takingTools = null;
      throw thrown;
    });
    return this.#takingTools;
  }

  close(): void {
    this.#firstTouch.stop();
  }

  async #loadBench(): Promise<ShopBench> {
    const { ShopBench } = await import("./shop-bench.ts");
    const product = this.#product;
    const host = this.#host;
    product.checkOpen();
    const bench = new ShopBench(product, host);
    this.#bench = bench;
    host.adopt(ShopBench.styles);
    // What was opened with a design is begun with it.
    if (this.#open && product.open) bench.desk.begin(product.open);
    host.requestUpdate();
    return bench;
  }

  async #loadTools(): Promise<ShopTools> {
    const loading = import("./shop-tools.ts");
    // Side by side with the desk, which takes hold of the view.
    const early = import("../../viewer/decal-viewer.ts");
    for (const each of [loading, early]) each.catch(() => undefined);
    const { desk } = await this.takeBench();
    const [viewer, { ShopTools }] = await Promise.all([desk.takeHands(), loading]);
    const tools = new ShopTools(desk);
    this.#tools = tools;
    this.#host.requestUpdate();
    this.#firstTouch.giveTo(viewer);
    for (const { target, event } of this.#keys) target.dispatchEvent(new KeyboardEvent("keydown", event));
    this.#keys = [];
    return tools;
  }

  readonly #touched = (): void => {
    this.#awaited = true;
    if (!this.#open || this.#takingTools !== null || this.#product.closed) return;
    this.takeTools().catch((thrown: unknown) => this.#product.fail(thrown));
  };

  #viewTools(readonly: boolean): TemplateResult {
    const { words } = this.#host;
    const desk = this.#bench?.desk;
    const { undoLabel = null, redoLabel = null } = desk?.store.state ?? {};
    return html`
      <div class="own tools">
        ${
          readonly
            ? nothing
            : html`
                ${this.#tool("undo", words.undo, icon(Undo2), undoLabel === null, () => void desk?.step(-1))}
                ${this.#tool("redo", words.redo, icon(Redo2), redoLabel === null, () => void desk?.step(1))}
              `
        }
        ${this.#bench?.heatSwitch()}
        ${this.#tool("fit", words.fit, icon(Maximize), false, () => this.#product.viewer.frameModel())}
      </div>
    `;
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

  #panel(): TemplateResult {
    const { words, hooks } = this.#host;
    const bench = this.#bench;
    const { maxDecals } = hooks.settings();
    const full = (bench?.desk.room ?? maxDecals ?? 1) <= 0;
    const selected = bench?.desk.selected;
    const underWay = this.#underWay;
    const note = full ? words.full(maxDecals ?? 0) : underWay.pictures > 0 ? words.submitting : "";
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
            aria-disabled=${full || underWay.text > 0}
            @click=${() => !full && underWay.text === 0 && this.#attempt(this.#addText())}
          >
            ${icon(Type)} ${words.addText}
          </button>
        </div>
        <div class="own scroll" part="list">
          ${note && html`<p class="quiet" role="status">${note}</p>`}
          ${
            bench?.hasLayers
              ? bench.rows({ select: this.#select, remove: this.#remove })
              : html`<slot name="empty">
                  <div class="empty" part="empty">
                    <h2>${words.emptyTitle}</h2>
                    <p>${words.emptyBody}</p>
                  </div>
                </slot>`
          }
          ${selected ? this.#fields(selected) : nothing} ${selected ? bench?.findings(selected.id) : nothing}
        </div>
        <div class="own foot" part="foot">
          ${bench?.verdict()}
          <button
            class="filled"
            part="button submit-button"
            data-act="submit"
            aria-disabled=${underWay.submit > 0}
            @click=${() => underWay.submit === 0 && this.#attempt(this.#submit())}
          >
            <slot name="submit">${underWay.submit > 0 ? words.submitting : words.submit}</slot>
          </button>
        </div>
      </section>
    `;
  }

  #fields(layer: DesignLayer): TemplateResult | typeof nothing {
    const desk = this.#bench?.desk;
    if (this.#tools === null) this.#touched();
    if (!desk || this.#tools === null) return nothing;
    return this.#tools.fields({ host: this.#host, desk, printScale: desk.zones?.printScale ?? 1 }, layer);
  }

  readonly #select = (layer: DesignLayer): void => {
    const desk = this.#bench?.desk;
    if (!desk) return;
    desk.select(desk.store.state.selectedId === layer.id ? null : layer.id);
    if (desk.selected) desk.hooks.announce(this.#host.words.announce.selected(layer.name));
  };

  readonly #remove = (layer: DesignLayer): void => {
    try {
      this.#bench?.desk.remove(layer.id);
    } catch (thrown) {
      this.#host.tell(thrown);
    }
  };

  #attempt(work: Promise<unknown>): void {
    this.#host.dismiss();
    work.catch((thrown: unknown) => this.#host.tell(thrown));
  }

  #upload(): void {
    const pick = (tools: ShopTools): void => tools.pickPictures((files) => this.#attempt(this.#bring(tools, files)));
    // Browsers open a file dialog only right after a press.
    if (this.#tools) pick(this.#tools);
    else this.#attempt(this.takeTools().then(pick));
  }

  #bring(tools: ShopTools, ...files: Parameters<ShopTools["addFiles"]>): Promise<void> {
    return this.#during("pictures", () => tools.addFiles(...files));
  }

  /** Tools and fonts may take long to come: pressed again meanwhile, it is still one text. */
  async #addText(): Promise<void> {
    const host = this.#host;
    await this.#during("text", async () => (await this.takeTools()).texts.add(host.words.sampleText));
    // The field is there with the next render.
    requestAnimationFrame(() => {
      const field = (host.view.getRootNode() as ShadowRoot).querySelector("textarea");
      field?.focus();
      field?.select();
    });
  }

  async #submit(): Promise<void> {
    await this.#during("submit", () => this.#host.submit());
  }

  /** Shows that it is under way for as long as it is. */
  async #during<T>(what: "pictures" | "text" | "submit", act: () => Promise<T>): Promise<T> {
    this.#underWay[what]++;
    this.#host.requestUpdate();
    try {
      return await act();
    } finally {
      this.#underWay[what]--;
      this.#host.requestUpdate();
    }
  }

  readonly #key = (event: KeyboardEvent): void => {
    if (this.#tools !== null) {
      if (this.#tools.key(event)) event.preventDefault();
      return;
    }
    const [target] = event.composedPath();
    if (!this.#open || target === undefined || event.key === "Tab") return;
    this.#keys.push({ target, event });
    // The page would scroll under a view that is about to turn.
    if (target === this.#product.viewer.element && event.key.startsWith("Arrow")) event.preventDefault();
    this.#touched();
  };

  readonly #dragOver = (event: DragEvent): void => {
    const carriesFiles = event.dataTransfer?.types.includes("Files") === true;
    if (!carriesFiles || this.#host.hooks.settings().readonly) return;
    event.preventDefault();
    this.#touched();
    if (!this.#dropping) {
      this.#dropping = true;
      this.#host.requestUpdate();
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
    const at = { x: event.clientX, y: event.clientY };
    this.#attempt(this.takeTools().then((tools) => this.#bring(tools, files, at)));
  };

  #endDrop(): void {
    this.#dropping = false;
    this.#host.requestUpdate();
  }
}
