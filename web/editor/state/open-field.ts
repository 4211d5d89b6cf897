/** What is typed in a field that is still open, behind however many shadow roots, becomes a step. */
export function endOpenField(): void {
  let focused = document.activeElement;
  while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
  if (focused instanceof HTMLElement) focused.blur();
}
