/** What a text layer says and how it looks, as fields; live while they are changed, one step of the history each. */
import { css, html, nothing, type TemplateResult } from "lit";
import { AlignCenter, AlignLeft, AlignRight, FileUp, Ratio } from "lucide";
import { SHIPPED_FONTS, type ShippedFontId, shippedFontOf } from "../../engine/shipped-fonts.ts";
import type { Align, TextLayer } from "../document/index.ts";
import { bytesOf } from "../files/file-bytes.ts";
import { layerById } from "../state/design-edits.ts";
import type { EditorState } from "../state/editor-state.ts";
import { emBounds, emOf, withEm } from "../state/text-box.ts";
import { shippedFont, type TextPatch } from "../state/text-commands.ts";
import type { Strings } from "../strings.ts";
import { ACCEPT } from "../ui/accepted-files.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { pickFiles } from "../ui/file-picker.ts";
import { loadOwnPreview, loadShippedPreviews, shippedFamily } from "../ui/font-previews.ts";
import { icon } from "../ui/icon.ts";
import "../ui/menu.ts";
import { controls } from "../ui/controls.ts";
import type { MenuItem } from "../ui/menu.ts";
import type { NumberFieldEvent } from "../ui/number-field.ts";
import { readonlyFields } from "../ui/readonly-fields.ts";
import { recentColors } from "../ui/recent-colors.ts";
import { TypingEnd } from "../ui/typing-end.ts";
import { lengthStep, numberField, recordedOf } from "./property-controls.ts";
import { checkField } from "./property-fields.ts";
import { propertyStyles } from "./property-styles.ts";

const ALIGN_ICONS = { left: AlignLeft, center: AlignCenter, right: AlignRight } as const;
const FIRST_OUTLINE = { color: "#ffffff", width: 0.06 } as const;
/** Milliseconds of rest after which what was typed is a step: a page that is closed then keeps it. */
const REST = 1000;

interface NumberOptions {
  readonly id: string;
  readonly label: string;
  readonly hint?: string;
  readonly unit?: string;
  readonly value: number;
  readonly step: number;
  readonly min: number;
  readonly max: number;
  readonly patch: (value: number) => TextPatch;
}

export class TextFields extends EditorElement {
  /** Of the layer whose words stand in the field. */
  #typedId: string | null = null;

  static override styles = [
    controls,
    propertyStyles,
    css`
      textarea {
        width: 100%;
        min-height: 4.25rem;
        padding: var(--space-2);
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--surface);
        color: inherit;
        font: inherit;
        line-height: 1.35;
        resize: vertical;
        field-sizing: content;
        max-height: 12rem;
      }
      textarea:focus {
        border-color: var(--accent);
      }
      tc-menu {
        display: block;
        min-width: 0;
      }
      .aligns button {
        min-height: var(--target);
      }
      .colors {
        display: flex;
        align-items: center;
        gap: var(--space-2);
      }
      .colors tc-number {
        flex: 1;
      }
      .note {
        padding: var(--space-2);
        border-radius: var(--radius);
        background: var(--surface-low);
        line-height: 1.4;
      }
      .note b {
        font-weight: 600;
        letter-spacing: 0.15em;
      }
    `,
  ];

