/**
 * The size of type that lengths go by. A page may set one of its own on its root (`html { font-size: 62.5% }`), with which all
 * that is measured in `rem` would shrink, in shadow trees too. Inside `<texelcast-editor>` a `rem` is therefore the browser's
 * own size of type, as its user has set it; on the editor's own page it stays what it is.
 */
import { type CSSResult, unsafeCSS } from "lit";

const REM = "--_texelcast-rem";

/**
 * The styles with their rems in it. Heads of queries stay: no custom property counts there. Those of media go by the browser's own
 * size anyway; those of containers would go by the page's and are written in `em`, the size of type of the container itself.
 */
export function inOwnRem({ cssText }: CSSResult): CSSResult {
  const replaced = cssText.replace(
    /(@[^{}]*\{)|(-?[\d.]+)rem\b/g,
    (_, head: string | undefined, count: string) => head ?? `calc(${count}*var(${REM},1rem))`,
  );
  return unsafeCSS(replaced);
}

/** Sets it for a shadow tree in a page, as it is now. */
export function keepRem(root: ShadowRoot): void {
  const probe = document.createElement("p");
  root.append(probe);
  probe.style.font = "medium system-ui";
  const { fontSize } = getComputedStyle(probe);
  probe.remove();
  sheet ??= new CSSStyleSheet();
  sheet.replaceSync(`:host{${REM}:${fontSize || "1rem"}}`);
  if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets.push(sheet);
}

let sheet: CSSStyleSheet | undefined;
