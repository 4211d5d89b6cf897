/** Colours to paint with: the palette, the newest ones, and the palette's own menu. */
import { css, html, type TemplateResult } from "lit";
import { Download, ImagePlus, RotateCcw, Upload } from "lucide";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import { ACCEPT } from "../ui/accepted-files.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { pickFiles } from "../ui/file-picker.ts";
import { icon } from "../ui/icon.ts";

export class ColorPalette extends EditorElement {
  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        grid-template-columns: minmax(0, 1fr);
        gap: var(--space-2);
      }
      header {
        display: flex;
        align-items: center;
        gap: 2px;
      }
      h3 {
        flex: 1;
        min-width: 0;
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      .colors {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(26px, 1fr));
        gap: 2px;
        padding: 2px;
      }
      .colors button {
        min-width: 0;
        min-height: 0;
        padding: 0;
        aspect-ratio: 1;
        border-radius: 4px;
        background: var(--color) !important;
        box-shadow: inset 0 0 0 1px rgb(128 128 128 / 35%);
        forced-color-adjust: none;
      }
      .colors button[aria-pressed="true"] {
        box-shadow:
          0 0 0 2px var(--surface-high),
          0 0 0 4px var(--accent);
      }
      @media (pointer: coarse) {
        .colors {
          grid-template-columns: repeat(auto-fill, minmax(44px, 1fr));
        }
      }
    `,
  ];

  get #words(): Strings["palette"] {
    return this.strings.palette;
  }

  protected watched({ toolSettings }: EditorState): readonly unknown[] {
    const { palette, color, recent } = toolSettings;
    return [palette, color, recent];
  }

  override render(): TemplateResult {
    const { palette, recent } = this.state.toolSettings;
    const { palettes } = this.editor;
    const name = palette.name || this.#words.basic;
    const buttons = [
      { label: this.#words.fromPicture, drawing: ImagePlus, run: () => this.#open(ACCEPT.picture) },
      { label: this.#words.import, drawing: Upload, run: () => this.#open(".gpl") },
      { label: this.#words.export, drawing: Download, run: () => palettes.save() },
      { label: this.#words.reset, drawing: RotateCcw, run: () => palettes.reset() },
    ];
    return html`
      <header>
        <h3>${name}</h3>
        ${buttons.map(
          ({ label, drawing, run }) =>
            html`<button class="icon" aria-label=${label} title=${label} @click=${run}>${icon(drawing)}</button>`,
        )}
      </header>
      <div class="colors" id="palette-colors" role="group" aria-label=${name}>${this.#swatches(palette.colors)}</div>
      ${
        recent.length > 0
          ? html`<h3>${this.strings.tools.recent}</h3>
              <div class="colors" role="group" aria-label=${this.strings.tools.recent}>${this.#swatches(recent)}</div>`
          : ""
      }
    `;
  }

  #swatches(colors: readonly string[]): TemplateResult[] {
    const { color } = this.state.toolSettings;
    return colors.map(
      (value) => html`<button
        .style=${`--color:${value}`}
        data-color=${value}
        aria-label=${this.strings.tools.recentColor(value)}
        aria-pressed=${value === color}
        title=${value}
        @click=${() => this.editor.tools.configure({ color: value })}
      ></button>`,
    );
  }

  #open(accept: string): void {
    pickFiles({ accept }, ([file]) => {
      if (file) void this.editor.palettes.open(file.file);
    });
  }
}
customElements.define("tc-color-palette", ColorPalette);
