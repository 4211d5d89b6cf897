/** The newest colours, offered by a colour field: those that were painted with or picked from the model. */
import { html, type TemplateResult } from "lit";

/** Stands beside the field, whose `list` is `id`. */
export function recentColors(id: string, colors: readonly string[]): TemplateResult {
  return html`<datalist id=${id}>${colors.map((color) => html`<option value=${color}></option>`)}</datalist>`;
}
