/** Whether what is dragged comes into line: the user's choice, kept by the browser from visit to visit. */

const KEY = "texelcast.aligns";

/** True where nothing else was chosen, or the browser lets the page keep nothing. */
export function readAligning(): boolean {
  try {
    return localStorage.getItem(KEY) !== "no";
  } catch {
    return true;
  }
}

/** A browser that lets the page keep nothing forgets the choice with the page. */
export function keepAligning(aligns: boolean): void {
  try {
    localStorage.setItem(KEY, aligns ? "yes" : "no");
  } catch {
    // The choice holds until the page is closed, which is all that can be done.
  }
}
