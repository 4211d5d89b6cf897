/** The element's events among those that every element has: some have the names of the browser's own, and carry more. */
import type { TexelcastEditorEventMap } from "./element-api.ts";

export type EventName = keyof TexelcastEditorEventMap;
export type EventDetail<Name extends EventName> = TexelcastEditorEventMap[Name]["detail"];
export type EditorEvents = Omit<HTMLElementEventMap, EventName> & TexelcastEditorEventMap;

/** False where a listener has prevented what follows. */
export function sendEvent<Name extends EventName>(from: EventTarget, type: Name, detail: EventDetail<Name>): boolean {
  // These cross shadow borders, too: the others would be taken for the browser's own, a page's `load`, a form's `submit`.
  const bubbles = type === "change" || type === "select";
  const cancelable = type === "submit";
  return from.dispatchEvent(new CustomEvent(type, { detail, bubbles, composed: bubbles, cancelable }));
}
