/** How the model is shown: shading, light, maps, background. */
import { css, html, type TemplateResult } from "lit";
import { RotateCcw } from "lucide";
import type { EditorState } from "../state/editor-state.ts";
import { BACKGROUND_TONES, TEXTURE_MODES, type TextureMode, USUAL_VIEW } from "../state/view-state.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import { checkField, choiceField } from "./property-fields.ts";
import { propertyStyles } from "./property-styles.ts";

export class ViewSettings extends EditorElement {
  static override styles = [
    controls,
    propertyStyles,
    css`
      :host {
        gap: var(--space-2);
        align-content: start;
      }
      .slider {
        grid-template-columns: 5.5rem minmax(0, 1fr) 2.75rem;
      }
      /* A finger's letters are larger. */
      @media (pointer: coarse) and (min-width: 15.01rem) {
        .field {
          grid-template-columns: 5.75rem minmax(0, 1fr);
        }
        .slider {
          grid-template-columns: 5.75rem minmax(0, 1fr) 3rem;
        }
      }
      .slider label {
        color: var(--text-quiet);
      }
      .slider output {
        text-align: end;
        font-variant-numeric: tabular-nums;
      }
      .checks {
        display: grid;
        grid-template-columns: 1fr 1fr;
      }
      .wide {
        grid-column: 1 / -1;
      }
      /* Letters twice as large as usual, on a phone. */
      @media (max-width: 15rem) {
        .slider,
        .checks {
          grid-template-columns: minmax(0, 1fr);
        }
        button {
          min-height: auto;
        }
      }
    `,
  ];

  get #words(): Strings["views"] {
    return this.strings.views;
  }

  protected watched({ view }: EditorState): readonly unknown[] {
    return [view];
  }

  override render(): TemplateResult {
    const { view } = this.state;
    const { views } = this.editor;
    const backgrounds = Object.fromEntries(
      BACKGROUND_TONES.map((tone) => [tone, this.#words.backgrounds[tone]]),
    ) as Record<(typeof BACKGROUND_TONES)[number], string>;
    const { layout, guide, aligns } = view;
    const usual = { ...USUAL_VIEW, layout, guide, aligns };
    const unusual = Object.entries(usual).some(([key, value]) => view[key as keyof typeof view] !== value);
    return html`
      ${choiceField("shading", this.#words.shading, this.#words.shadings, view.shading, (shading) => views.set({ shading }))}
      <div class="field">
        <label for="model-map">${this.#words.shows}</label>
        <select
          id="model-map"
          @change=${(event: Event) => views.set({ modelMap: (event.target as HTMLSelectElement).value as TextureMode })}
        >
          ${TEXTURE_MODES.map(
            (mode) =>
              html`<option value=${mode} ?selected=${mode === view.modelMap}>${this.strings.texture.modes[mode]}</option>`,
          )}
        </select>
      </div>
      <div class="checks">
        ${checkField("wireframe", this.#words.wireframe, view.wireframe, () => views.toggle("wireframe"))}
        ${checkField("turntable", this.#words.turntable, view.turntable, () => views.toggle("turntable"))}
        <span class="wide" title=${this.#words.alignsHint}>
          ${checkField("aligns", this.#words.aligns, view.aligns, () => views.toggle("aligns"))}
        </span>
      </div>
      ${this.#slider(
        "light-turn",
        this.#words.lightTurn,
        view.lightTurn,
        360,
        this.#words.degrees(view.lightTurn),
        (lightTurn) => views.set({ lightTurn }),
      )}
      ${this.#slider(
        "light-strength",
        this.#words.lightStrength,
        view.lightStrength * 100,
        200,
        this.#words.percent(view.lightStrength * 100),
        (percent) => views.set({ lightStrength: percent / 100 }),
      )}
      ${choiceField("background", this.#words.background, backgrounds, view.background, (background) => views.set({ background }))}
      <button
        id="reset-view"
        aria-disabled=${!unusual}
        @click=${() => unusual && views.set(usual)}
      >
        ${icon(RotateCcw)}${this.#words.reset}
      </button>
    `;
  }

  #slider(
    id: string,
    label: string,
    value: number,
    most: number,
    text: string,
    change: (value: number) => void,
  ): TemplateResult {
    const lit = this.state.view.shading === "lit" && this.state.view.modelMap === "texture";
    return html`
      <div class="slider">
        <label for=${id}>${label}</label>
        <input
          type="range"
          id=${id}
          min="0"
          max=${most}
          step="5"
          .value=${String(Math.round(value))}
          ?disabled=${!lit}
          aria-valuetext=${text}
          @input=${(event: Event) => change(Number((event.target as HTMLInputElement).value))}
        />
        <output for=${id} aria-live="off">${text}</output>
      </div>
    `;
  }
}
customElements.define("tc-view-settings", ViewSettings);
