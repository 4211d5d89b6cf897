/** Fields of the property panel that are bound to layers: what they show, preview and record. */
import { html, type TemplateResult } from "lit";
import { DESIGN_LIMITS } from "../document/design-limits.ts";
import type { DesignLayer } from "../document/index.ts";
import { layerById } from "../state/design-edits.ts";
import { diagonalOf } from "../state/design-state.ts";
import type { Editor } from "../state/editor.ts";
import type { EditorState } from "../state/editor-state.ts";
import type { LayerPatch } from "../state/layer-commands.ts";
import { type LengthUnit, unitFor } from "../tools/length-unit.ts";
import type { NumberFieldEvent } from "../ui/number-field.ts";
import { recentColors } from "../ui/recent-colors.ts";
import type { ProjectorField } from "./projector-fields.ts";
import { checkField, choiceField } from "./property-fields.ts";

/** What fields are about. */
export interface PropertyContext {
  readonly editor: Editor;
  readonly state: EditorState;
  /** Ids of the layers that a change is for. */
  readonly ids: readonly string[];
}

/**
 * A layer without what a scrub only shows so far: what a patch keeps of a layer, it keeps of that, or what a scrub meets in passing
 * would stay.
 */
export function recordedOf<L extends DesignLayer>({ editor }: PropertyContext, layer: L): L {
  const recorded = layerById(editor.session.recordedDesign, layer.id);
  return recorded?.type === layer.type ? (recorded as L) : layer;
}

export interface NumberFieldOptions extends Omit<ProjectorField, "set"> {
  /** What the value makes of the layer. */
  readonly patch: (value: number) => LayerPatch;
  /** What it makes of it while it is scrubbed, where that would take too long for each frame. */
  readonly scrubbed?: (value: number) => LayerPatch;
}

/**
 * Without bounds of its own it has those of a design's numbers.
 *
 * @param group What the step of the history is named after.
 */
export function numberField(context: PropertyContext, group: string, options: NumberFieldOptions): TemplateResult {
  const { label, name, hint = "", value, step, isLength = false } = options;
  const { min = -DESIGN_LIMITS.lengthMax, max = DESIGN_LIMITS.lengthMax } = options;
  const { editor, ids, state } = context;
  const { symbol, perMetre } = isLength ? lengthUnit(state) : { symbol: options.unit ?? "", perMetre: 1 };
  const patch = (shown: number, of = options.patch): LayerPatch => of(rounded(shown / perMetre));
  const detail = (event: Event): NumberFieldEvent => (event as CustomEvent<NumberFieldEvent>).detail;
  const change = (event: Event): void => {
    const { value: next, repeated } = detail(event);
    record(context, group, patch(next), repeated ? name : undefined);
  };
  return html`<tc-number
    data-field=${name.toLowerCase().replaceAll(" ", "-")}
    .label=${label}
    .name=${name}
    .hint=${hint}
    .unit=${symbol}
    .value=${rounded(value * perMetre)}
    .step=${rounded(step * perMetre)}
    .min=${rounded(min * perMetre)}
    .max=${rounded(max * perMetre)}
    @field-preview=${(event: Event) => editor.layers.preview(ids, patch(detail(event).value, options.scrubbed))}
    @field-change=${change}
    @field-cancel=${() => editor.layers.cancelPreview()}
  ></tc-number>`;
}

/** One step of the history, named after a field; with a `mergeKey` those that follow each other fast are one. */
export function record({ editor, ids }: PropertyContext, field: string, patch: LayerPatch, mergeKey?: string): void {
  const key = mergeKey === undefined ? undefined : `${mergeKey}:${ids.join(" ")}`;
  editor.layers.change(ids, patch, editor.strings.steps.change(field), key);
}

export function toggleField(
  context: PropertyContext,
  name: string,
  label: string,
  on: boolean,
  patch: (on: boolean) => LayerPatch,
): TemplateResult {
  return checkField(name, label, on, (next) => record(context, label, patch(next)));
}

