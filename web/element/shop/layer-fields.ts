/** The fields of what is chosen: its words, its size, its turn. */

import { html, nothing, type TemplateResult } from "lit";
import { type DesignLayer, isPlaced, type TextLayer } from "../../editor/document/design.ts";
import { layerById } from "../../editor/state/design-edits.ts";
import { diagonalOf } from "../../editor/state/design-state.ts";
import { scaledProjector, spunProjector } from "../../editor/state/projector-steps.ts";
import { orientationOf } from "../../editor/state/rotation.ts";
import "../../editor/ui/number-field.ts";
import type { NumberField, NumberFieldEvent, Refusal } from "../../editor/ui/number-field.ts";
import type { Projector } from "../../engine/engine-api.ts";
import { SHIPPED_FONTS, type ShippedFontId, shippedFontOf } from "../../engine/shipped-fonts.ts";
import type { Desk } from "../desk/desk.ts";
import { shippedFont, type TextPatch, type Texts } from "../desk/texts.ts";
import type { ModeHost } from "../mode.ts";

/** Of the model's diagonal: what is wider by far is a slip of the keys, and shows one colour. */
const MOST_SIZE = 10;

export interface FieldsHost {
  readonly host: ModeHost;
  readonly desk: Desk;
  readonly texts: Texts;
  /** Printed metres a metre of the model. */
  readonly printScale: number;
}

export function layerFields(view: FieldsHost, layer: DesignLayer): TemplateResult | typeof nothing {
  if (!isPlaced(layer)) return nothing;
  return html`
    <div class="fields" part="fields" role="group" aria-label=${layer.name}>
      ${layer.type === "text" ? textFields(view, layer) : nothing} ${sizeFields(view, layer.id, layer.projector)}
    </div>
  `;
}

function textFields({ host: { words, tell }, texts, desk }: FieldsHost, layer: TextLayer): TemplateResult {
  const uri = desk.design.assets[layer.font]?.uri ?? "";
  const font = shippedFontOf(uri);
  const change = (patch: TextPatch, { type, target }: Event): void => {
    const field = target as HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement;
    const { value } = field;
    texts.change(layer.id, patch, type === "change").catch((thrown: unknown) => {
      // What could not be done is not to be read in the field, unless it says something newer by now.
      const shown = layerById(desk.shown, layer.id);
      if (field.value === value && shown?.type === "text") field.value = saidOf(shown, patch, desk);
      desk.keepShown();
      tell(thrown);
    });
  };
  const type = (event: Event): void => {
    const area = event.target as HTMLTextAreaElement;
    // Left without words, the field says again what is on the product.
    if (event.type === "change" && !area.value.trim()) area.value = layer.text;
    if (area.value.trim()) change({ text: area.value }, event);
  };
  const dye = (event: Event): void => change({ color: (event.target as HTMLInputElement).value }, event);
  return html`
    <label class="field wide">
      ${words.words}
      <textarea
        rows="1"
        maxlength="1000"
        dir="auto"
        .value=${layer.text}
        @input=${type}
        @change=${type}
      ></textarea>
    </label>
    <label class="field">
      ${words.font}
      <select
        @change=${(event: Event) => {
          change({ font: shippedFont((event.target as HTMLSelectElement).value as ShippedFontId) }, event);
        }}
      >
        ${font === undefined ? html`<option selected disabled>${layer.font}</option>` : nothing}
        ${Object.entries(SHIPPED_FONTS).map(
          ([id, { name }]) => html`<option value=${id} ?selected=${id === font}>${name}</option>`,
        )}
      </select>
    </label>
    <label class="field">
      ${words.color}
      <input
        type="color"
        .value=${layer.color.slice(0, 7)}
        @input=${dye}
        @change=${dye}
      />
    </label>
  `;
}

/** What a text's field says of what is on the product. */
function saidOf({ text, color, font }: TextLayer, patch: TextPatch, desk: Desk): string {
  if (patch.text !== undefined) return text;
  return patch.color === undefined ? (shippedFontOf(desk.shown.assets[font]?.uri ?? "") ?? font) : color.slice(0, 7);
}

function sizeFields(view: FieldsHost, id: string, projector: Projector): TemplateResult {
  const { words } = view.host;
  const size = sizeOf(projector);
  const scale = view.printScale * 100;
  const most = diagonalOf(view.desk.store.state.model) * MOST_SIZE;
  return html`
    ${
      size === null
        ? nothing
        : (["width", "height"] as const).map((side) =>
            number(view, id, {
              name: words[side],
              unit: words.centimetres,
              value: size[side] * scale,
              step: 0.1,
              min: 0.01,
              max: Math.max(most, size[side]) * scale,
              set: (value) => scaledProjector(projector, value / (size[side] * scale)),
            }),
          )
    }
    ${number(view, id, {
      name: words.turn,
      unit: words.degrees,
      value: turnOf(projector),
      step: 1,
      min: -360,
      max: 360,
      set: (value) => spunProjector(projector, value - turnOf(projector)),
    })}
    ${
      projector.kind === "planar"
        ? number(view, id, {
            name: words.depth,
            unit: words.centimetres,
            value: projector.size[2] * scale,
            step: 0.1,
            min: 0.01,
            max: Math.max(most, projector.size[2]) * scale,
            set: (value) => ({ ...projector, size: [projector.size[0], projector.size[1], value / scale] }),
          })
        : nothing
    }
  `;
}

interface NumberSettings {
  readonly name: string;
  readonly unit: string;
  readonly value: number;
  readonly step: number;
  readonly min: number;
  readonly max: number;
  readonly set: (value: number) => Projector;
}

function number(
  view: FieldsHost,
  id: string,
  { name, unit, set, value, step, min, max }: NumberSettings,
): TemplateResult {
  const place = ({ type, detail }: CustomEvent<NumberFieldEvent>): void => {
    view.desk.place(id, set(detail.value), type === "field-change", detail.repeated ? `field-${name}` : undefined);
  };
  return html`<tc-number
    .label=${name}
    .name=${name}
    .unit=${unit}
    .value=${value}
    .step=${step}
    .min=${min}
    .max=${max}
    @field-preview=${place}
    @field-change=${place}
    @field-cancel=${() => view.desk.session.cancelPreview()}
    @field-refused=${(event: CustomEvent<Refusal>) => {
      // The shop's page is none of its listeners.
      event.stopPropagation();
      const range = `${event.detail.least} – ${event.detail.most}`;
      (event.target as NumberField).explain(range);
      view.desk.hooks.announce(`${name}: ${range}`);
    }}
  ></tc-number>`;
}

/** Metres; null where a size is not one of lengths. */
export function sizeOf(projector: Projector): { readonly width: number; readonly height: number } | null {
  switch (projector.kind) {
    case "planar":
      return { width: projector.size[0], height: projector.size[1] };
    case "cylindrical":
      return { width: (projector.arc / 180) * Math.PI * projector.radius, height: projector.height };
    default:
      return null;
  }
}

/** Degrees counter-clockwise, as the picture's viewer sees it. */
export function turnOf(projector: Projector): number {
  return projector.kind === "uv" ? -projector.angle : orientationOf(projector.rotation).spin;
}
