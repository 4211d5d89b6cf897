/** The field that somebody types in, behind however many shadow roots. */

/** What has the focus in a page, or in a part of it. */
export function focusedIn(root: DocumentOrShadowRoot | null): HTMLElement | null {
  let focused = root?.activeElement;
  while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
  return focused instanceof HTMLElement ? focused : null;
}

/** What is typed in it becomes a step. */
export function endOpenField(): void {
  focusedIn(document)?.blur();
}

/** What is typed in it so far becomes a step, and it is typed in on. */
export function takeTyped(field: unknown = focusedIn(document)): void {
  if (!(field instanceof HTMLElement) || !field.matches("input, textarea")) return;
  field.blur();
  field.focus({ preventScroll: true });
}