export function optionField<T extends string>(
  context: PropertyContext,
  name: string,
  label: string,
  options: Readonly<Record<T, string>>,
  chosen: T,
  patch: (value: T) => LayerPatch,
): TemplateResult {
  return choiceField<T>(name, label, options, chosen, (value) => record(context, label, patch(value)));
}

/** A colour with its alpha: "#rrggbb", or "#rrggbbaa" where it is not opaque. */
export function colorField(
  context: PropertyContext,
  id: string,
  label: string,
  color: string,
  patch: (color: string) => LayerPatch,
): TemplateResult {
  return html`
    <div class="field">
      <label for=${id}>${label}</label>
      <div class="color">${colorWell(context, id, label, color, patch)}${alphaField(context, label, color, patch)}</div>
    </div>
  `;
}

export function colorWell(
  context: PropertyContext,
  id: string,
  label: string,
  color: string,
  patch: (color: string) => LayerPatch,
): TemplateResult {
  const chosen = (event: Event): string => (event.target as HTMLInputElement).value + color.slice(7);
  return html`<input
    type="color"
    id=${id}
    list=${`${id}-recent`}
    aria-label=${label}
    .value=${color.slice(0, 7)}
    @input=${(event: Event) => context.editor.layers.preview(context.ids, patch(chosen(event)))}
    @change=${(event: Event) => record(context, label, patch(chosen(event)))}
  />${recentColors(`${id}-recent`, context.state.toolSettings.recent)}`;
}

export function alphaField(
  context: PropertyContext,
  label: string,
  color: string,
  patch: (color: string) => LayerPatch,
): TemplateResult {
  const words = context.editor.strings.properties;
  return numberField(context, label, {
    label: words.alpha,
    name: words.axis(label, words.alpha),
    unit: words.percent,
    value: Math.round(alphaOf(color) * 100),
    step: 1,
    min: 0,
    max: 100,
    patch: (value) => patch(withAlpha(color, value / 100)),
  });
}

/** 0 to 1. */
function alphaOf(color: string): number {
  return color.length > 7 ? Number.parseInt(color.slice(7, 9), 16) / 255 : 1;
}

function withAlpha(color: string, alpha: number): string {
  const byte = Math.round(Math.max(0, Math.min(1, alpha)) * 255);
  return color.slice(0, 7) + (byte === 255 ? "" : byte.toString(16).padStart(2, "0"));
}

/** In which colours a layer is mixed with what is below, and whether it keeps to what is there. */
export function mixingFields(context: PropertyContext, { blendSpace, lockAlpha }: DesignLayer): TemplateResult {
  const words = context.editor.strings.properties;
  const spaces = { srgb: words.blendSpaceSrgb, linear: words.blendSpaceLinear };
  return html`
    ${optionField(context, "blendSpace", words.blendSpace, spaces, blendSpace, (value) => ({ blendSpace: value }))}
    ${toggleField(context, "lockAlpha", words.lockAlpha, lockAlpha, (on) => ({ lockAlpha: on }))}
  `;
}

/** A heading over fields that says their unit for all of them, who have no room to say it each; without one, that of lengths. */
export function sharedTitle(
  { state }: PropertyContext,
  title: string,
  unit: string = lengthUnit(state).symbol,
): TemplateResult {
  return html`<h3 class="shared">${title} <span>${unit}</span></h3>`;
}

const lengthUnit = ({ model }: Pick<EditorState, "model">): LengthUnit => unitFor(diagonalOf(model));

/** Without what a change of unit leaves behind the digits that count. */
const rounded = (value: number): number => Number(value.toPrecision(12));

/** Metres a step: a power of ten near a thousandth of the model, so that models of any size feel alike. */
export function lengthStep({ model }: Pick<EditorState, "model">): number {
  if (!model) return 0.001;
  return 10 ** Math.floor(Math.log10(Math.max(diagonalOf(model), 1e-9) / 300));
}
