/** The opacity of layers: a slider and a field. */
import { html, type TemplateResult } from "lit";
import { takesBack } from "../../viewer/take-back-key.ts";
import type { DesignLayer } from "../document/index.ts";
import { numberField, type PropertyContext, record } from "./property-controls.ts";

/** Those whose drag was taken back: where the pointer goes with them until it lets go is nothing. */
const takenBack = new WeakSet<EventTarget>();

export function opacityField(context: PropertyContext, { opacity }: DesignLayer): TemplateResult {
  const words = context.editor.strings.properties;
  const percent = Math.round(opacity * 1000) / 10;
  return html`
    <div class="field">
      <label for="opacity">${words.opacity}</label>
      <div class="slider">
        ${opacitySlider(context, percent)}
        ${numberField(context, words.opacity, {
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

/**
 * A key takes its drag back; the browser knows no way to end the drag itself.
 *
 * @param percent What is shown.
 */
function opacitySlider(context: PropertyContext, percent: number): TemplateResult {
  const { layers, strings } = context.editor;
  const moved = ({ target }: Event, show: (opacity: number) => void): void => {
    const slider = target as HTMLInputElement;
    if (takenBack.has(slider)) slider.value = String(percent);
    else show(Number(slider.value) / 100);
  };
  const key = (event: KeyboardEvent): void => {
    const { target } = event as { target: EventTarget };
    takenBack.delete(target);
    if (!takesBack(event) || !layers.cancelPreview()) return;
    takenBack.add(target);
    event.preventDefault();
    event.stopPropagation();
  };
  return html`<input
    type="range"
    id="opacity"
    min="0"
    max="100"
    .value=${String(percent)}
    @pointerdown=${({ target }: Event) => target && takenBack.delete(target)}
    @keydown=${key}
    @input=${(event: Event) => moved(event, (opacity) => layers.preview(context.ids, { opacity }))}
    @change=${(event: Event) =>
      moved(event, (opacity) => record(context, strings.properties.opacity, { opacity }, "opacity"))}
  />`;
}
