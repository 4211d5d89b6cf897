/** The paint target of a material: its size, its gutter, and how well the model is unwrapped. */
import { css, html, nothing, type TemplateResult } from "lit";
import type { TargetInfo } from "../../engine/engine-api.ts";
import { whyNotPaintable } from "../state/bare-parts.ts";
import type { EditorState, TargetSettings as Settings } from "../state/editor-state.ts";
import { materialsToUnwrap, sharesTexels } from "../state/unwrap-command.ts";
import type { Strings } from "../strings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { readonlyFields } from "../ui/readonly-fields.ts";
import { namedFields } from "./named-fields.ts";
import { checkField } from "./property-fields.ts";

const SIZES = [256, 512, 1024, 2048, 4096, 8192];
const GUTTERS = [0, 1, 2, 4, 8, 16, 32, 64];
/** Without a picture of its own a material gets a target of this size. */
const SIZE_WITHOUT_PICTURE = 1024;

export class TargetSettings extends EditorElement {
  static override styles = [
    controls,
    namedFields,
    css`
      :host {
        display: grid;
        gap: var(--space-2);
      }
      dl {
        display: grid;
        grid-template-columns: 5.5rem minmax(0, 1fr);
        gap: var(--space-1) var(--space-2);
        margin: var(--space-1) 0 0;
        font-variant-numeric: tabular-nums;
      }
      /* As the fields above. */
      @media (max-width: 15rem) {
        dl {
          grid-template-columns: minmax(0, 1fr);
        }
      }
      dt {
        color: var(--text-quiet);
      }
      dd {
        margin: 0;
        padding-inline-start: var(--space-2);
      }
      .check {
        display: flex;
        align-items: center;
        gap: var(--space-2);
        min-height: var(--target);
        cursor: pointer;
      }
      .warning {
        padding: var(--space-2) var(--space-3);
        border-radius: var(--radius);
        background: var(--surface-low);
        color: var(--text-quiet);
        line-height: 1.4;
      }
    `,
  ];

