/** What the elements have in common inside of `<texelcast-editor>`: their styles, in whatever document they stand. */
import { LitElement } from "lit";
import { adoptStyle } from "../../viewer/adopt-style.ts";

/** Lit's own sheets are of the document of the script, and of no other. */
export class RemElement extends LitElement {
  protected override createRenderRoot(): ShadowRoot {
    const root = this.attachShadow({ mode: "open" });
    this.#dress(root);
    return root;
  }

  /** @internal */
  adoptedCallback(): void {
    if (this.renderRoot) this.#dress(this.renderRoot as ShadowRoot);
  }

  #dress(root: ShadowRoot): void {
    for (const style of (this.constructor as typeof LitElement).elementStyles) {
      if ("cssText" in style) adoptStyle(root, style.cssText);
    }
  }
}
