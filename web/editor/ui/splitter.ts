/** A bar between two panes (WAI-ARIA window splitter). Emits `split` with the share of the second pane, 0 to 1. */
import { css, html, type TemplateResult } from "lit";
import { RemElement } from "./rem-element.ts";
import { plainControls } from "./theme.ts";

const KEY_STEP = 0.02;

export class Splitter extends RemElement {
  static override properties = {
    name: {},
    share: { type: Number },
    min: { type: Number },
    max: { type: Number },
  };
  declare name: string;
  declare share: number;
  declare min: number;
  declare max: number;

  constructor() {
    super();
    this.name = "";
    this.share = 0.4;
    this.min = 0.15;
    this.max = 0.7;
  }

  static override styles = [
    plainControls,
    css`
      :host {
        position: relative;
        display: block;
        width: 1px;
        background: var(--line);
      }
      div {
        position: absolute;
        z-index: 2;
        inset-block: 0;
        inset-inline: -5px;
        cursor: col-resize;
        touch-action: none;
      }
      div::after {
        content: "";
        position: absolute;
        inset-block: 0;
        inset-inline: 4px;
        border-radius: 2px;
        transition: background-color 120ms;
      }
      div:hover::after,
      div:active::after {
        background: var(--accent);
      }
      @media (pointer: coarse) {
        div {
          inset-inline: -12px;
        }
        div::after {
          inset-inline: 11px;
        }
      }
    `,
  ];

  override render(): TemplateResult {
    return html`<div
      role="separator"
      tabindex="0"
      aria-orientation="vertical"
      aria-label=${this.name}
      aria-valuenow=${Math.round(this.share * 100)}
      aria-valuemin=${Math.round(this.min * 100)}
      aria-valuemax=${Math.round(this.max * 100)}
      @pointerdown=${(event: PointerEvent) => (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId)}
      @pointermove=${this.#drag}
      @keydown=${this.#key}
    ></div>`;
  }

  #drag(event: PointerEvent): void {
    if (!(event.currentTarget as HTMLElement).hasPointerCapture(event.pointerId)) return;
    const box = this.parentElement?.getBoundingClientRect();
    if (box && box.width > 0) this.#emit((box.right - event.clientX) / box.width);
  }

  #key(event: KeyboardEvent): void {
    const step = { ArrowLeft: KEY_STEP, ArrowRight: -KEY_STEP }[event.key];
    if (step === undefined && event.key !== "Home" && event.key !== "End") return;
    event.preventDefault();
    event.stopPropagation();
    if (step !== undefined) this.#emit(this.share + step);
    else this.#emit(event.key === "Home" ? this.max : this.min);
  }

  #emit(share: number): void {
    this.dispatchEvent(new CustomEvent("split", { detail: Math.min(this.max, Math.max(this.min, share)) }));
  }
}
customElements.define("tc-splitter", Splitter);

declare global {
  interface HTMLElementTagNameMap {
    "tc-splitter": Splitter;
  }
}
