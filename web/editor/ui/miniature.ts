/**
 * What a layer or its mask paints, small, as the engine drew it: over whatever stands there until it is known. Decorative: the
 * row around it has the name.
 */
import { css, html, type TemplateResult } from "lit";
import type { Engine, TargetInfo } from "../../engine/engine-api.ts";
import type { DesignLayer } from "../document/index.ts";

/** Pixels along a side: two for each of the page's. */
const SIDE = 64;
/** A stroke changes its layer in every frame: its picture can wait for its end. */
const QUIET_MS = 250;
/** That of thousands of strokes takes seconds, in which no stroke is drawn: it waits for a rest that many times as long, to a most. */
const QUIET_SHARE = 5;
const LONGEST_QUIET_MS = 5000;

export interface MiniatureSource {
  readonly engine: Pick<Engine, "layerMiniature">;
  /** Another map: what could not be drawn before may be drawn now. */
  readonly targets: ReadonlyMap<number, TargetInfo>;
}

interface Shown extends MiniatureSource {
  readonly layer: DesignLayer;
  readonly of: "layer" | "mask";
}

export const miniatureStyles = css`
  tc-miniature {
    position: absolute;
    inset: 0;
    display: none;
    background: repeating-conic-gradient(var(--tile-checker) 0 25%, var(--tile) 0 50%) 0 0 / 10px 10px;
    forced-color-adjust: none;
  }
  tc-miniature[drawn] {
    display: block;
  }
  tc-miniature canvas {
    display: block;
    width: 100%;
    height: 100%;
  }
`;

class Miniature extends HTMLElement {
  #shown: Shown | null = null;
  /** Milliseconds that the newest picture took. */
  #took = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;

  set shown(shown: Shown) {
    const before = this.#shown;
    this.#shown = shown;
    const isKnown = before?.layer === shown.layer && before.targets === shown.targets && before.of === shown.of;
    // What is hidden is not painted; its picture stays what it was.
    if (isKnown || !shown.layer.visible) return;
    this.#drawSoon();
  }

  connectedCallback(): void {
    if (this.#shown?.layer.visible) this.#drawSoon();
  }

  disconnectedCallback(): void {
    clearTimeout(this.#timer);
  }

  #drawSoon(): void {
    clearTimeout(this.#timer);
    const quiet = Math.min(LONGEST_QUIET_MS, Math.max(QUIET_MS, this.#took * QUIET_SHARE));
    this.#timer = setTimeout(() => void this.#draw(), quiet);
  }

  async #draw(): Promise<void> {
    const shown = this.#shown;
    if (shown === null) return;
    const start = performance.now();
    let rgba: Uint8Array | null;
    try {
      rgba = await shown.engine.layerMiniature(shown.layer.id, shown.of, SIDE);
    } catch {
      // The engine ended, or is being replaced: a later change asks again.
      return;
    }
    this.#took = performance.now() - start;
    if (shown !== this.#shown && shown.layer !== this.#shown?.layer) return;
    this.toggleAttribute("drawn", rgba !== null);
    if (rgba === null) return;
    let canvas = this.querySelector("canvas");
    if (canvas === null) {
      canvas = document.createElement("canvas");
      canvas.width = canvas.height = SIDE;
      this.append(canvas);
    }
    canvas.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(rgba), SIDE, SIDE), 0, 0);
  }
}
customElements.define("tc-miniature", Miniature);

export function miniature(source: MiniatureSource, layer: DesignLayer, of: "layer" | "mask"): TemplateResult {
  const { engine, targets } = source;
  return html`<tc-miniature .shown=${{ engine, targets, layer, of }} aria-hidden="true"></tc-miniature>`;
}
