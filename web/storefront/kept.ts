/** What the browser keeps for the shop, where it is allowed to: one that may keep nothing throws as soon as it is asked. */

/** Until the tab is closed, or from visit to visit. */
type Span = "tab" | "visits";

const placeFor = (span: Span): Storage => (span === "tab" ? sessionStorage : localStorage);

/** Null for what is not kept. */
export function keptFor(span: Span, key: string): string | null {
  try {
    return placeFor(span).getItem(key);
  } catch {
    return null;
  }
}

/** False where it cannot be kept. @param value null to forget it */
export function keepFor(span: Span, key: string, value: string | null): boolean {
  try {
    if (value === null) placeFor(span).removeItem(key);
    else placeFor(span).setItem(key, value);
    return true;
  } catch {
    return false;
  }
}
