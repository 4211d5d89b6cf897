/** A user's choices that the browser keeps from visit to visit. One that lets the page keep nothing forgets them with the page. */

/** Null where nothing was chosen, or nothing may be kept. */
export function keptChoice(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

export function keepChoice(key: string, choice: string): void {
  try {
    localStorage.setItem(key, choice);
  } catch {
    // The choice holds until the page is closed, which is all that can be done.
  }
}
