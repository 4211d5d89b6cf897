/** What a brush prints: a disc, a picture of the design or of those that come with the page, or a file. */
import { css, html, nothing, type TemplateResult } from "lit";
import { ImagePlus } from "lucide";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import { type BrushTip, tipsOf } from "../tools/brush-tips.ts";
import { ACCEPT } from "../ui/accepted-files.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { pickFiles } from "../ui/file-picker.ts";
import { icon } from "../ui/icon.ts";
import { checkField } from "./property-fields.ts";
import { propertyStyles } from "./property-styles.ts";

export class TipPicker extends EditorElement {
  static override styles = [
    controls,
    propertyStyles,
    css`
      :host {
        display: grid;
        gap: var(--space-2);
      }
      .tips {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(40px, 1fr));
        gap: var(--space-1);
        max-height: 12rem;
        overflow: auto;
        padding: 2px;
      }
      .tips button {
        aspect-ratio: 1;
        min-width: 0;
        padding: 4px;
        background: var(--tile);
      }
      @media (hover: hover) {
        .tips button:hover {
          background: var(--tile-checker);
        }
      }
      .tips button[aria-pressed="true"] {
        box-shadow: 0 0 0 2px var(--accent);
      }
      @media (pointer: coarse) {
        .tips {
          grid-template-columns: repeat(auto-fill, minmax(48px, 1fr));
        }
      }
      img {
        width: 100%;
        height: 100%;
        object-fit: contain;
      }
      .disc {
        width: 60%;
        aspect-ratio: 1;
        border-radius: 50%;
        background: currentColor;
        forced-color-adjust: none;
      }
    `,
  ];

  get #words(): Strings["tips"] {
    return this.strings.tips;
  }

  protected watched({ design, demos, toolSettings }: EditorState): readonly unknown[] {
    return [design.assets, demos, toolSettings.tip, toolSettings.tinted];
  }

  override render(): TemplateResult {
    const { design, demos, toolSettings } = this.state;
    const { tip, tinted } = toolSettings;
    const { tips } = this.editor;
    const own = tipsOf(design);
    // A tip that has not painted yet is none of the design's.
    if (tip !== null && !own.some(({ asset }) => asset.uri === tip.asset.uri)) own.push(tip);
    const choose = (): void =>
      pickFiles({ accept: ACCEPT.picture, multiple: false }, ([file]) => {
        if (file) void tips.useFile(file.file);
      });
    return html`
      <div class="tips" role="group" aria-label=${this.#words.inDesign}>
        <button
          data-tip="round"
          aria-label=${this.strings.tools.roundTip}
          title=${this.strings.tools.roundTip}
          aria-pressed=${tip === null}
          @click=${() => tips.use(null)}
        >
          <span class="disc"></span>
        </button>
        ${own.map((each) => this.#tile(each))}
      </div>
      ${
        demos
          ? html`<h3>${this.strings.decals.palette}</h3>
              <div class="tips" role="group" aria-label=${this.strings.decals.palette}>
                ${demos.decals.map(
                  (decal) => html`<button
                    data-demo=${decal.id}
                    aria-label=${decal.name}
                    title=${decal.name}
                    @click=${() => void tips.useDemo(decal)}
                  >
                    <img src=${new URL(decal.picture, demos.page).href} alt="" loading="lazy" draggable="false" />
                  </button>`,
                )}
              </div>`
          : nothing
      }
      <button class="outlined" id="tip-file" @click=${choose}>${icon(ImagePlus)}${this.#words.ownPicture}</button>
      ${
        tip === null
          ? nothing
          : checkField("tool-tinted", this.strings.tools.tinted, tinted, (on) =>
              this.editor.tools.configure({ tinted: on }),
            )
      }
    `;
  }

  #tile(tip: BrushTip): TemplateResult {
    const chosen = this.state.toolSettings.tip?.asset.uri === tip.asset.uri;
    return html`<button
      data-tip=${tip.name}
      aria-label=${tip.name}
      title=${tip.name}
      aria-pressed=${chosen}
      @click=${() => this.editor.tips.use(tip)}
    >
      <img src=${tip.asset.uri} alt="" draggable="false" />
    </button>`;
  }
}
customElements.define("tc-tip-picker", TipPicker);
