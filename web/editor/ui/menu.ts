/** A button with a menu of actions (WAI-ARIA menu button): arrows, Home, End, Escape, and typing the first letter. */
import { css, html, nothing, type TemplateResult } from "lit";
import { Check, ChevronDown, type IconNode } from "lucide";
import { windowOf } from "../../viewer/window-of.ts";
import { controls } from "./controls.ts";
import { icon } from "./icon.ts";
import { focusedIn } from "./open-field.ts";
import { RemElement } from "./rem-element.ts";

/** Pixels between the menu and its opener, and between it and the page's edges. */
const GAP = 4;

export interface MenuItem {
  readonly label: string;
  readonly hint?: string;
  readonly icon?: IconNode;
  readonly checked?: boolean;
  readonly disabled?: boolean;
  /** Font family that the label is written in. */
  readonly family?: string;
  /** A heading above this item. */
  readonly heading?: string;
  /** A line above this item. */
  readonly separated?: boolean;
  readonly run: () => void;
}

export class Menu extends RemElement {
  /** A fieldset around it that is disabled disables it. */
  static readonly formAssociated = true;
  static override properties = {
    disabled: { state: true },
    label: {},
    kind: {},
    name: {},
    icon: { attribute: false },
    items: { attribute: false },
    alignEnd: { type: Boolean },
    loose: { type: Boolean },
    open: { state: true },
  };
  /** On the button; "" shows the icon alone. */
  declare label: string;
  /** What the label is a name of, before it where there is room. */
  declare kind: string;
  /** Accessible name of button and menu. */
  declare name: string;
  declare icon: IconNode | null;
  declare items: readonly MenuItem[];
  declare alignEnd: boolean;
  /** It has no button, and opens where it is asked for alone. */
  declare loose: boolean;
  declare open: boolean;
  declare disabled: boolean;

  constructor() {
    super();
    this.label = "";
    this.kind = "";
    this.name = "";
    this.icon = null;
    this.items = [];
    this.alignEnd = false;
    this.loose = false;
    this.open = false;
    this.disabled = false;
  }

  formDisabledCallback(disabled: boolean): void {
    this.disabled = disabled;
  }

  static override styles = [
    controls,
    css`
      :host {
        position: relative;
        display: inline-block;
        min-width: 0;
      }
      .opener {
        max-width: 100%;
      }
      .opener span {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      .opener .kind {
        flex: none;
        color: var(--text-quiet);
      }
      @media (max-width: 900px) {
        .opener .kind {
          display: none;
        }
      }
      :host([yielding]) .opener > :first-child {
        display: none;
      }
      /* The smallest phones have no width for even a letter of the name. */
      @media (max-width: 22rem) and (pointer: coarse) {
        :host([yielding]) .opener > * {
          display: none;
        }
        :host([yielding]) .opener > :first-child {
          display: block;
        }
      }
      /* In the top layer, so that no panel that scrolls cuts it off; placed by its opener. */
      [role="menu"] {
        position: fixed;
        inset: auto;
        margin: 0;
        min-width: min(14rem, 92vw);
        max-width: min(22rem, 92vw);
        max-height: max(75dvh, min(22rem, 100dvh - 1rem));
        overflow: auto;
        padding: var(--space-1);
        border: 1px solid var(--line);
        border-radius: var(--radius-large);
        /* Where one that is cut off ends between two items, a shade says that it goes on: what moves with the items covers it at the end. */
        background:
          linear-gradient(var(--surface-high) 40%, transparent) top / 100% 1.5rem no-repeat local,
          linear-gradient(transparent, var(--surface-high) 60%) bottom / 100% 1.5rem no-repeat local,
          linear-gradient(var(--line), transparent) top / 100% 0.75rem no-repeat scroll,
          linear-gradient(transparent, var(--line)) bottom / 100% 0.75rem no-repeat scroll,
          var(--surface-high);
        color: inherit;
        box-shadow: var(--shadow);
      }
      [role^="menuitem"] {
        display: grid;
        grid-template-columns: 1rem 1fr;
        gap: 0 var(--space-2);
        justify-items: start;
        width: 100%;
        min-height: max(var(--target), 32px);
        padding: var(--space-1) var(--space-2);
        text-align: start;
      }
      .hint {
        grid-column: 2;
        color: var(--text-quiet);
        font-size: var(--text-small);
      }
      h3 {
        padding: var(--space-2) var(--space-2) var(--space-1);
      }
      hr {
        margin: var(--space-1) var(--space-2);
        border: 0;
        border-top: 1px solid var(--line);
      }
    `,
  ];

