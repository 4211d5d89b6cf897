/**
 * The colours of a gradient: a bar with a handle for each, dragged or moved by key, and fields for the chosen one. Emits
 * `stops-preview` while a change goes on, `stops-change` when it is final, `stops-cancel` when it is taken back, `stops-step`
 * when a key moved a handle, as it may many times in a row; `detail` is the list of stops, in order.
 */
import { css, html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { Minus, Plus } from "lucide";
import { takesBack } from "../../viewer/take-back-key.ts";
import { windowOf } from "../../viewer/window-of.ts";
import type { GradientStop } from "../document/index.ts";
import type { Strings } from "../strings.ts";
import { controls } from "./controls.ts";
import { icon } from "./icon.ts";
import type { NumberFieldEvent } from "./number-field.ts";
import { recentColors } from "./recent-colors.ts";
import { RemElement } from "./rem-element.ts";

const LEAST = 2;
const MOST = 16;
const STEP = 0.01;
const COARSE_STEP = 0.1;
/** Pixels before a press on a handle moves it. */
const DRAG_START = 2;

interface Drag {
  readonly pointer: number;
  readonly x: number;
  /** Where the stop stood among the others. */
  readonly place: number;
  moved: boolean;
  readonly before: readonly GradientStop[];
  stops: readonly GradientStop[];
}

export class GradientStops extends RemElement {
  static override properties = {
    words: { attribute: false },
    stops: { attribute: false },
    recent: { attribute: false },
    greys: { type: Boolean },
    chosen: { state: true },
  };
  declare words: Strings["gradient"];
  declare stops: readonly GradientStop[];
  /** Colours that the fields offer. */
  declare recent: readonly string[];
  /** Its colours stand for something that has no opacity of its own. */
  declare greys: boolean;
  /** Place of the stop that the fields are about. */
  declare chosen: number;
  #drag: Drag | null = null;
  /**
   * A key took the focused handle's colour away, or past another: left to itself the focus would fall to the page, and the next
   * Delete to the layer, or stay behind with the other colour.
   */
  #refocus = false;

  constructor() {
    super();
    this.stops = [];
    this.recent = [];
    this.greys = false;
    this.chosen = 0;
  }

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        container-type: inline-size;
        gap: var(--space-2);
        /* From its first colour to its last, as the number line runs. */
        direction: ltr;
      }
      .bar {
        position: relative;
        height: 24px;
        margin-inline: 8px;
        border-radius: var(--radius);
        background: repeating-conic-gradient(var(--tile-checker) 0 25%, var(--tile) 0 50%) 0 0 / 10px 10px;
        cursor: copy;
        forced-color-adjust: none;
      }
      .ink {
        position: absolute;
        inset: 0 -8px;
        border-radius: inherit;
        box-shadow: inset 0 0 0 1px var(--line);
      }
      .handle {
        position: absolute;
        inset-block: -3px;
        width: 24px;
        min-width: 24px;
        min-height: 30px;
        margin-inline-start: -12px;
        padding: 0;
        border-radius: 12px;
        background: none;
        cursor: ew-resize;
        touch-action: none;
      }
      .handle::before {
        content: "";
        width: 10px;
        height: 100%;
        border: 2px solid #fff;
        border-radius: 6px;
        background: var(--ink);
        box-shadow:
          0 0 0 1px rgb(20 24 32 / 55%),
          inset 0 0 0 1px rgb(20 24 32 / 30%);
      }
      .handle[aria-current="true"]::before {
        outline: 2px solid var(--accent);
        outline-offset: 1px;
      }
      @media (pointer: coarse) {
        .bar {
          height: 36px;
          margin-inline: 18px;
        }
        .ink {
          inset: 0 -18px;
        }
        .handle {
          inset-block: -4px;
          width: 44px;
          min-height: 44px;
          margin-inline-start: -22px;
        }
        .handle::before {
          width: 16px;
          border-radius: 8px;
        }
      }
      .fields {
        display: grid;
        grid-template-columns: auto minmax(0, 1fr) minmax(0, 1fr) auto auto;
        gap: var(--space-1);
        align-items: center;
      }
      :host([greys]) .fields {
        grid-template-columns: auto minmax(0, 1fr) auto auto;
      }
      /* A finger's letters and buttons leave two numbers no room for three digits: the buttons stand beneath them. */
      @media (pointer: coarse) {
        @container (max-width: 24.6em) {
          :host(:not([greys])) .fields {
            grid-template-columns: auto repeat(2, minmax(0, 1fr));
          }
          :host(:not([greys])) .fields button:first-of-type {
            grid-column: 2;
          }
        }
        @container (max-width: 17.7em) {
          .fields {
            --space-2: 4px;
          }
        }
      }
      input[type="color"] {
        width: max(2.5rem, var(--target));
        height: var(--target);
        padding: 2px;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--surface);
      }
    `,
  ];

  /** The layer went while its colour was dragged. */
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#abandon();
  }

  override render(): TemplateResult {
    const { stops } = this;
    const place = Math.min(this.chosen, stops.length - 1);
    const list = stops.map(({ color, offset }) => `${color} ${offset * 100}%`).join(", ");
    return html`
      <div class="bar" role="group" aria-label=${this.words.stops} @dblclick=${this.#addAt} title=${this.words.barHint}>
        <span class="ink" .style=${`background: linear-gradient(to right, ${list})`}></span>
        ${stops.map((stop, index) => this.#handle(stop, index, index === place))}
      </div>
      ${this.#fields(place)}
    `;
  }

  override updated(changed: PropertyValues<this>): void {
    if (!this.#refocus || !changed.has("stops")) return;
    this.#refocus = false;
    this.renderRoot.querySelectorAll<HTMLElement>(".handle")[this.chosen]?.focus();
  }

  #handle({ offset, color }: GradientStop, index: number, pressed: boolean): TemplateResult {
    return html`<button
      class="handle"
      role="slider"
      aria-label=${this.words.stop(index + 1, this.stops.length)}
      aria-valuemin="0"
      aria-valuemax="100"
      aria-valuenow=${Math.round(offset * 100)}
      aria-valuetext=${`${Math.round(offset * 100)} %, ${color}`}
      aria-current=${pressed}
      .style=${`left: ${offset * 100}%; --ink: ${color}`}
      @focus=${() => {
        this.chosen = index;
      }}
      @keydown=${(event: KeyboardEvent) => this.#key(event, index)}
      @pointerdown=${(event: PointerEvent) => this.#grab(event, index)}
      @pointermove=${this.#move}
      @pointerup=${this.#release}
      @pointercancel=${this.#abandon}
      @lostpointercapture=${this.#release}
      @dblclick=${(event: Event) => event.stopPropagation()}
    ></button>`;
  }

  #fields(place: number): TemplateResult {
    const { color = "#000000", offset = 0 } = this.stops[place] ?? {};
    const value = (event: Event): string => (event.target as HTMLInputElement).value + color.slice(7);
    const detail = (event: Event): number => (event as CustomEvent<NumberFieldEvent>).detail.value;
    const moved = (event: Event) => this.#moved(this.stops, place, detail(event) / 100);
    const faded = (event: Event) => this.#with(place, { color: withAlpha(color, detail(event) / 100) });
    return html`<div class="fields">
      <input
        type="color"
        list="recent-colors"
        aria-label=${this.words.color}
        .value=${color.slice(0, 7)}
        @input=${(event: Event) => this.#tell("stops-preview", this.#with(place, { color: value(event) }))}
        @change=${(event: Event) => this.#tell("stops-change", this.#with(place, { color: value(event) }))}
      />
      ${recentColors("recent-colors", this.recent)}
      ${this.#number("offset", this.words.offsetLetter, this.words.offset, offset, moved)}
      ${this.greys ? nothing : this.#number("stop-alpha", this.words.alphaLetter, this.words.alpha, alphaOf(color), faded)}
      <button
        class="icon"
        aria-label=${this.words.add}
        title=${this.words.add}
        ?disabled=${this.stops.length >= MOST}
        @click=${() => this.#add(this.#gapAfter(place))}
      >
        ${icon(Plus)}
      </button>
      <button
        class="icon"
        aria-label=${this.words.remove}
        title=${this.words.remove}
        ?disabled=${this.stops.length <= LEAST}
        @click=${() => this.#remove(place)}
      >
        ${icon(Minus)}
      </button>
    </div>`;
  }

  /** A share as percent. */
  #number(
    field: string,
    label: string,
    name: string,
    share: number,
    made: (event: Event) => readonly GradientStop[],
  ): TemplateResult {
    return html`<tc-number
      data-field=${field}
      .label=${label}
      .name=${name}
      unit="%"
      .value=${Math.round(share * 1000) / 10}
      .step=${1}
      .min=${0}
      .max=${100}
      @field-preview=${(event: Event) => this.#tell("stops-preview", made(event))}
      @field-change=${(event: Event) => this.#tell("stops-change", made(event))}
      @field-cancel=${() => this.#tell("stops-cancel", this.stops)}
    ></tc-number>`;
  }

  #tell(type: `stops-${"preview" | "change" | "cancel" | "step"}`, stops: readonly GradientStop[]): void {
    this.dispatchEvent(new CustomEvent(type, { detail: stops }));
  }

  #with(place: number, patch: Partial<GradientStop>): readonly GradientStop[] {
    return this.stops.map((stop, index) => (index === place ? { ...stop, ...patch } : stop));
  }

  /** In order again; the choice goes with the stop. */
  #moved(stops: readonly GradientStop[], place: number, offset: number): readonly GradientStop[] {
    const stop = stops[place];
    if (!stop) return stops;
    const next = { ...stop, offset: Math.max(0, Math.min(1, offset)) };
    const others = stops.toSpliced(place, 1);
    const earlier = others.filter(
      (other, index) => other.offset < next.offset || (other.offset === next.offset && index < place),
    );
    this.chosen = earlier.length;
    return others.toSpliced(earlier.length, 0, next);
  }

  #gapAfter(place: number): number {
    const [from, to] = place + 1 < this.stops.length ? [place, place + 1] : [place - 1, place];
    return ((this.stops[from]?.offset ?? 0) + (this.stops[to]?.offset ?? 1)) / 2;
  }

  #addAt(event: MouseEvent): void {
    const { left, width } = (event.currentTarget as HTMLElement).getBoundingClientRect();
    this.#add(Math.max(0, Math.min(1, (event.clientX - left) / width)));
  }

  #add(offset: number): void {
    if (this.stops.length >= MOST) return;
    const place = this.stops.filter((stop) => stop.offset <= offset).length;
    this.chosen = place;
    this.#tell("stops-change", this.stops.toSpliced(place, 0, { offset, color: colorAt(this.stops, offset) }));
  }

  #remove(place: number, stops = this.stops): void {
    if (stops.length <= LEAST) return;
    this.chosen = Math.max(0, place - 1);
    this.#tell("stops-change", stops.toSpliced(place, 1));
  }

  #key(event: KeyboardEvent, index: number): void {
    const step = event.shiftKey ? COARSE_STEP : STEP;
    const { offset = 0 } = this.stops[index] ?? {};
    const goals: Readonly<Record<string, number>> = {
      ArrowLeft: offset - step,
      ArrowDown: offset - step,
      ArrowRight: offset + step,
      ArrowUp: offset + step,
      Home: 0,
      End: 1,
    };
    const goal = goals[event.key];
    if (event.key === "Delete" || event.key === "Backspace") {
      this.#refocus = this.stops.length > LEAST;
      this.#remove(index);
    } else if (goal !== undefined) {
      const stops = this.#moved(this.stops, index, Math.round(goal * 1e4) / 1e4);
      this.#refocus = this.chosen !== index;
      this.#tell("stops-step", stops);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  #grab(event: PointerEvent, index: number): void {
    if (event.button !== 0) return;
    this.chosen = index;
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    windowOf(this).addEventListener("keydown", this.#dragKey, { capture: true });
    const { stops } = this;
    this.#drag = { pointer: event.pointerId, x: event.clientX, place: index, moved: false, before: stops, stops };
  }

  readonly #move = (event: PointerEvent): void => {
    const drag = this.#drag;
    const bar = this.renderRoot.querySelector(".bar")?.getBoundingClientRect();
    if (!drag || !bar || drag.pointer !== event.pointerId) return;
    if (!drag.moved && Math.abs(event.clientX - drag.x) < DRAG_START) return;
    drag.moved = true;
    const offset = Math.round(((event.clientX - bar.left) / bar.width) * 1000) / 1000;
    drag.stops = this.#moved(drag.stops, this.chosen, offset);
    this.#tell("stops-preview", drag.stops);
  };

  readonly #release = (event: PointerEvent): void => {
    const drag = this.#drag;
    if (drag?.pointer !== event.pointerId) return;
    this.#end();
    if (drag.moved) this.#tell("stops-change", drag.stops);
  };

  /** The page does not hear of keys meanwhile: it would take back the step before, or delete the layer whose colour is dragged. */
  readonly #dragKey = (event: KeyboardEvent): void => {
    event.stopPropagation();
    const drag = this.#drag;
    const deletes = event.key === "Delete" || event.key === "Backspace";
    if (!drag || !(deletes || takesBack(event))) return;
    event.preventDefault();
    if (!deletes) this.#abandon();
    else if (drag.before.length > LEAST) {
      this.#end();
      this.#refocus = true;
      // As it was before the drag: of the two only the deletion is a step.
      this.#remove(drag.place, drag.before);
    }
  };

  readonly #abandon = (): void => {
    if (this.#drag === null) return;
    this.chosen = this.#drag.place;
    this.#end();
    this.#tell("stops-cancel", this.stops);
  };

  #end(): void {
    this.#drag = null;
    windowOf(this).removeEventListener("keydown", this.#dragKey, { capture: true });
  }
}
customElements.define("tc-gradient-stops", GradientStops);

function bytesOf(color: string): number[] {
  const opaque = color.length > 7 ? color : `${color}ff`;
  return [1, 3, 5, 7].map((start) => Number.parseInt(opaque.slice(start, start + 2), 16));
}

function hexOf(bytes: readonly number[]): string {
  const hex = bytes.map((byte) => Math.round(byte).toString(16).padStart(2, "0")).join("");
  return `#${hex.endsWith("ff") ? hex.slice(0, 6) : hex}`;
}

/** 0 to 1. */
const alphaOf = (color: string): number => (bytesOf(color)[3] as number) / 255;
const withAlpha = (color: string, alpha: number): string => hexOf([...bytesOf(color).slice(0, 3), alpha * 255]);

/** A new stop changes nothing until it is given another colour. */
function colorAt(stops: readonly GradientStop[], offset: number): string {
  const after = stops.findIndex((stop) => stop.offset >= offset);
  const [from, to] = [stops[Math.max(0, after - 1)], stops[after < 0 ? stops.length - 1 : after]];
  if (!from || !to) return "#000000";
  const span = to.offset - from.offset;
  const share = span > 0 ? (offset - from.offset) / span : 0;
  const [first, second] = [bytesOf(from.color), bytesOf(to.color)];
  return hexOf(first.map((byte, channel) => byte + ((second[channel] as number) - byte) * share));
}
