/**
 * What this tab shows, for when it is loaded again: a reload goes on with that, whatever other tabs have saved since. It
 * ends with the tab; a new one goes on with the project that was open last.
 */

const KEY = "texelcast-tab";

/** A project that the browser keeps, or a demo that nothing was changed on. */
export type TabPlace = { readonly project: string } | { readonly demo: string };

export class TabMemory {
  #text = "";

  remember(place: TabPlace): void {
    const text = JSON.stringify(place);
    // Asked at each frame of a drag.
    if (text === this.#text) return;
    this.#text = text;
    try {
      sessionStorage.setItem(KEY, text);
    } catch {
      // A browser that keeps nothing begins with what a new tab does.
    }
  }

  recall(): Partial<Record<"project" | "demo", string>> {
    try {
      const place: unknown = JSON.parse(sessionStorage.getItem(KEY) ?? "{}");
      return typeof place === "object" && place !== null ? place : {};
    } catch {
      return {};
    }
  }
}
