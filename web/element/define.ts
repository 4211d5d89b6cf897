/**
 * Registers `<texelcast-editor>`, once, where there are custom elements; in bare Node, where a server renders, it does nothing.
 * The element itself comes only where it can be: the classes that it stands on want a browser when they are read.
 */
import { EDITOR_TAG } from "./element-api.ts";
import type { TexelcastEditor } from "./texelcast-editor.ts";

export * from "./element-api.ts";
export type { TexelcastEditor } from "./texelcast-editor.ts";

if (typeof customElements !== "undefined" && !customElements.get(EDITOR_TAG)) {
  const element = await import("./texelcast-editor.ts");
  // Another copy of the package on the page may have been faster.
  if (!customElements.get(EDITOR_TAG)) customElements.define(EDITOR_TAG, element.TexelcastEditor);
}

declare global {
  interface HTMLElementTagNameMap {
    "texelcast-editor": TexelcastEditor;
  }
}
