/** The browser's own size of type, as its user has set it: what a rem is in the element. */
import { adoptStyle } from "../viewer/adopt-style.ts";
import { REM } from "../viewer/own-rem.ts";

/** Sets it for a shadow tree in a page, as it is now. */
export function keepRem(root: ShadowRoot): void {
  const probe = document.createElement("p");
  root.append(probe);
  probe.style.font = "medium system-ui";
  const { fontSize } = getComputedStyle(probe);
  probe.remove();
  // None, in a document that is not shown.
  if (fontSize) adoptStyle(root, `:host{${REM}:${fontSize}}`, REM);
}
