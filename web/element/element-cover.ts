/** What is seen before the product is: the poster, the way in, how far it has come, or why it did not. */
import { html, nothing, type TemplateResult } from "lit";
import type { ShownError } from "./element-errors.ts";
import type { Words } from "./words/words.ts";

export interface Cover {
  readonly words: Words;
  readonly poster: string;
  readonly phase: "idle" | "loading" | "failed";
  /** 0 to 1. */
  readonly share: number;
  readonly error: ShownError | null;
  readonly start: () => void;
}

export function cover({ words, poster, phase, share, error, start }: Cover): TemplateResult {
  return html`
    <div class="cover" part="cover" lang=${words.lang} data-phase=${phase} ?data-bare=${!poster}>
      <slot name="poster">
        ${!poster ? nothing : html`<img class="poster" part="poster" src=${poster} alt="" />`}
      </slot>
      <div class="own center">
        ${
          phase === "idle"
            ? html`<button class="filled start" part="button start-button" data-act="start" @click=${start}>
                ${words.start}
              </button>`
            : phase === "loading"
              ? html`<slot name="progress">
                  <progress part="progress" max="1" .value=${share} aria-label=${words.loading}></progress>
                </slot>`
              : html`<div class="card" part="notice" role="alert">
                  <h2>${words.failed}</h2>
                  <p>${error?.message}</p>
                  ${error?.hint ? html`<p class="quiet">${error.hint}</p>` : nothing}
                  <button class="outlined" part="button" data-act="retry" @click=${start}>${words.retry}</button>
                </div>`
        }
      </div>
    </div>
  `;
}

/** An error as the user sees it while they work, until it is sent away or the next act begins. */
export function notice({ message, hint }: ShownError, words: Words, dismiss: () => void): TemplateResult {
  return html`<div class="own notice" part="notice" role="alert" lang=${words.lang}>
    <div>
      <p>${message}</p>
      ${hint ? html`<p class="quiet">${hint}</p>` : nothing}
    </div>
    <button class="icon" data-act="dismiss" aria-label=${words.close} title=${words.close} @click=${dismiss}>✕</button>
  </div>`;
}
