/** Everything about the selected layer, as fields. */
import { html, nothing, type TemplateResult } from "lit";
import { Link2, Ratio, TrianglesCenterlineDashedHorizontal, TrianglesCenterlineDashedVertical, Unlink2 } from "lucide";
import type { PlanarProjector, Projector, Vec3 } from "../../engine/engine-api.ts";
import { type DecalLayer, type DesignLayer, type FillLayer, materialsOf, type StrokeLayer } from "../document/index.ts";
import { layerById } from "../state/design-edits.ts";
import type { EditorState } from "../state/editor-state.ts";
import type { LayerPatch } from "../state/layer-commands.ts";
import { type Orientation, orientationOf } from "../state/rotation.ts";
import { strings } from "../strings.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import type { NumberFieldEvent } from "../ui/number-field.ts";
import { controls } from "../ui/theme.ts";
import { thumbnail, thumbnailStyles } from "../ui/thumbnail.ts";
import {
  type PosedProjector,
  type ProjectorField,
  type ProjectorFieldGroup,
  poseFields,
  projectorFields,
  withAxis,
} from "./projector-fields.ts";
import { mirrorFields, projectionTools } from "./projector-tools.ts";
import { checkField, choiceField } from "./property-fields.ts";
import { propertyStyles } from "./property-styles.ts";

const words = strings.properties;
/** Milliseconds between two changes of the numbers: a score of fields, which nobody reads faster while a decal is dragged. */
const PACE = 80;
/** A choice of the list of materials, beside their indices. */
const ALL_MET = "all-met";

interface FieldOptions extends Omit<ProjectorField, "set"> {
  readonly patch: (value: number) => LayerPatch;
}

export class DecalProperties extends EditorElement {
  static override properties = { proportional: { state: true } };
  /** Width and height change together. */
  declare proportional: boolean;
  /** The direction last shown: straight up and down it keeps the heading that the rotation alone has lost. */
  #orientation: Orientation | undefined;

  static override styles = [controls, thumbnailStyles, propertyStyles];

  constructor() {
    super(PACE);
    this.proportional = true;
  }

  protected watched({ design, selectedId, model }: EditorState): readonly unknown[] {
    return [layerById(design, selectedId), model];
  }

  override render(): TemplateResult {
    const { design, selectedId } = this.state;
    const layer = layerById(design, selectedId);
    if (layer?.type === "decal")
      return html`${this.#header(layer)}${projectionTools(this.editor, layer)}${this.#placement(layer, layer.projector)}${this.#mirror(layer)}${this.#look(layer)}${this.#reach(layer)}`;
    if (layer?.type === "stroke") return html`${this.#header(layer)}${this.#look(layer)}${this.#reach(layer)}`;
    if (layer?.type === "fill") return html`${this.#header(layer)}${this.#fill(layer)}`;
    return html`<div class="none">
      <h2>${words.none}</h2>
      <p class="quiet">${words.noneBody}</p>
    </div>`;
  }

