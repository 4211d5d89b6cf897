/** Registers `<texelcast-editor>`, once, where there are custom elements: in a browser, or in what stands for one on a server. */
import type { EDITOR_TAG as TAG } from "./element-api.ts";
import { TexelcastEditor } from "./texelcast-editor.ts";

export type * from "./element-api.ts";
export { TexelcastEditor } from "./texelcast-editor.ts";

/** The element's name in HTML. Said anew: a file that holds nothing else would be another request of a shop's page. */
export const EDITOR_TAG: typeof TAG = "texelcast-editor";

if (typeof customElements !== "undefined" && !customElements.get(EDITOR_TAG)) {
  customElements.define(EDITOR_TAG, TexelcastEditor);
}

declare global {
  interface HTMLElementTagNameMap {
    "texelcast-editor": TexelcastEditor;
  }
}
