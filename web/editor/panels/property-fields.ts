/** Fields of the property panel that hold one of a few values; their looks are in property-styles.ts. */
import { html, type TemplateResult } from "lit";

export function checkField(
  id: string,
  label: string,
  checked: boolean,
  change: (checked: boolean) => void,
): TemplateResult {
  return html`
    <label class="check">
      <input
        type="checkbox"
        id=${id}
        .checked=${checked}
        @change=${(event: Event) => change((event.target as HTMLInputElement).checked)}
      />
      ${label}
    </label>
  `;
}

/**
 * Radio buttons side by side. They have a form, though nothing is sent: the shadow root would hold those that have none, and all that goes
 * with them, when they are gone (Chromium 156), and a panel is made anew with each choice of a layer.
 */
export const segments = (buttons: readonly TemplateResult[], kind = ""): TemplateResult =>
  html`<form class="segments ${kind}" @submit=${(event: Event) => event.preventDefault()}>${buttons}</form>`;

/** `options`: what each value is called. */
export function choiceField<T extends string>(
  name: string,
  label: string,
  options: Readonly<Record<T, string>>,
  chosen: T,
  change: (value: T) => void,
): TemplateResult {
  return html`
    <div class="field" role="radiogroup" aria-label=${label}>
      <span>${label}</span>
      ${segments(
        (Object.entries(options) as [T, string][]).map(
          ([value, text]) => html`<label>
            <input type="radio" name=${name} value=${value} .checked=${value === chosen} @change=${() => change(value)} />
            <span>${text}</span>
          </label>`,
        ),
      )}
    </div>
  `;
}
