/** How the model is shown: shading, light, maps, background. A small panel that a button on the stage opens. */
import { css, html, nothing, type TemplateResult } from "lit";
import { Eye, RotateCcw } from "lucide";
import type { EditorState } from "../state/editor-state.ts";
import { BACKGROUND_TONES, TEXTURE_MODES, type TextureMode, USUAL_VIEW } from "../state/view-state.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import { narrow } from "../ui/page-shapes.ts";
import { checkField, choiceField } from "./property-fields.ts";
import { propertyStyles } from "./property-styles.ts";

/** Pixels between the panel and its button, and between it and the page's edges. */
const GAP = 4;

export class ViewMenu extends EditorElement {
  static override properties = { open: { state: true } };
  declare open: boolean;
  /** The stage that its button stands in, which the splitter makes narrower. */
  readonly #moves = new ResizeObserver(() => this.#place());

  static override styles = [
    controls,
    propertyStyles,
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
      /* Where a sheet stands below the stage, that stays in sight. */
      @media ${narrow} {
        .panel {
          max-height: calc(100cqh - 4.5rem);
        }
      }
      @media (pointer: coarse) {
        .panel {
          width: 20.5rem;
          max-width: calc(100vw - 4.25rem);
          padding-inline: var(--space-3);
        }
        .panel .field,
        .panel .slider {
          grid-template-columns: 5.75rem minmax(0, 1fr);
        }
        .panel .slider output {
          display: none;
        }
      }
      .titled h2 {
        flex: 1;
      }
      .slider {
        grid-template-columns: 5.5rem minmax(0, 1fr) 2.75rem;
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
    `,
  ];

  constructor() {
    super();
    this.open = false;
    this.addEventListener("keydown", this.#key);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("resize", this.#place);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("resize", this.#place);
    this.#moves.disconnect();
  }

  override firstUpdated(): void {
    const stage = this.getRootNode();
    if (stage instanceof ShadowRoot) this.#moves.observe(stage.host);
  }

  override updated(): void {
    this.#place();
  }

  get #words(): Strings["views"] {
    return this.strings.views;
  }

  protected watched({ view, model }: EditorState): readonly unknown[] {
    return [view, model === null];
  }

  override render(): TemplateResult {
    const toggle = (): void => {
      this.open = !this.open;
    };
    return html`
      <button
        class="icon opener"
        id="view-menu"
        aria-label=${this.#words.menu}
        title=${this.#words.menu}
        aria-expanded=${this.open}
        aria-pressed=${this.open}
        aria-controls="view-panel"
        @click=${toggle}
      >
        ${icon(Eye)}
      </button>
      ${this.open ? this.#panel() : nothing}
    `;
  }

  #panel(): TemplateResult {
    const { view } = this.state;
    const { views } = this.editor;
    const backgrounds = Object.fromEntries(
      BACKGROUND_TONES.map((tone) => [tone, this.#words.backgrounds[tone]]),
    ) as Record<(typeof BACKGROUND_TONES)[number], string>;
    const unusual = Object.entries(USUAL_VIEW).some(
      ([key, value]) => key !== "layout" && key !== "guide" && view[key as keyof typeof view] !== value,
    );
    return html`
      <div class="panel" id="view-panel" popover="manual" role="group" aria-label=${this.#words.menu}>
        <div class="titled">
          <h2>${this.#words.menu}</h2>
          <button
            class="icon small"
            id="reset-view"
            aria-label=${this.#words.reset}
            title=${this.#words.reset}
            ?disabled=${!unusual}
            @click=${() => views.set({ ...USUAL_VIEW, layout: view.layout, guide: view.guide })}
          >
            ${icon(RotateCcw)}
          </button>
        </div>
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
      </div>
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
        <output for=${id}>${text}</output>
      </div>
    `;
  }

  /** Beside its button, where there is room: towards the model, else to the other side; and within the page. */
  readonly #place = (): void => {
    const panel = this.renderRoot.querySelector<HTMLElement>("#view-panel");
    const opener = this.renderRoot.querySelector("#view-menu")?.getBoundingClientRect();
    // The view may have given its place to the other one while this was open.
    if (!panel?.isConnected || !opener) return;
    if (!panel.matches(":popover-open")) panel.showPopover();
    const { offsetWidth: width, offsetHeight: height } = panel;
    const [before, after] = [opener.left - GAP - width, opener.right + GAP];
    const rightToLeft = getComputedStyle(this).direction === "rtl";
    const [fitsBefore, fitsAfter] = [before >= GAP, after + width + GAP <= innerWidth];
    const left = fitsAfter && (rightToLeft || !fitsBefore) ? after : Math.max(GAP, before);
    panel.style.left = `${left}px`;
    panel.style.top = `${Math.max(GAP, Math.min(opener.top, innerHeight - height - GAP))}px`;
  };

  /** Its button too: where the focus stays when it is opened by the pointer. */
  readonly #key = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || !this.open) return;
    event.stopPropagation();
    this.open = false;
    this.renderRoot.querySelector<HTMLElement>("#view-menu")?.focus();
  };
}
customElements.define("tc-view-menu", ViewMenu);
