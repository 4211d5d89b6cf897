/** Adding decals: a picture of one's own, or a demo decal by click or by dragging it onto the model. */
import { css, html, nothing, type TemplateResult } from "lit";
import { ImagePlus, Type } from "lucide";
import type { DemoDecal } from "../files/demo-catalogue.ts";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import { ACCEPT } from "../ui/accepted-files.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { pickFiles } from "../ui/file-picker.ts";
import { icon } from "../ui/icon.ts";

/** Type of a drag from the palette to the model; its data is the demo decal's id. */
export const PALETTE_DRAG = "application/x-texelcast-demo-decal";

export class DecalPalette extends EditorElement {
  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: var(--space-2);
      }
      .adds {
        display: flex;
        gap: var(--space-1);
      }
      .add {
        flex: auto;
        min-height: max(var(--target), 32px);
      }
      .palette {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(30px, 1fr));
        gap: var(--space-1);
      }
      .palette button {
        aspect-ratio: 1;
        min-width: 0;
        padding: 3px;
        background: var(--tile);
        cursor: grab;
      }
      @media (hover: hover) {
        .palette button:hover {
          background: var(--tile-checker);
        }
      }
      /* A finger's tiles do not all have room in one row: two rows of as many each leave none over. */
      @media (pointer: coarse) {
        .palette {
          grid-template-columns: repeat(4, 1fr);
        }
        .palette button {
          height: 44px;
          aspect-ratio: auto;
        }
      }
      /* On a phone one row that scrolls, so that the layers have the room. */
      :host([row]) {
        display: flex;
        overflow: auto hidden;
        scrollbar-width: none;
      }
      :host([row]) .adds {
        display: flex;
        flex: none;
      }
      :host([row]) .add {
        flex: none;
        width: 44px;
        padding: 0;
      }
      :host([row]) .add span {
        display: none;
      }
      :host([row]) .palette {
        display: flex;
      }
      :host([row]) .palette button {
        flex: none;
        width: 44px;
      }
      img {
        width: 100%;
        height: 100%;
        object-fit: contain;
      }
    `,
  ];

  get #words(): Strings["decals"] {
    return this.strings.decals;
  }

  protected watched({ demos, model }: EditorState): readonly unknown[] {
    return [demos, model === null];
  }

  override render(): TemplateResult {
    const { demos, model } = this.state;
    const add = (): void => pickFiles({ accept: ACCEPT.picture }, (files) => void this.editor.files.openFiles(files));
    return html`
      <div class="adds">
        <button class="outlined add" id="add-picture" aria-label=${this.#words.add} ?disabled=${model === null} @click=${add}>
          ${icon(ImagePlus)}<span>${this.#words.add}</span>
        </button>
        <button
          class="outlined add"
          id="add-text"
          aria-label=${this.strings.text.add}
          ?disabled=${model === null}
          @click=${() => void this.editor.texts.add()}
        >
          ${icon(Type)}<span>${this.strings.text.add}</span>
        </button>
      </div>
      ${
        demos && model
          ? html`<div class="palette" role="group" aria-label=${this.#words.palette}>
              ${demos.decals.map((decal) => this.#item(decal, new URL(decal.picture, demos.page).href))}
            </div>`
          : nothing
      }
    `;
  }

  #item(decal: DemoDecal, url: string): TemplateResult {
    const label = this.#words.paletteItem(decal.name);
    const lift = (event: DragEvent): void => event.dataTransfer?.setData(PALETTE_DRAG, decal.id);
    return html`
      <button
        draggable="true"
        data-decal=${decal.id}
        aria-label=${label}
        title=${label}
        @dragstart=${lift}
        @click=${() => void this.editor.files.addDemoDecal(decal)}
      >
        <img src=${url} alt="" loading="lazy" draggable="false" />
      </button>
    `;
  }
}
customElements.define("tc-decal-palette", DecalPalette);
