/** Fields of a design that is only looked at: they show what they hold, and nothing in them can be used. */
import { html, type TemplateResult } from "lit";

/** `why` is what screen readers say of all of it. */
export function readonlyFields(readonly: boolean, why: string, fields: TemplateResult): TemplateResult {
  return readonly ? html`<fieldset disabled aria-label=${why}>${fields}</fieldset>` : fields;
}
