/**
 * A numeric field: typing, arrow keys, and a label to scrub with the pointer. Emits `field-preview` while a scrub goes
 * on, `field-change` when a value is final, `field-cancel` when a key takes a scrub back; `detail` is a NumberFieldEvent.
 * `field-refused`, which panels let through, tells what may be typed of a number that was not taken: who knows the words for it
 * lets it be heard, and gives them to the field to `explain`.
 */
import { css, html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { takesBack } from "../../viewer/take-back-key.ts";
import { windowOf } from "../../viewer/window-of.ts";
import { RemElement } from "./rem-element.ts";
import { plainControls } from "./theme.ts";
import { typedNumber } from "./typed-number.ts";

export interface NumberFieldEvent {
  readonly value: number;
  /** Set for steps by key, which follow each other fast enough to be one step of the history. */
  readonly repeated: boolean;
}

/** Pixels before a press on the label becomes a scrub. */
const SCRUB_START = 3;
const COARSE = 10;
const FINE = 0.1;
/** Of `field-refused`: what was typed is no number, or none between these, as the field writes them; "": no bound. */
export interface Refusal {
  readonly name: string;
  readonly least: string;
  readonly most: string;
}

/** Pixels between a field and why it is marked, and between that and the page's edges. */
const WHY_GAP = 4;

/** What may take the field away from under that. */
const MOVES = ["scroll", "resize"] as const;

/** Milliseconds that a field is marked at least whose number was not taken. */
const REFUSAL = 5000;

export class NumberField extends RemElement {
  /** A fieldset around it that is disabled disables it. */
  static readonly formAssociated = true;
  static override properties = {
    label: {},
    name: {},
    hint: {},
    unit: {},
    value: { type: Number },
    step: { type: Number },
    min: { type: Number },
    max: { type: Number },
    disabled: { type: Boolean },
    fieldsetDisabled: { state: true },
    why: { state: true },
  };
  /** What is seen: short ("X"). */
  declare label: string;
  /** What is heard: whole ("Position X"). */
  declare name: string;
  declare hint: string;
  declare unit: string;
  declare value: number;
  declare step: number;
  declare min: number;
  declare max: number;
  declare disabled: boolean;
  declare fieldsetDisabled: boolean;
  /** Why what was typed was not taken, while it is told; "": it was. */
  declare why: string;

  #scrub: {
    readonly pointer: number;
    readonly x: number;
    readonly from: number;
    active: boolean;
    value: number;
  } | null = null;
  #typing = false;
  #refusal: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    this.label = "";
    this.name = "";
    this.hint = "";
    this.unit = "";
    this.value = 0;
    this.step = 1;
    this.min = Number.NEGATIVE_INFINITY;
    this.max = Number.POSITIVE_INFINITY;
    this.disabled = false;
    this.fieldsetDisabled = false;
    this.why = "";
  }

  static override styles = [
    plainControls,
    css`
      :host {
        display: block;
        min-width: 0;
        height: var(--target);
        border: 1px solid var(--field-line, transparent);
        border-radius: var(--radius);
        background: var(--surface-low);
        font-size: var(--text-normal);
      }
      :host(:hover) {
        border-color: var(--line);
      }
      /* A number that changes lays out its own field and not the page. The host cannot keep that to itself: as an item of a
         grid it is laid out by the grid. */
      .box {
        display: flex;
        align-items: center;
        height: 100%;
        contain: strict;
      }
      :host(:focus-within) {
        outline: 2px solid var(--accent);
        outline-offset: -1px;
        background: var(--surface);
      }
      :host([refused]) {
        outline: 2px solid var(--danger);
        outline-offset: -1px;
      }
      :host(:disabled) {
        opacity: 0.5;
      }
      label {
        flex: none;
        align-self: stretch;
        display: flex;
        align-items: center;
        padding-inline: var(--space-2) var(--space-1);
        color: var(--text-quiet);
        font-size: var(--text-small);
        cursor: ew-resize;
        -webkit-user-select: none;
        user-select: none;
        touch-action: pan-y;
        white-space: nowrap;
      }
      input[type="text"] {
        flex: 1;
        min-width: 24px;
        min-height: 0;
        align-self: stretch;
        padding: 0;
        padding-inline-end: var(--space-1);
        border: 0;
        outline: 0;
        background: transparent;
        text-align: end;
      }
      input[type="text"]:focus-visible {
        background: transparent;
      }
      input[aria-invalid="true"] {
        color: var(--danger);
      }
      .why {
        position: fixed;
        inset: auto;
        margin: 0;
        /* As wide wherever it stands: it is measured in one place, and put in another. */
        width: max-content;
        max-width: min(16rem, 100vw - 8px);
        overflow-wrap: anywhere;
        padding: var(--space-1) var(--space-2);
        border: 1px solid var(--danger);
        border-radius: var(--radius);
        background: var(--surface);
        color: var(--danger);
        font-size: var(--text-small);
        pointer-events: none;
      }
      .unit {
        display: var(--unit, inline);
        padding-inline-end: var(--space-2);
        color: var(--text-quiet);
        font-size: var(--text-small);
      }
    `,
  ];

  override render(): TemplateResult {
    return html`<div class="box">
      <label
        for="input"
        title=${this.hint || this.name}
        @pointerdown=${this.#press}
        @pointermove=${this.#drag}
        @pointerup=${this.#release}
        @pointercancel=${this.#abandon}
        @lostpointercapture=${this.#release}
        @click=${(event: Event) => event.preventDefault()}
        >${this.label}</label
      >
      <input
        id="input"
        type="text"
        inputmode="decimal"
        role="spinbutton"
        autocomplete="off"
        spellcheck="false"
        aria-label=${this.unit ? `${this.name}, ${this.unit}` : this.name}
        aria-valuenow=${formatNumber(this.value, this.step)}
        aria-valuetext=${`${this.#shown(this.value, this.step)} ${this.unit}`.trim()}
        aria-valuemin=${Number.isFinite(this.min) ? formatNumber(this.min, this.step) : nothing}
        aria-valuemax=${Number.isFinite(this.max) ? formatNumber(this.max, this.step) : nothing}
        ?disabled=${this.#off}
        @input=${this.#type}
        @keydown=${this.#key}
        @focus=${(event: Event) => (event.target as HTMLInputElement).select()}
        @blur=${this.#commitTyped}
      />
      ${this.unit ? html`<span class="unit" aria-hidden="true">${this.unit}</span>` : ""}
    </div>
    ${this.why ? html`<div class="why" popover="manual" aria-hidden="true">${this.why}</div>` : nothing}`;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#accept();
  }

  formDisabledCallback(disabled: boolean): void {
    this.fieldsetDisabled = disabled;
  }

  get #off(): boolean {
    return this.disabled || this.fieldsetDisabled;
  }

  override willUpdate(): void {
    // There is nothing any longer that it could be refused for.
    if (!this.#off || !this.hasAttribute("refused")) return;
    this.#accept();
    this.#show();
  }

  override updated(changed: PropertyValues<this>): void {
    const own = this.#typing || this.#scrub?.active === true;
    if ((changed.has("value") || changed.has("step") || changed.has("name")) && !own) this.#show();
    if (this.why) this.#placeWhy();
  }

  /** Tells beneath the field, for as long as it is marked, why what was typed was not taken. */
  explain(why: string): void {
    if (this.hasAttribute("refused")) this.why = why;
  }

  /** In the page's top layer: what scrolls round the field would cut it off. */
  #placeWhy(): void {
    const tip = this.renderRoot.querySelector<HTMLElement>(".why");
    if (!tip) return;
    // Where there are no popovers it is shown anyway.
    if (tip.showPopover && !tip.matches(":popover-open")) tip.showPopover();
    const { left, top, bottom } = this.getBoundingClientRect();
    const [width, height] = [tip.offsetWidth, tip.offsetHeight];
    const page = windowOf(this);
    // A press elsewhere takes what was typed, and may have scrolled the field away.
    if (bottom < 0 || top > page.innerHeight) {
      this.#hideWhy();
      return;
    }
    const under = bottom + WHY_GAP + height <= page.innerHeight ? bottom + WHY_GAP : top - WHY_GAP - height;
    tip.style.top = `${under}px`;
    tip.style.left = `${Math.max(WHY_GAP, Math.min(left, page.innerWidth - width - WHY_GAP))}px`;
  }

  override focus(): void {
    this.#input?.focus();
  }

  get #input(): HTMLInputElement | null {
    return this.renderRoot.querySelector("input");
  }

  /** As the language writes it that the field stands in. */
  #shown(value: number, step: number): string {
    return formatNumber(value, step).replace(".", this.#point);
  }

  get #point(): "." | "," {
    return this.matches(":lang(de)") ? "," : ".";
  }

  #show(value = this.value): void {
    const input = this.#input;
    if (!input) return;
    input.value = this.#shown(value, this.step);
    const refused = String(this.hasAttribute("refused"));
    if (input.getAttribute("aria-invalid") !== refused) input.setAttribute("aria-invalid", refused);
  }

  #type(): void {
    this.#typing = true;
    this.#input?.setAttribute("aria-invalid", String(this.#typed() === undefined));
  }

  #key(event: KeyboardEvent): void {
    if (event.key === "Enter") {
      this.#commitTyped();
      this.#input?.select();
    } else if (event.key === "Escape" && this.#typing) {
      // With nothing typed it is the page's, which leaves the field.
      event.stopPropagation();
      this.#typing = false;
      this.#show();
      this.#input?.select();
    } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
      event.preventDefault();
      const from = this.#commitTyped() ?? this.value;
      const steps = (event.key === "ArrowUp" ? 1 : -1) * factorOf(event);
      this.#emit("field-change", from + steps * this.step, true);
      this.#input?.select();
    } else if ((event.ctrlKey || event.metaKey) && /^[zy]$/i.test(event.key) && !this.#typing) {
      // Nothing typed that could be undone: the page's own undo is meant.
      event.preventDefault();
      this.dispatchEvent(new KeyboardEvent(event.type, event));
    }
  }

  /** The number that was typed, if one was. */
  #commitTyped(): number | undefined {
    if (!this.#typing) return undefined;
    this.#typing = false;
    const value = this.#typed();
    const outside = value === undefined ? this.#input?.value.trim() !== "" : value < this.min || value > this.max;
    if (value !== undefined && value !== this.value) this.#emit("field-change", value, false);
    if (outside) {
      this.#show();
      this.#refuse();
    } else {
      this.#accept();
      this.#show();
    }
    return value && this.#bounded(value);
  }

  /**
   * What stands there is for a moment marked as not what was typed: it is the number from before where that was none, and the
   * nearest that can be where it was too small or too large.
   */
  #refuse(): void {
    const input = this.#input;
    input?.setAttribute("aria-invalid", "true");
    this.toggleAttribute("refused", true);
    const bound = (value: number): string =>
      Number.isFinite(value) ? `${this.#shown(value, this.step)} ${this.unit}`.trim() : "";
    const detail: Refusal = { name: this.name, least: bound(this.min), most: bound(this.max) };
    this.dispatchEvent(new CustomEvent("field-refused", { detail, bubbles: true, composed: true }));
    clearTimeout(this.#refusal);
    this.#refusal = setTimeout(() => {
      this.#accept();
      if (!this.#typing) input?.setAttribute("aria-invalid", "false");
    }, REFUSAL);
    // What moves under it would leave it behind.
    for (const move of MOVES) windowOf(this).addEventListener(move, this.#hideWhy, { capture: true, passive: true });
  }

  readonly #hideWhy = (): void => {
    this.why = "";
  };

  /** Nothing is refused any longer. */
  #accept(): void {
    clearTimeout(this.#refusal);
    for (const move of MOVES) windowOf(this).removeEventListener(move, this.#hideWhy, { capture: true });
    this.toggleAttribute("refused", false);
    this.why = "";
  }

  /** Undefined where it is none, and where nothing can be so small: what is left of a size of 0 could not be seen. */
  #typed(): number | undefined {
    const value = typedNumber(this.#input?.value ?? "", this.unit, this.#point);
    return value !== undefined && value <= 0 && this.min > 0 ? undefined : value;
  }

  #press(event: PointerEvent): void {
    if (event.button !== 0 || this.#off) return;
    event.preventDefault();
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.#scrub = { pointer: event.pointerId, x: event.clientX, from: this.value, active: false, value: this.value };
    windowOf(this).addEventListener("keydown", this.#takeBack, { capture: true });
  }

  #drag(event: PointerEvent): void {
    const scrub = this.#scrub;
    if (scrub?.pointer !== event.pointerId) return;
    const distance = event.clientX - scrub.x;
    if (!scrub.active && Math.abs(distance) < SCRUB_START) return;
    scrub.active = true;
    scrub.value = this.#bounded(scrub.from + distance * this.step * factorOf(event));
    // At once: the value itself may come back later, by a panel that does not render each frame.
    this.#show(scrub.value);
    this.#emit("field-preview", scrub.value, false);
  }

  #release(event: PointerEvent): void {
    const scrub = this.#scrub;
    if (scrub?.pointer !== event.pointerId) return;
    this.#endScrub();
    if (scrub.active) {
      this.#emit("field-change", scrub.value, false);
      // The value that was made of it is shown, also where that is the one before.
      this.requestUpdate("value", scrub.value);
    } else this.#input?.focus();
  }

  #abandon(): void {
    if (!this.#scrub) return;
    const { from, active } = this.#scrub;
    this.#endScrub();
    if (active) {
      this.#show(from);
      this.#emit("field-cancel", from, false);
    }
  }

  /** The page does not hear of keys meanwhile: it would take back the step before, or delete the layer that is scrubbed. */
  readonly #takeBack = (event: KeyboardEvent): void => {
    event.stopPropagation();
    if (!takesBack(event)) return;
    event.preventDefault();
    this.#abandon();
  };

  #endScrub(): void {
    this.#scrub = null;
    windowOf(this).removeEventListener("keydown", this.#takeBack, { capture: true });
  }

  #bounded(value: number): number {
    // Sums of steps are rounded to what the field shows, so that 0.1 + 0.2 is 0.3 in the saved design.
    const rounded = Number.parseFloat(value.toPrecision(12));
    return Math.min(this.max, Math.max(this.min, rounded));
  }

  #emit(type: "field-preview" | "field-change" | "field-cancel", value: number, repeated: boolean): void {
    const detail: NumberFieldEvent = { value: this.#bounded(value), repeated };
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}
customElements.define("tc-number", NumberField);

function factorOf(event: { readonly shiftKey: boolean; readonly altKey: boolean }): number {
  if (event.shiftKey) return COARSE;
  return event.altKey ? FINE : 1;
}

/** Two digits more than the step, without zeros at the end. */
function formatNumber(value: number, step: number): string {
  const digits = Math.max(0, Math.min(10, 1 - Math.floor(Math.log10(step || 1))));
  const text = value.toFixed(digits);
  const short = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  return Number(text) === 0 ? "0" : short;
}

declare global {
  interface HTMLElementTagNameMap {
    "tc-number": NumberField;
  }
}
