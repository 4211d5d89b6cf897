/** The slider of the opacity of layers. A key takes its drag back; the browser knows no way to end the drag itself. */
import { html, type TemplateResult } from "lit";
import { takesBack } from "../../viewer/take-back-key.ts";
import { type PropertyContext, record } from "./property-controls.ts";

/** Those whose drag was taken back: where the pointer goes with them until it lets go is nothing. */
const takenBack = new WeakSet<EventTarget>();

/** @param percent What is shown. */
export function opacitySlider(context: PropertyContext, percent: number): TemplateResult {
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