  /** Until what was typed is recorded. */
  #rest: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    new TypingEnd(this);
  }

  get #words(): Strings["text"] {
    return this.strings.text;
  }

  protected watched({ design, selectedId, textToType, toolSettings, model }: EditorState): readonly unknown[] {
    return [layerById(design, selectedId), textToType, design.assets, toolSettings.recent, model];
  }

  protected override updated(): void {
    const { design, textToType, selectedId } = this.state;
    const area = this.renderRoot.querySelector("textarea");
    const layer = layerById(design, selectedId);
    if (!area || layer?.type !== "text") return;
    // What is being typed is ahead of what is shown on the model, and must not be put back to it.
    if (area !== this.shadowRoot?.activeElement || this.#typedId !== layer.id) area.value = layer.text;
    this.#typedId = layer.id;
    if (textToType === null || textToType !== selectedId) return;
    this.editor.store.set({ textToType: null });
    area.focus();
    area.select();
  }

  override render(): TemplateResult {
    const { design, selectedId } = this.state;
    const layer = layerById(design, selectedId);
    if (layer?.type !== "text") return html``;
    const fields = html`
      <section role="group" aria-label=${this.#words.name}>
        ${this.#wordsField(layer)}${this.#missing(layer)}
        <div class="field">
          <span id="font-label">${this.#words.font}</span>
          ${this.#fonts(layer)}
        </div>
        ${this.#align(layer)}
        <div class="two">
          ${this.#size(layer)}
          ${this.#number(layer, {
            id: "spacing",
            label: this.#words.spacing,
            hint: this.#words.spacingHint,
            unit: this.strings.properties.percent,
            value: round(layer.letterSpacing * 100),
            step: 1,
            min: -100,
            max: 1000,
            patch: (value) => ({ letterSpacing: value / 100 }),
          })}
        </div>
        ${this.#number(layer, {
          id: "curve",
          label: this.#words.curve,
          hint: this.#words.curveHint,
          unit: this.strings.properties.degrees,
          value: round(layer.curve),
          step: 1,
          min: -360,
          max: 360,
          patch: (value) => ({ curve: value }),
        })}
        ${this.#color(layer)}${this.#outline(layer)}
        ${
          this.editor.texts.isClose(layer)
            ? nothing
            : html`<button class="outlined" id="fit-box" @click=${() => void this.editor.texts.fitBox(layer)}>
                ${icon(Ratio)}${this.#words.fitBox}
              </button>`
        }
      </section>
    `;
    return readonlyFields(this.state.readonly, this.strings.readonly.why, fields);
  }

  #wordsField(layer: TextLayer): TemplateResult {
    const { texts } = this.editor;
    const value = (event: Event): string => (event.target as HTMLTextAreaElement).value;
    const label = this.strings.steps.change(this.#words.name);
    const record = (event: Event): void => {
      clearTimeout(this.#rest);
      void texts.change(layer.id, { text: value(event) }, label);
    };
    const type = (event: Event): void => {
      const text = value(event);
      void texts.preview(layer.id, { text });
      clearTimeout(this.#rest);
      this.#rest = setTimeout(() => void texts.change(layer.id, { text }, label), REST);
    };
    return html`<textarea
      id="text"
      dir="auto"
      rows="2"
      maxlength="10000"
      spellcheck="false"
      aria-label=${this.#words.words}
      @input=${type}
      @change=${record}
    ></textarea>`;
  }

  #missing(layer: TextLayer): TemplateResult | typeof nothing {
    if (layer.text.trim() === "") return html`<p class="note" role="status">${this.#words.empty}</p>`;
    const room = this.editor.texts.measureOf(layer);
    if (room === undefined) {
      // A font that cannot be had is told by the engine.
      void this.editor.texts.measure(layer).then(
        () => this.requestUpdate(),
        () => undefined,
      );
      return nothing;
    }
    if (room.missing.length === 0) return nothing;
    return html`<p class="note" role="status">${this.#words.missing} <b>${room.missing.slice(0, 20).join(" ")}</b></p>`;
  }

  #fonts(layer: TextLayer): TemplateResult {
    const { texts, library } = this.editor;
    const asset = this.state.design.assets[layer.font];
    const own = library.font(asset);
    const current = shippedFontOf(asset?.uri ?? "");
    const label = this.strings.steps.change(this.#words.font);
    const shipped = (Object.keys(SHIPPED_FONTS) as ShippedFontId[]).map(
      (id): MenuItem => ({
        label: SHIPPED_FONTS[id].name,
        family: shippedFamily(id),
        checked: id === current,
        run: () => void texts.change(layer.id, { fontAsset: shippedFont(id) }, label),
      }),
    );
    const ownItem: MenuItem[] = own
      ? [{ label: own.name, family: loadOwnPreview(own), checked: true, run: () => {} }]
      : [];
    const file: MenuItem = {
      label: this.#words.ownFont,
      hint: this.#words.ownFontHint,
      icon: FileUp,
      separated: true,
      run: () => pickFiles({ accept: ACCEPT.font, multiple: false }, (files) => void this.#takeFont(files[0]?.file)),
    };
    const name = own?.name ?? (current ? SHIPPED_FONTS[current].name : layer.font);
    return html`<tc-menu
      id="font"
      .label=${name}
      .name=${this.#words.fontOf(name)}
      .items=${[...ownItem, ...shipped, file]}
      @click=${loadShippedPreviews}
      @keydown=${loadShippedPreviews}
    ></tc-menu>`;
  }

  async #takeFont(file: File | undefined): Promise<void> {
    if (!file) return;
    try {
      await this.editor.texts.useFontFile(file.name, await bytesOf(file), null);
    } catch (thrown) {
      this.editor.board.error(this.strings.errors.couldNotOpen(file.name), thrown);
    }
  }

  #align(layer: TextLayer): TemplateResult {
    const choose = (align: Align): void =>
      void this.editor.texts.change(layer.id, { align }, this.strings.steps.change(this.#words.align));
    return html`
      <div class="field" role="group" aria-label=${this.#words.align}>
        <span>${this.#words.align}</span>
        <div class="buttons aligns">
          ${(Object.keys(ALIGN_ICONS) as Align[]).map(
            (align) => html`<button
              class="icon"
              id=${`align-${align}`}
              aria-pressed=${layer.align === align}
              aria-label=${this.#words.aligns[align]}
              title=${this.#words.aligns[align]}
              @click=${() => choose(align)}
            >
              ${icon(ALIGN_ICONS[align])}
            </button>`,
          )}
        </div>
      </div>
    `;
  }

  /** The em's height; the box goes with it. */
  #size(layer: TextLayer): TemplateResult {
    const { editor, state } = this;
    const { kind } = layer.projector;
    const isLength = kind === "planar" || kind === "cylindrical";
    const step = isLength ? lengthStep(state) : 0.01;
    const { min, max } = emBounds(layer);
    const context = { editor, state, ids: [layer.id] };
    return numberField(context, this.#words.size, {
      label: this.#words.sizeLetter,
      name: this.#words.size,
      hint: this.#words.sizeHint,
      unit: kind === "perspective" ? this.strings.properties.degrees : "",
      value: emOf(layer),
      step,
      isLength,
      min: Math.max(step / 10, min),
      max,
      patch: (em) => editor.decals.placed(layer.id, withEm(recordedOf(context, layer), em)),
    });
  }

  #color(layer: TextLayer): TemplateResult {
    return html`
      <div class="field">
        <label for="text-color">${this.strings.properties.color}</label>
        ${this.#swatch("text-color", layer, layer.color, (color) => ({ color }))}
      </div>
    `;
  }

  #outline(layer: TextLayer): TemplateResult {
    const { outline } = layer;
    const label = this.strings.steps.change(this.#words.outline);
    const toggle = (on: boolean): void =>
      void this.editor.texts.change(layer.id, { outline: on ? FIRST_OUTLINE : null }, label);
    return html`
      ${checkField("outline", this.#words.outline, outline !== null, toggle)}
      ${
        outline === null
          ? nothing
          : html`<div class="colors">
              ${this.#swatch("outline-color", layer, outline.color, (color) => ({ outline: { ...outline, color } }))}
              ${this.#number(layer, {
                id: "outline-width",
                label: this.#words.outlineLetter,
                hint: this.#words.outlineHint,
                unit: this.strings.properties.percent,
                value: round(outline.width * 100),
                step: 0.5,
                min: 0.1,
                max: 100,
                patch: (value) => ({ outline: { ...outline, width: value / 100 } }),
              })}
            </div>`
      }
    `;
  }

  #swatch(id: string, layer: TextLayer, value: string, patch: (color: string) => TextPatch): TemplateResult {
    const { texts } = this.editor;
    // The field knows no alpha: what there is stays.
    const color = (event: Event): string => (event.target as HTMLInputElement).value + value.slice(7);
    const label = this.strings.steps.change(id === "text-color" ? this.strings.properties.color : this.#words.outline);
    return html`<input
      type="color"
      id=${id}
      list=${`${id}-recent`}
      aria-label=${id === "text-color" ? this.strings.properties.color : this.#words.outlineColor}
      .value=${value.slice(0, 7)}
      @input=${(event: Event) => void texts.preview(layer.id, patch(color(event)))}
      @change=${(event: Event) => void texts.change(layer.id, patch(color(event)), label)}
    />${recentColors(`${id}-recent`, this.state.toolSettings.recent)}`;
  }

  #number(layer: TextLayer, { id, label, hint = "", unit = "", value, step, min, max, patch }: NumberOptions) {
    const { texts } = this.editor;
    const change = (event: Event): void => {
      const { value: next, repeated } = detailOf(event);
      void texts.change(
        layer.id,
        patch(next),
        this.strings.steps.change(label),
        repeated ? `${id}:${layer.id}` : undefined,
      );
    };
    return html`<tc-number
      data-field=${id}
      .label=${label}
      .name=${label}
      .hint=${hint}
      .unit=${unit}
      .value=${value}
      .step=${step}
      .min=${min}
      .max=${max}
      @field-preview=${(event: Event) => void texts.preview(layer.id, patch(detailOf(event).value))}
      @field-change=${change}
      @field-cancel=${() => texts.cancelPreview()}
    ></tc-number>`;
  }
}
customElements.define("tc-text-fields", TextFields);

const detailOf = (event: Event): NumberFieldEvent => (event as CustomEvent<NumberFieldEvent>).detail;
const round = (value: number): number => Math.round(value * 100) / 100;
