/** How a picture is read, and which of the surface a layer reaches. */

import { html, nothing, type TemplateResult } from "lit";
import { type IconNode, TrianglesCenterlineDashedHorizontal, TrianglesCenterlineDashedVertical } from "lucide";
import { type DesignLayer, isPlaced, materialsOf, type PlacedLayer, type StrokeLayer } from "../document/index.ts";
import { icon } from "../ui/icon.ts";
import {
  numberField,
  optionField,
  type PropertyContext,
  record,
  recordedOf,
  toggleField,
} from "./property-controls.ts";

/** A choice of the list of materials, beside their indices. */
const ALL_MET = "all-met";

type FadeRange = ThrownLayer["angleFade"];
type ThrownLayer = PlacedLayer | StrokeLayer;

export function samplingFields(context: PropertyContext, layer: ThrownLayer): TemplateResult {
  const words = context.editor.strings.properties;
  const flip = (key: "flipX" | "flipY", label: string, drawing: IconNode) => html`
    <button
      class="icon"
      id=${key}
      aria-pressed=${layer[key]}
      aria-label=${label}
      title=${label}
      @click=${() => record(context, words.flip, { [key]: !layer[key] })}
    >
      ${icon(drawing)}
    </button>
  `;
  const filters = { linear: words.filterLinear, nearest: words.filterNearest };
  const wraps = { none: words.wrapNone, repeat: words.wrapRepeat };
  return html`
    ${optionField(context, "filter", words.filter, filters, layer.filter, (filter) => ({ filter }))}
    ${optionField(context, "wrap", words.wrap, wraps, layer.wrap, (wrap) => ({ wrap }))}
    <div class="field">
      <span>${words.flip}</span>
      <div class="buttons">
        ${flip("flipX", words.flipX, TrianglesCenterlineDashedVertical)}${flip("flipY", words.flipY, TrianglesCenterlineDashedHorizontal)}
      </div>
    </div>
  `;
}

export function reachFields(context: PropertyContext, layer: ThrownLayer): TemplateResult | typeof nothing {
  const words = context.editor.strings.properties;
  const [start, end] = layer.angleFade;
  /** The other end makes way. */
  const fade = (label: string, value: number, fadeOf: (value: number, start: number, end: number) => FadeRange) =>
    numberField(context, label, {
      label,
      name: label,
      hint: words.fadeHint,
      unit: words.degrees,
      value,
      step: 1,
      min: 0,
      max: 90,
      patch: (next) => ({ angleFade: fadeOf(next, ...recordedOf(context, layer).angleFade) }),
    });
  // A flat stamp lies on the texture: no surface turns away from it or stands before it.
  if (layer.type !== "stroke" && layer.projector.kind === "uv") return materialField(context, layer);
  return html`
    <section role="group" aria-label=${words.reach}>
      <h3>${words.reach}</h3>
      <div class="two">
        ${fade(words.fadeStart, start, (value, _start, end) => [value, Math.max(value, end)])}
        ${fade(words.fadeEnd, end, (value, start) => [Math.min(start, value), value])}
      </div>
      ${toggleField(context, "backfaces", words.backfaces, layer.backfaces, (on) => ({ backfaces: on }))}
      ${toggleField(context, "through", words.through, layer.occlusion === "none", (on) => ({ occlusion: on ? "none" : "self" }))}
      ${materialField(context, layer)}
    </section>
  `;
}

/** Nothing where the model has one material, which the layer paints. */
export function materialField(context: PropertyContext, layer: DesignLayer): TemplateResult | typeof nothing {
  const words = context.editor.strings.properties;
  const { strings } = context.editor;
  const { editor, state } = context;
  const materials = state.model?.info.materials ?? [];
  const own = materialsOf(layer);
  if (materials.length < 2 && own.every((material) => material === materials[0]?.index)) return nothing;
  const choose = (event: Event): void => {
    const select = event.target as HTMLSelectElement;
    if (select.value === ALL_MET) {
      // Where that is what it paints already, nothing is drawn anew: the list must not stay on this word.
      select.value = own.join(" ");
      if (isPlaced(layer)) editor.decals.paintAllMet(layer);
      return;
    }
    const material = Number(select.value);
    // Faces are counted in their own material: in another one they would be any.
    record(context, words.material, layer.type === "fill" ? { material, parts: null } : { material });
    editor.showMaterial(material);
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
        ${isPlaced(layer) ? html`<option value=${ALL_MET}>${words.materialsMet}</option>` : nothing}
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
