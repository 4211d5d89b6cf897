/** What a stroke was painted with. */
import { html, type TemplateResult } from "lit";
import type { Brush, StrokeLayer } from "../document/index.ts";
import { colorField, numberField, type PropertyContext } from "./property-controls.ts";

export function brushFields(context: PropertyContext, { brush }: StrokeLayer): TemplateResult {
  const words = context.editor.strings.properties;
  const percent = (name: string, hint: string, share: number, patch: (share: number) => Brush): TemplateResult =>
    numberField(context, name, {
      label: name,
      name,
      hint,
      unit: words.percent,
      value: Math.round(share * 1000) / 10,
      step: 1,
      min: 0,
      max: 100,
      patch: (value) => ({ brush: patch(value / 100) }),
    });
  const flow = percent(words.flow, words.flowHint, brush.flow, (share) => ({ ...brush, flow: share }));
  if (brush.tip === "picture") return html`<section role="group" aria-label=${words.brush}>${flow}</section>`;
  return html`
    <section role="group" aria-label=${words.brush}>
      ${colorField(context, "brush-color", words.color, brush.color, (color) => ({ brush: { ...brush, color } }))}
      <div class="two">
        ${percent(words.hardness, words.hardnessHint, brush.hardness, (hardness) => ({ ...brush, hardness }))}${flow}
      </div>
    </section>
  `;
}
