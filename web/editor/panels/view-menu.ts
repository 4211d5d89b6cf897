/**
 * A button on the stage that opens the settings of the view: in a small panel beside it, and where one view is seen at a time,
 * which that would cover, in the sheet.
 */
import { css, html, nothing, type TemplateResult } from "lit";
import { Eye } from "lucide";
import { windowOf } from "../../viewer/window-of.ts";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import "./view-settings.ts";

/** Pixels between the panel and its button, and between it and the page's edges. */
const GAP = 4;

export class ViewMenu extends EditorElement {
  static override properties = { open: { state: true } };
  /** Beside its button. */
  declare open: boolean;
  /** The stage that its button stands in, which the splitter makes narrower. */
  #moves: ResizeObserver | null = null;
  #wasInSheet = false;
  #hadSheet = false;
  #seenIn: Window & typeof globalThis = window;

  static override styles = [
    controls,
    css`
      :host {
        position: relative;
        display: block;
      }
      .opener {
        background: color-mix(in oklab, var(--surface), transparent 15%);
      }
      /* In the top layer, as a stage may be narrower than it is; placed by its button. */
      .panel {
        position: fixed;
        inset: auto;
        margin: 0;
        display: grid;
        gap: var(--space-2);
        width: 18.5rem;
        /* Not a popover's own "fit-content", by which a grid is as high as the page in WebKit. */
        height: auto;
        max-width: calc(100vw - 5rem);
        max-height: calc(100dvh - 2 * var(--space-2));
        padding: var(--space-3) var(--space-4);
        overflow: auto;
        overscroll-behavior: contain;
        border: 1px solid var(--line);
        border-radius: var(--radius-large);
        background: var(--surface-high);
        color: inherit;
        box-shadow: var(--shadow);
      }
      @media (pointer: coarse) {
        .panel {
          width: 20.5rem;
          max-width: calc(100vw - 4.25rem);
          padding-inline: var(--space-3);
        }
      }
      @media (forced-colors: active) {
        #view-menu {
          border: 1px solid ButtonBorder;
        }
      }
    `,
  ];

  constructor() {
    super();
    this.open = false;
    this.addEventListener("keydown", this.#key);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#seenIn = windowOf(this);
    this.#seenIn.addEventListener("resize", this.#place);
    this.#moves = new this.#seenIn.ResizeObserver(this.#place);
    const stage = this.getRootNode();
    if (stage instanceof ShadowRoot) this.#moves.observe(stage.host);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#seenIn.removeEventListener("resize", this.#place);
    this.#moves?.disconnect();
    // The view has given its place to the other one.
    this.#inSheet = false;
  }

  /** What was open goes on where it now has its place. */
  override willUpdate(): void {
    if (this.#hasSheet !== this.#hadSheet && (this.open || this.#inSheet)) {
      this.open = !this.#hasSheet;
      this.#inSheet = this.#hasSheet;
    }
    this.#hadSheet = this.#hasSheet;
  }

  override updated(): void {
    this.#place();
    // What had the focus in the sheet went with it.
    if (this.#wasInSheet && !this.#inSheet && this.ownerDocument.activeElement === this.ownerDocument.body)
      this.#opener?.focus();
    this.#wasInSheet = this.#inSheet;
  }

  get #opener(): HTMLElement | null {
    return this.renderRoot.querySelector<HTMLElement>("#view-menu");
  }

  get #inSheet(): boolean {
    return this.state.toolPanel === "view";
  }

  set #inSheet(open: boolean) {
    if (open !== this.#inSheet) this.editor.store.set({ toolPanel: open ? "view" : null });
  }

  get #words(): Strings["views"] {
    return this.strings.views;
  }

  get #hasSheet(): boolean {
    return Boolean(this.state.sheet);
  }

  protected watched({ toolPanel, sheet }: EditorState): readonly unknown[] {
    return [toolPanel === "view", Boolean(sheet)];
  }

  override render(): TemplateResult {
    const shown = this.open || this.#inSheet;
    const toggle = (): void => {
      if (this.#hasSheet) this.#inSheet = !shown;
      else this.open = !shown;
    };
    return html`
      <button
        class="icon opens opener"
        id="view-menu"
        aria-label=${this.#words.menu}
        title=${this.#words.menu}
        aria-expanded=${shown}
        aria-controls=${this.open ? "view-panel" : nothing}
        @click=${toggle}
      >
        ${icon(Eye)}
      </button>
      ${this.open ? this.#panel() : nothing}
    `;
  }

  #panel(): TemplateResult {
    return html`
      <div class="panel" id="view-panel" popover="manual" role="group" aria-label=${this.#words.menu}>
        <h2>${this.#words.menu}</h2>
        <tc-view-settings .editor=${this.editor}></tc-view-settings>
      </div>
    `;
  }

  /** Beside its button, where there is room: towards the model, else to the other side; and within the page. */
  readonly #place = (): void => {
    const panel = this.renderRoot.querySelector<HTMLElement>("#view-panel");
    const opener = this.#opener?.getBoundingClientRect();
    // The view may have given its place to the other one while this was open.
    if (!panel?.isConnected || !opener) return;
    // Where there are no popovers it is shown anyway.
    if (panel.showPopover && !panel.matches(":popover-open")) panel.showPopover();
    const { offsetWidth: width, offsetHeight: height } = panel;
    const [before, after] = [opener.left - GAP - width, opener.right + GAP];
    const rightToLeft = getComputedStyle(this).direction === "rtl";
    const [fitsBefore, fitsAfter] = [before >= GAP, after + width + GAP <= this.#seenIn.innerWidth];
    const left = fitsAfter && (rightToLeft || !fitsBefore) ? after : Math.max(GAP, before);
    panel.style.left = `${left}px`;
    panel.style.top = `${Math.max(GAP, Math.min(opener.top, this.#seenIn.innerHeight - height - GAP))}px`;
  };

  /** Its button too: where the focus stays when it is opened by the pointer. */
  readonly #key = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || !this.open) return;
    event.stopPropagation();
    this.open = false;
    this.#opener?.focus();
  };
}
customElements.define("tc-view-menu", ViewMenu);
