/**
 * `texelcast/define` on a server, in Node and at an edge, for rendering there: there are no elements to register, so the tag is left
 * as it is in the markup and comes to life in the browser.
 */
import { TexelcastError } from "./index.ts";

export { EDITOR_TAG } from "./index.ts";

/** Stands for the element's class where code names it. */
export class TexelcastEditor {
  /** Throws: an element is made by a page. */
  constructor() {
    throw new TexelcastError("unsupported", "The editor's element can only be made in a browser.");
  }
}