  get #words(): Strings["target"] {
    return this.strings.target;
  }

  protected watched({
    model,
    material,
    targets,
    targetSettings,
    usualTarget,
    toolSettings,
  }: EditorState): readonly unknown[] {
    return [model, material, targets, targetSettings, usualTarget, toolSettings.pixelMode];
  }

  override render(): TemplateResult {
    const { model, material, targets, targetSettings, usualTarget, readonly } = this.state;
    if (!model || material === null) return html`<p class="quiet">${this.strings.stage.emptyTitle}</p>`;
    const settings = targetSettings.get(material) ?? usualTarget;
    const { textureSize } = model.info.materials.find(({ index }) => index === material) ?? { textureSize: null };
    const [ownWidth, ownHeight] = textureSize ?? [SIZE_WITHOUT_PICTURE, SIZE_WITHOUT_PICTURE];
    const target = targets.get(material);
    const { editor } = this;
    return html`
      <div class="field">
        <label for="material">${this.#words.material}</label>
        <select id="material" @change=${(event: Event) => editor.showMaterial(Number(chosen(event)))}>
          ${model.info.materials.map(({ index, name, refusal }) => {
            const label = this.strings.materialName(index, name);
            return html`<option value=${index} ?disabled=${refusal !== null} ?selected=${index === material}>
              ${refusal ? this.#words.notPaintable(label, whyNotPaintable(refusal.code, this.strings)) : label}
            </option>`;
          })}
        </select>
      </div>
      ${readonlyFields(
        readonly,
        this.strings.readonly.why,
        html`${this.#variants()}${this.#sizes(settings, ownWidth, ownHeight)}`,
      )}
      ${checkField("pixel-mode", this.strings.tools.pixelMode, editor.tools.pixelMode, (pixelMode) =>
        editor.tools.configure({ pixelMode }),
      )}
      ${target ? this.#figures(target) : nothing}
      ${editor.unwrapping && !readonly && materialsToUnwrap(this.state).length > 0 ? this.#unwrap() : nothing}
    `;
  }

  /** Which variant of its materials the model shows, where it has some. */
  #variants(): TemplateResult | typeof nothing {
    const { variants: command, tasks } = this.editor;
    const variants = command?.variants;
    if (!command || !variants) return nothing;
    const { names, shown, hasOwnLook } = variants;
    const show = (event: Event): void => {
      const select = event.target as HTMLSelectElement;
      const shownThen = command.show(select.value === "" ? null : Number(select.value)).then(() => {
        // What could not be shown, which is told, is not chosen either.
        select.value = String(command.variants?.shown ?? "");
      });
      void tasks.quietly(shownThen);
    };
    return html`
      <div class="field">
        <label for="variant">${this.#words.variant}</label>
        <select id="variant" .value=${String(shown ?? "")} @change=${show}>
          ${hasOwnLook || shown === null ? html`<option value="" ?selected=${shown === null}>${this.#words.ownLook}</option>` : nothing}
          ${names.map(
            (name, index) =>
              html`<option value=${index} ?selected=${index === shown}>${name || this.#words.variantNumber(index + 1)}</option>`,
          )}
        </select>
      </div>
    `;
  }

  #sizes(settings: Settings, ownWidth: number, ownHeight: number): TemplateResult {
    const { editor } = this;
    const numberOrNull = (text: string): number | null => (text === "" ? null : Number(text));
    return html`
      <div class="field">
        <label for="size">${this.#words.size}</label>
        <select
          id="size"
          .value=${String(settings.size ?? "")}
          @change=${(event: Event) => editor.configureTarget({ ...settings, size: numberOrNull(chosen(event)) })}
        >
          <option value="" ?selected=${settings.size === null}>${this.#words.ownSize(ownWidth, ownHeight)}</option>
          ${SIZES.map((size) => html`<option value=${size} ?selected=${settings.size === size}>${this.#words.squareSize(size)}</option>`)}
        </select>
      </div>
      <div class="field" title=${this.#words.gutterHint}>
        <label for="gutter">${this.#words.gutter}</label>
        <select
          id="gutter"
          .value=${String(settings.gutter ?? "")}
          @change=${(event: Event) => editor.configureTarget({ ...settings, gutter: numberOrNull(chosen(event)) })}
        >
          <option value="" ?selected=${settings.gutter === null}>${this.#words.gutterAuto}</option>
          ${GUTTERS.map((size) => html`<option value=${size} ?selected=${settings.gutter === size}>${this.#words.texels(String(size))}</option>`)}
        </select>
      </div>
    `;
  }

  /** Below the warning, or where a material has no texture coordinates of use. */
  #unwrap(): TemplateResult {
    const { unwrapping, tasks } = this.editor;
    return html`<button
      class="outlined"
      title=${this.#words.unwrapHint}
      @click=${() => void tasks.quietly(unwrapping?.run() ?? Promise.resolve())}
    >
      ${this.#words.unwrap}
    </button>`;
  }

  #figures(target: TargetInfo): TemplateResult {
    const { width, height, coveredTexels, overlappingTexels } = target;
    const share = (part: number, of: number): string =>
      this.#words.share(of > 0 ? this.strings.numbers.tenths((100 * part) / of) : "0");
    return html`
      <dl>
        <dt>${this.#words.coverage}</dt>
        <dd>${share(coveredTexels, width * height)} · ${this.#words.texels(this.strings.numbers.whole(coveredTexels))}</dd>
        <dt>${this.#words.overlap}</dt>
        <dd>${share(overlappingTexels, coveredTexels)}</dd>
      </dl>
      ${sharesTexels(target) ? html`<p class="warning">${this.#words.overlapWarning}</p>` : nothing}
    `;
  }
}
customElements.define("tc-target-settings", TargetSettings);

const chosen = (event: Event): string => (event.target as HTMLSelectElement).value;
