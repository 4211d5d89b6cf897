/** The flat texture, or one of the maps behind it, with UV outlines. */
import { css, html, type TemplateResult } from "lit";
import { Maximize } from "lucide";
import type { EditorState, Figures } from "../state/editor-state.ts";
import { StoreController } from "../state/store.ts";
import { TEXTURE_MODES, type TextureMode } from "../state/view-state.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import { OverflowFade } from "../ui/overflow-fade.ts";

export class TexturePanel extends EditorElement {
  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        container: panel / inline-size;
        grid-template: auto minmax(0, 1fr) auto / minmax(0, 1fr);
        min-width: 0;
        min-height: 0;
        background: var(--surface-low);
      }
      [role="tablist"] {
        display: flex;
        flex-wrap: wrap;
        gap: 2px;
        padding: var(--space-1) var(--space-2);
        border-bottom: 1px solid var(--line);
      }
      [role="tab"] {
        flex: none;
        padding-inline: var(--space-2);
        color: var(--text-quiet);
      }
      [role="tab"][aria-selected="true"] {
        background: var(--pressed);
        color: var(--text);
        font-weight: 550;
      }
      @container (max-width: 36em) {
        [role="tab"] {
          padding-inline: 5px;
          font-size: var(--text-small);
        }
      }
      @container (max-width: 27.5em) {
        [role="tab"] {
          padding-inline: 3px;
        }
      }
      /* Beside a phone on its side, in German, in one row; where not even that, in two. */
      @container (max-width: 25.7em) {
        [role="tablist"] {
          padding-inline: 2px;
        }
        [role="tab"] {
          padding-inline: 2px;
          font-size: 0.6875rem;
        }
      }
      .choice {
        display: none;
        gap: var(--space-1);
        padding: var(--space-1) var(--space-1) var(--space-1) var(--space-2);
        border-bottom: 1px solid var(--line);
      }
      .choice select {
        flex: 1;
        min-width: 0;
      }
      /* Beside the model on a tablet on its side: a row of names would take its width from the model. */
      @container panel (max-width: 22.5em) {
        [role="tablist"],
        footer .icon {
          display: none;
        }
        .choice {
          display: flex;
        }
      }
      .view {
        position: relative;
        min-height: 0;
        overflow: hidden;
      }
      .empty {
        position: absolute;
        inset: 0;
        display: grid;
        place-content: center;
        padding: var(--space-4);
        text-align: center;
        color: var(--text-quiet);
      }
      footer {
        container-type: inline-size;
        display: flex;
        align-items: center;
        gap: var(--space-2);
        min-height: 36px;
        padding: 2px var(--space-2) 2px var(--space-3);
        border-top: 1px solid var(--line);
        overflow-x: auto;
        scrollbar-width: none;
      }
      footer > * {
        flex: none;
      }
      footer p {
        flex: 1;
        min-width: 0;
        overflow: hidden;
        color: var(--text-quiet);
        font-size: var(--text-small);
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      /* A word cut in two says nothing; the tab's own hint says it, too. */
      @container (max-width: 31em) {
        footer p:not(#texel) {
          visibility: hidden;
        }
      }
      label {
        display: inline-flex;
        align-items: center;
        gap: var(--space-2);
        min-height: var(--target);
        white-space: nowrap;
        cursor: pointer;
      }
    `,
  ];

  constructor() {
    super();
    new OverflowFade(this, "footer");
    new StoreController<Figures>(
      this,
      () => this.editor?.figures,
      ({ texel }) => [texel],
    );
  }

  get #words(): Strings["texture"] {
    return this.strings.texture;
  }

  protected watched({ textureMode, outlines, targets, material, view, starting }: EditorState): readonly unknown[] {
    return [textureMode, outlines, targets, material, view.guide, starting];
  }

  override render(): TemplateResult {
    const { textureMode, outlines, targets, material, view, starting } = this.state;
    const { texel } = this.editor.figures.state;
    const named = material !== null && this.editor.viewer.guideOf(material).length > 0;
    const shown = material !== null && targets.has(material);
    const fit = html`<button
      class="icon"
      aria-label=${this.#words.fitLabel}
      title=${this.#words.fitLabel}
      @click=${() => this.editor.textureView.resetZoom()}
    >
      ${icon(Maximize)}
    </button>`;
    return html`
      <div role="tablist" aria-label=${this.#words.label} @keydown=${this.#key}>
        ${TEXTURE_MODES.map(
          (mode) => html`<button
            role="tab"
            id=${`tab-${mode}`}
            aria-selected=${mode === textureMode}
            aria-controls="panel"
            tabindex=${mode === textureMode ? 0 : -1}
            title=${this.#words.modeHints[mode]}
            @click=${() => this.#choose(mode)}
          >
            ${this.#words.modes[mode]}
          </button>`,
        )}
      </div>
      <div class="choice">
        <select
          aria-label=${this.#words.label}
          title=${this.#words.modeHints[textureMode]}
          @change=${(event: Event) => this.#choose((event.target as HTMLSelectElement).value as TextureMode)}
        >
          ${TEXTURE_MODES.map(
            (mode) => html`<option value=${mode} .selected=${mode === textureMode}>${this.#words.modes[mode]}</option>`,
          )}
        </select>
        ${fit}
      </div>
      <div class="view" id="panel" role="tabpanel" aria-labelledby=${`tab-${textureMode}`}>
        <slot name="texture"></slot>
        <div class="empty" ?hidden=${shown || starting}><p>${this.#words.empty}</p></div>
      </div>
      <footer>
        ${
          texel
            ? html`<p id="texel" title=${this.#words.texelLabel}>${this.#words.texel(texel[0], texel[1])}</p>`
            : html`<p title=${this.#words.modeHints[textureMode]}>${this.#words.modeHints[textureMode]}</p>`
        }
        <label title=${named ? "" : this.#words.guideNone}>
          <input
            type="checkbox"
            id="guide"
            .checked=${view.guide && named}
            ?disabled=${!named}
            @change=${() => this.editor.views.toggle("guide")}
          />
          ${this.strings.views.guide}
        </label>
        <label>
          <input
            type="checkbox"
            id="outlines"
            .checked=${outlines}
            @change=${(event: Event) => this.editor.setOutlines((event.target as HTMLInputElement).checked)}
          />
          ${this.#words.outlines}
        </label>
        ${fit}
      </footer>
    `;
  }

  #choose(mode: TextureMode): void {
    this.editor.setTextureMode(mode);
  }

  #key(event: KeyboardEvent): void {
    const steps = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (steps === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const count = TEXTURE_MODES.length;
    const next = TEXTURE_MODES[(TEXTURE_MODES.indexOf(this.state.textureMode) + steps + count) % count];
    if (!next) return;
    this.#choose(next);
    this.renderRoot.querySelector<HTMLElement>(`#tab-${next}`)?.focus();
  }
}
customElements.define("tc-texture-panel", TexturePanel);
