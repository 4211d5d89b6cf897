/** What the editor's elements have in common inside of `<texelcast-editor>`: their lengths go by its size of type. */
import { type CSSResultGroup, LitElement } from "lit";
import { inOwnRem } from "./own-rem.ts";

export class RemElement extends LitElement {
  static override finalizeStyles(styles?: CSSResultGroup) {
    return LitElement.finalizeStyles(styles).map((style) => ("cssText" in style ? inOwnRem(style) : style));
  }
}
