/**
 * Style sheets for whatever tree something stands in. Constructed, not inlined: a strict content security policy refuses inline
 * styles. A constructed sheet serves one document alone, and a tree that goes to another one leaves its sheets behind.
 */
import { inLight } from "./light-dark.ts";
import { inOwnRem } from "./own-rem.ts";

const made = new WeakMap<Document, Map<string, CSSStyleSheet>>();

/** Gives a style to the document or shadow tree in which something stands: once, or anew where the text of a `key` changes. */
export function adoptStyle(inside: HTMLElement | ShadowRoot, text: string, key = text): void {
  const page = inside.ownerDocument;
  // Without a window nothing is seen.
  const Sheet = page.defaultView?.CSSStyleSheet;
  if (!Sheet) return;
  const sheets = made.get(page) ?? new Map<string, CSSStyleSheet>();
  made.set(page, sheets);
  let sheet = sheets.get(key);
  if (!sheet || key !== text) {
    sheet ??= new Sheet();
    const known = CSS.supports("color", "light-dark(red,red)") ? text : inLight(text);
    sheet.replaceSync(inOwnRem(known));
    sheets.set(key, sheet);
  }
  const tree = inside.getRootNode();
  const { adoptedStyleSheets } = tree instanceof ShadowRoot ? tree : page;
  if (!adoptedStyleSheets.includes(sheet)) adoptedStyleSheets.push(sheet);
}
