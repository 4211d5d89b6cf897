/** The element's events among those that every element has: some have the names of the browser's own, and carry more. */
import type { TexelcastEditorEventMap } from "./element-api.ts";

export type EventName = keyof TexelcastEditorEventMap;
export type EventDetail<Name extends EventName> = TexelcastEditorEventMap[Name]["detail"];
export type EditorEvents = Omit<HTMLElementEventMap, EventName> & TexelcastEditorEventMap;

/** What bubbles and crosses shadow borders: the others would be taken for the browser's own, a page's `load`, a form's `submit`. */
const BUBBLING: ReadonlySet<EventName> = new Set(["change", "select"]);

/** False where a listener has prevented what follows. */
export function sendEvent<Name extends EventName>(from: EventTarget, type: Name, detail: EventDetail<Name>): boolean {
  const bubbles = BUBBLING.has(type);
  const cancelable = type === "submit";
  return from.dispatchEvent(new CustomEvent(type, { detail, bubbles, composed: bubbles, cancelable }));
}