  override render(): TemplateResult {
    return html`
      ${this.loose ? nothing : this.#button()}
      ${this.open ? this.#menu() : nothing}
    `;
  }

  #button(): TemplateResult {
    return html`
      <button
        class=${this.label ? "opener" : "opener icon"}
        aria-haspopup="menu"
        ?disabled=${this.disabled}
        aria-expanded=${this.open}
        aria-label=${this.name}
        title=${this.name}
        @mousedown=${this.#keepOpen}
        @click=${() => (this.open ? this.#close() : this.#show())}
        @keydown=${this.#openerKey}
      >
        ${this.icon ? icon(this.icon) : nothing}
        ${this.label && this.kind ? html`<span class="kind">${this.kind}</span>` : nothing}
        ${this.label ? html`<span>${this.label}</span>${icon(ChevronDown)}` : nothing}
      </button>
    `;
  }

  #menu(): TemplateResult {
    return html`
      <div
        role="menu"
        popover="manual"
        tabindex="-1"
        aria-label=${this.name}
        @keydown=${this.#menuKey}
        @focusout=${this.#leave}
        @mousedown=${(event: Event) => event.preventDefault()}
      >
        ${this.items.map(
          (item) => html`
            ${item.separated ? html`<hr />` : nothing}
            ${item.heading ? html`<h3 role="presentation">${item.heading}</h3>` : nothing}
            <button
              role=${item.checked === undefined ? "menuitem" : "menuitemradio"}
              aria-checked=${item.checked ?? nothing}
              tabindex="-1"
              ?disabled=${item.disabled ?? false}
              @click=${() => this.#choose(item)}
            >
              ${item.checked ? icon(Check) : item.icon ? icon(item.icon) : html`<span></span>`}
              <span .style=${item.family ? `font-family: "${item.family}", var(--font)` : ""}>${item.label}</span>
              ${item.hint ? html`<span class="hint">${item.hint}</span>` : nothing}
            </button>
          `,
        )}
      </div>
    `;
  }

  /** Client pixels that a context menu was asked for at; null: it hangs at its button. */
  #at: { readonly x: number; readonly y: number } | null = null;

  /** What had the focus before it was opened as a context menu, and gets it back. */
  #before: HTMLElement | null = null;

  override focus(options?: FocusOptions): void {
    this.#opener?.focus(options);
  }

  get #opener(): HTMLElement | null {
    return this.renderRoot.querySelector<HTMLElement>(".opener");
  }

  /** Opens it as a context menu. */
  async openAt(x: number, y: number): Promise<void> {
    this.#before = focusedIn(document);
    // One that is open already stands elsewhere.
    this.open = false;
    await this.updateComplete;
    await this.#show(false, { x, y });
  }

  async #show(last = false, at: { readonly x: number; readonly y: number } | null = null): Promise<void> {
    this.open = true;
    this.#at = at;
    await this.updateComplete;
    this.#place();
    const entries = this.#entries();
    const checked = entries.find((entry) => entry.getAttribute("aria-checked") === "true");
    const first = last ? entries.at(-1) : (checked ?? entries[0]);
    (first ?? this.#list)?.focus();
  }

  /** Without the keyboard it would neither hear Escape nor that one goes on elsewhere. */
  override updated(): void {
    this.#follow();
    const focused = this.shadowRoot?.activeElement;
    if (this.open && focused?.matches("[role^=menuitem]:disabled")) (this.#entries()[0] ?? this.#list)?.focus();
  }

  get #list(): HTMLElement | null {
    return this.renderRoot.querySelector<HTMLElement>("[role=menu]");
  }

  /** Below the opener, or above it where there is more room, and within the page. */
  #place(): void {
    const menu = this.#list;
    const opener = this.#at ? DOMRect.fromRect(this.#at) : this.#opener?.getBoundingClientRect();
    if (!menu || !opener) return;
    menu.showPopover?.();
    // Where it stood before it may have had no room for its width.
    menu.style.left = "0";
    const { offsetWidth: width, offsetHeight: height } = menu;
    const below = innerHeight - opener.bottom - GAP;
    const top = height > below && opener.top > below ? opener.top - GAP - height : opener.bottom + GAP;
    const rightToLeft = getComputedStyle(this).direction === "rtl";
    const fromLeft = this.#at ? !rightToLeft : this.alignEnd === rightToLeft;
    const left = fromLeft ? opener.left : opener.right - width;
    menu.style.top = `${Math.max(GAP, Math.min(top, innerHeight - height - GAP))}px`;
    menu.style.left = `${Math.max(GAP, Math.min(left, innerWidth - width - GAP))}px`;
  }

  /** What a window that becomes another moves is there in its frame. */
  readonly #placeAnew = (): void => {
    requestAnimationFrame(() => this.#place());
  };

  /** @internal */
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.open = false;
    this.#follow();
  }

  #follow(): void {
    const page = windowOf(this);
    if (this.open) page.addEventListener("resize", this.#placeAnew);
    else page.removeEventListener("resize", this.#placeAnew);
  }

  #close(): void {
    this.open = false;
    (this.#at ? this.#before : this.#opener)?.focus();
  }

  #choose(item: MenuItem): void {
    this.#close();
    item.run();
  }

  #entries(): HTMLButtonElement[] {
    return [...this.renderRoot.querySelectorAll<HTMLButtonElement>("[role^=menuitem]:not(:disabled)")];
  }

  #openerKey(event: KeyboardEvent): void {
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    event.preventDefault();
    event.stopPropagation();
    void this.#show(event.key === "ArrowUp");
  }

  #menuKey(event: KeyboardEvent): void {
    const entries = this.#entries();
    const focused = entries.indexOf(this.shadowRoot?.activeElement as HTMLButtonElement);
    const go = (index: number): void => entries[(index + entries.length) % entries.length]?.focus();
    const letter = event.key.toLowerCase();
    if (event.key === "ArrowDown") go(focused + 1);
    else if (event.key === "ArrowUp") go(focused - 1);
    else if (event.key === "Home") go(0);
    else if (event.key === "End") go(-1);
    else if (event.key === "Escape") this.#close();
    else if (event.key === "Tab") this.open = false;
    else if (letter.length === 1 && letter !== " ") {
      const after = [...entries.slice(focused + 1), ...entries.slice(0, focused + 1)];
      after.find((entry) => entry.textContent?.trim().toLowerCase().startsWith(letter))?.focus();
    } else return;
    event.stopPropagation();
    if (event.key !== "Tab") event.preventDefault();
  }

  /** Until the click: a press does not lead the keyboard to a button in Safari, but away from the menu, which would open anew. */
  #keepOpen(event: Event): void {
    if (this.open) event.preventDefault();
  }

  #leave(event: FocusEvent): void {
    const next = event.relatedTarget as Node | null;
    if (!next || !this.renderRoot.contains(next)) this.open = false;
  }
}
customElements.define("tc-menu", Menu);

declare global {
  interface HTMLElementTagNameMap {
    "tc-menu": Menu;
  }
}
