/** The model's animation: which clip, where in it, how fast. Shown once the model has left its rest. */
import { css, html, nothing, type TemplateResult } from "lit";
import { Pause, Play, Square } from "lucide";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2];
/** Steps that a scrubbed clip is divided into. */
const SCRUB_STEPS = 240;

export class AnimationBar extends EditorElement {
  static override styles = [
    controls,
    css`
      :host {
        display: block;
        container-type: inline-size;
        pointer-events: none;
      }
      .bar {
        pointer-events: auto;
        display: flex;
        align-items: center;
        gap: var(--space-1);
        width: fit-content;
        max-width: 100%;
        margin-inline: auto;
        padding: 3px;
        border: 1px solid var(--line);
        border-radius: var(--radius-large);
        background: var(--surface);
        box-shadow: 0 1px 3px rgb(20 24 32 / 8%);
      }
      select {
        flex: none;
        width: auto;
        max-width: 7rem;
        background-color: transparent;
      }
      #clip {
        flex: 0 1 auto;
        min-width: var(--target);
      }
      /* What fields share gives it no least width. */
      #scrub {
        flex: 1 1 9rem;
        min-width: 3rem;
      }
      output {
        min-width: 5.5rem;
        padding-inline: var(--space-1);
        color: var(--text-quiet);
        font-variant-numeric: tabular-nums;
        text-align: center;
        white-space: nowrap;
      }
      @container (max-width: 33em) {
        output {
          display: none;
        }
      }
    `,
  ];

  get #words(): Strings["animation"] {
    return this.strings.animation;
  }

  protected watched({ animation }: EditorState): readonly unknown[] {
    return [animation];
  }

  override focus(options?: FocusOptions): void {
    this.renderRoot.querySelector<HTMLElement>("#play")?.focus(options);
  }

  override render(): TemplateResult | typeof nothing {
    const { clips, clip, playing, seconds, speed } = this.state.animation;
    const { views } = this.editor;
    const shown = clip === null ? undefined : clips[clip];
    if (!shown) return nothing;
    const play = playing ? this.#words.pause : this.#words.play;
    const chosen = (event: Event): number => Number((event.target as HTMLSelectElement | HTMLInputElement).value);
    return html`
      <div class="bar" role="group" aria-label=${this.#words.label}>
        <button class="icon" id="play" aria-label=${play} title=${play} @click=${() => views.animate({ playing: !playing })}>
          ${icon(playing ? Pause : Play)}
        </button>
        ${
          clips.length > 1
            ? html`<select id="clip" aria-label=${this.#words.clip} @change=${(event: Event) => views.animate({ clip: chosen(event) })}>
                ${clips.map(({ name }, index) => html`<option value=${index} ?selected=${index === clip}>${name}</option>`)}
              </select>`
            : nothing
        }
        <input
          type="range"
          id="scrub"
          aria-label=${this.#words.time}
          aria-valuetext=${this.#words.at(seconds, shown.seconds)}
          min="0"
          max=${SCRUB_STEPS}
          step="1"
          .value=${String(Math.round((seconds / shown.seconds) * SCRUB_STEPS))}
          @input=${(event: Event) => views.animate({ playing: false, seconds: (chosen(event) / SCRUB_STEPS) * shown.seconds })}
        />
        <output for="scrub" aria-live="off">${this.#words.at(seconds, shown.seconds)}</output>
        <select id="speed" aria-label=${this.#words.speed} title=${this.#words.speed} @change=${(event: Event) => views.animate({ speed: chosen(event) })}>
          ${SPEEDS.map((value) => html`<option value=${value} ?selected=${value === speed}>${this.#words.times(value)}</option>`)}
        </select>
        <button class="icon" id="rest" aria-label=${this.#words.rest} title=${this.#words.rest} @click=${() => this.dispatchEvent(new CustomEvent("rest"))}>
          ${icon(Square)}
        </button>
      </div>
    `;
  }
}
customElements.define("tc-animation-bar", AnimationBar);

declare global {
  interface HTMLElementTagNameMap {
    "tc-animation-bar": AnimationBar;
  }
}
