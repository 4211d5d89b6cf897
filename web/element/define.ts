/** Registers `<texelcast-editor>`, once, where there are custom elements: in a browser, or in what stands for one on a server. */
import { EDITOR_TAG } from "./element-api.ts";
import { TexelcastEditor } from "./texelcast-editor.ts";

export * from "./element-api.ts";
export { TexelcastEditor } from "./texelcast-editor.ts";

if (typeof customElements !== "undefined" && !customElements.get(EDITOR_TAG)) {
  customElements.define(EDITOR_TAG, TexelcastEditor);
}

declare global {
  interface HTMLElementTagNameMap {
    "texelcast-editor": TexelcastEditor;
  }
}