  #header(layer: DecalLayer | StrokeLayer | FillLayer): TemplateResult {
    const input = (event: Event): HTMLInputElement => event.target as HTMLInputElement;
    const keys = (event: KeyboardEvent): void => {
      if (event.key === "Escape") input(event).value = layer.name;
      if (event.key === "Escape" || event.key === "Enter") input(event).blur();
    };
    return html`
      <div class="header">
        ${thumbnail(this.editor.library, this.state.design, layer)}
        <input
          type="text"
          id="name"
          aria-label=${words.name}
          .value=${layer.name}
          maxlength="200"
          @keydown=${keys}
          @change=${(event: Event) => this.editor.layers.rename(layer.id, input(event).value)}
        />
      </div>
    `;
  }

  #placement(layer: DecalLayer, projector: Projector): TemplateResult {
    const step = this.#lengthStep();
    return html`
      <section aria-label=${words.placement}>
        ${projector.kind === "uv" ? nothing : this.#pose(layer, projector, step)}
        ${
          projector.kind === "planar"
            ? this.#size(layer, projector, step)
            : projectorFields(projector, step).map((group) => this.#group(layer, group))
        }
      </section>
    `;
  }

  #mirror(layer: DecalLayer) {
    const { mirrorOffset, mirrorOffsetHint } = strings.projection;
    return mirrorFields(this.editor, layer, (mirror) =>
      this.#number(layer, mirrorOffset, {
        label: mirror.axis.toUpperCase(),
        name: mirrorOffset,
        hint: mirrorOffsetHint,
        value: mirror.offset,
        step: this.#lengthStep(),
        patch: (offset) => ({ mirror: { ...mirror, offset } }),
      }),
    );
  }

  #pose(layer: DecalLayer, projector: PosedProjector, step: number): TemplateResult[] {
    this.#orientation = orientationOf(projector.rotation, this.#orientation);
    const groups = poseFields(projector, step, this.#orientation, (orientation) => {
      this.#orientation = orientation;
    });
    return groups.map((group) => this.#group(layer, group));
  }

  #group(layer: DecalLayer, { title, fields }: ProjectorFieldGroup): TemplateResult {
    return html`
      <h3>${title}</h3>
      <div class=${fields.length === 3 ? "three" : "two"}>
        ${fields.map(({ set, ...field }) =>
          this.#number(layer, title, { ...field, patch: (value) => ({ projector: set(value) }) }),
        )}
      </div>
    `;
  }

  #size(layer: DecalLayer, projector: PlanarProjector, step: number): TemplateResult {
    const picture = this.editor.library.get(this.state.design.assets[layer.asset]);
    const resized = (axis: 0 | 1 | 2, value: number): LayerPatch => {
      const size = withAxis(projector.size, axis, value);
      const other = axis === 0 ? 1 : 0;
      const linked = this.proportional && axis !== 2;
      return {
        projector: {
          ...projector,
          size: linked ? withAxis(size, other, (projector.size[other] * value) / projector.size[axis]) : size,
        },
      };
    };
    const field = (axis: 0 | 1 | 2, side: "width" | "height" | "depth", hint = "") =>
      this.#number(layer, words.size, {
        label: words.sizeLetters[side],
        name: words.axis(words.size, words[side]),
        hint,
        value: projector.size[axis],
        step,
        min: step / 100,
        patch: (value) => resized(axis, value),
      });
    const own = picture ? picture.width / picture.height : 1;
    const reset = (): void => {
      const [width, , depth] = projector.size;
      const size: Vec3 = [width, width / own, depth];
      this.editor.layers.change(layer.id, { projector: { ...projector, size } }, strings.steps.change(words.size));
    };
    const distorted = Math.abs(projector.size[0] / projector.size[1] / own - 1) > 1e-3;
    return html`
      <div class="titled">
        <h3>${words.size}</h3>
        ${
          distorted
            ? html`<button class="icon small" id="reset-proportions" aria-label=${words.resetProportions} title=${words.resetProportions} @click=${reset}>
                ${icon(Ratio)}
              </button>`
            : nothing
        }
        <button
          class="icon small"
          id="proportional"
          aria-pressed=${this.proportional}
          aria-label=${words.keepProportions}
          title=${words.keepProportions}
          @click=${() => {
            this.proportional = !this.proportional;
          }}
        >
          ${icon(this.proportional ? Link2 : Unlink2)}
        </button>
      </div>
      <div class="three">${field(0, "width")}${field(1, "height")}${field(2, "depth", words.depthHint)}</div>
    `;
  }

  #look(layer: DecalLayer | StrokeLayer): TemplateResult {
    const { layers } = this.editor;
    const flip = (key: "flipX" | "flipY", label: string, drawing: typeof Link2) => html`
      <button
        class="icon"
        id=${key}
        aria-pressed=${layer[key]}
        aria-label=${label}
        title=${label}
        @click=${() => layers.change(layer.id, { [key]: !layer[key] }, strings.steps.change(words.flip))}
      >
        ${icon(drawing)}
      </button>
    `;
    return html`
      <section aria-label=${words.look}>
        ${this.#opacity(layer)}${this.#mixing(layer)}
        ${this.#choice(layer, "filter", words.filter, { linear: words.filterLinear, nearest: words.filterNearest })}
        ${this.#choice(layer, "wrap", words.wrap, { none: words.wrapNone, repeat: words.wrapRepeat })}
        <div class="field">
          <span>${words.flip}</span>
          <div class="buttons">
            ${flip("flipX", words.flipX, TrianglesCenterlineDashedVertical)}${flip("flipY", words.flipY, TrianglesCenterlineDashedHorizontal)}
          </div>
        </div>
      </section>
    `;
  }

  #reach(layer: DecalLayer | StrokeLayer): TemplateResult {
    const [start, end] = layer.angleFade;
    const fade = (label: string, value: number, patch: (value: number) => LayerPatch) =>
      this.#number(layer, label, {
        label,
        name: label,
        hint: words.fadeHint,
        unit: words.degrees,
        value,
        step: 1,
        min: 0,
        max: 90,
        patch,
      });
    // A flat stamp lies on the texture: no surface turns away from it or stands before it.
    if (layer.type === "decal" && layer.projector.kind === "uv") return this.#material(layer);
    return html`
      <section aria-label=${words.reach}>
        <h3>${words.reach}</h3>
        <div class="two">
          ${fade(words.fadeStart, start, (value) => ({ angleFade: [value, Math.max(value, end)] }))}
          ${fade(words.fadeEnd, end, (value) => ({ angleFade: [Math.min(start, value), value] }))}
        </div>
        ${this.#toggle(layer, "backfaces", words.backfaces, layer.backfaces, (on) => ({ backfaces: on }))}
        ${this.#toggle(layer, "through", words.through, layer.occlusion === "none", (on) => ({ occlusion: on ? "none" : "self" }))}
        ${this.#material(layer)}
      </section>
    `;
  }

  #fill(layer: FillLayer): TemplateResult {
    const recolour = (event: Event): void => {
      const color = (event.target as HTMLInputElement).value + layer.color.slice(7);
      this.editor.layers.change(layer.id, { color }, strings.steps.change(words.color));
    };
    return html`
      <section aria-label=${words.look}>
        <div class="field">
          <label for="color">${words.color}</label>
          <input type="color" id="color" .value=${layer.color.slice(0, 7)} @change=${recolour} />
        </div>
        ${this.#opacity(layer)}${this.#mixing(layer)}${this.#material(layer)}
      </section>
    `;
  }

  #opacity(layer: DecalLayer | StrokeLayer | FillLayer): TemplateResult {
    const { layers } = this.editor;
    const percent = Math.round(layer.opacity * 1000) / 10;
    const share = (event: Event): number => Number((event.target as HTMLInputElement).value) / 100;
    const label = strings.steps.change(words.opacity);
    return html`
      <div class="field">
        <label for="opacity">${words.opacity}</label>
        <div class="slider">
          <input
            type="range"
            id="opacity"
            min="0"
            max="100"
            .value=${String(percent)}
            @input=${(event: Event) => layers.preview(layer.id, { opacity: share(event) })}
            @change=${(event: Event) => layers.change(layer.id, { opacity: share(event) }, label, `opacity:${layer.id}`)}
          />
          ${this.#number(layer, words.opacity, {
            label: "",
            name: words.opacity,
            unit: words.percent,
            value: percent,
            step: 1,
            min: 0,
            max: 100,
            patch: (value) => ({ opacity: value / 100 }),
          })}
        </div>
      </div>
    `;
  }

  #mixing(layer: DecalLayer | StrokeLayer | FillLayer): TemplateResult {
    const spaces = { srgb: words.blendSpaceSrgb, linear: words.blendSpaceLinear };
    return html`
      ${this.#choice(layer, "blendSpace", words.blendSpace, spaces)}
      ${this.#toggle(layer, "lockAlpha", words.lockAlpha, layer.lockAlpha, (on) => ({ lockAlpha: on }))}
    `;
  }

  #toggle({ id }: DesignLayer, name: string, label: string, on: boolean, patch: (on: boolean) => LayerPatch) {
    const change = (next: boolean): void => this.editor.layers.change(id, patch(next), strings.steps.change(label));
    return checkField(name, label, on, change);
  }

  #choice<K extends "filter" | "wrap" | "blendSpace">(
    layer: Pick<DecalLayer, "id" | K>,
    key: K,
    label: string,
    options: Record<DecalLayer[K], string>,
  ): TemplateResult {
    return choiceField<DecalLayer[K]>(key, label, options, layer[key], (value) =>
      this.editor.layers.change(layer.id, { [key]: value }, strings.steps.change(label)),
    );
  }

  #material(layer: DecalLayer | StrokeLayer | FillLayer): TemplateResult {
    const materials = this.state.model?.info.materials ?? [];
    const own = materialsOf(layer);
    if (materials.length < 2 && own.every((material) => material === materials[0]?.index)) return html``;
    const choose = (event: Event): void => {
      const select = event.target as HTMLSelectElement;
      if (select.value === ALL_MET) {
        // Where that is what it paints already, nothing is drawn anew: the list must not stay on this word.
        select.value = own.join(" ");
        if (layer.type === "decal") this.editor.decals.paintAllMet(layer);
        return;
      }
      const material = Number(select.value);
      this.editor.layers.change(layer.id, { material }, strings.steps.change(words.material));
      this.editor.showMaterial(material);
    };
    const nameOf = (material: number): string =>
      strings.materialName(material, materials.find(({ index }) => index === material)?.name ?? "");
    const single = own.length === 1 ? own[0] : undefined;
    const listed = single === undefined || !materials.some(({ index }) => index === single);
    return html`
      <div class="field">
        <label for="material">${words.material}</label>
        <select id="material" @change=${choose}>
          ${listed ? html`<option value=${own.join(" ")} .selected=${true} disabled>${own.map(nameOf).join(", ")}</option>` : nothing}
          ${layer.type === "decal" ? html`<option value=${ALL_MET}>${words.materialsMet}</option>` : nothing}
          ${materials.map(
            ({
              index,
              refusal,
            }) => html`<option value=${index} ?disabled=${refusal !== null} .selected=${index === single}>
              ${nameOf(index)}
            </option>`,
          )}
        </select>
      </div>
    `;
  }

  #number(layer: DecalLayer | StrokeLayer | FillLayer, group: string, options: FieldOptions): TemplateResult {
    const { label, name, hint = "", unit = "", value, step, min, max, patch } = options;
    const { layers } = this.editor;
    const detail = (event: Event): NumberFieldEvent => (event as CustomEvent<NumberFieldEvent>).detail;
    const change = (event: Event): void => {
      const { value: next, repeated } = detail(event);
      layers.change(layer.id, patch(next), strings.steps.change(group), repeated ? `${name}:${layer.id}` : undefined);
    };
    return html`<tc-number
      data-field=${name.toLowerCase().replaceAll(" ", "-")}
      .label=${label}
      .name=${name}
      .hint=${hint}
      .unit=${unit}
      .value=${value}
      .step=${step}
      .min=${min ?? Number.NEGATIVE_INFINITY}
      .max=${max ?? Number.POSITIVE_INFINITY}
      @field-preview=${(event: Event) => layers.preview(layer.id, patch(detail(event).value))}
      @field-change=${change}
      @field-cancel=${() => layers.cancelPreview()}
    ></tc-number>`;
  }

  /** Metres a step: a power of ten near a thousandth of the model, so that models of any size feel alike. */
  #lengthStep(): number {
    const info = this.state.model?.info;
    if (!info) return 0.001;
    const diagonal = Math.hypot(...info.boundsMax.map((high, axis) => high - (info.boundsMin[axis] ?? 0)));
    return 10 ** Math.floor(Math.log10(Math.max(diagonal, 1e-9) / 300));
  }
}
customElements.define("tc-decal-properties", DecalProperties);
