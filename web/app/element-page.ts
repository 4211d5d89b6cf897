/** The element on a page of its own: attributes may be given in the address, `?src=demo/avatar.glb&mode=full`. */
import { TexelcastEditor } from "../element/define.ts";

const editor = document.querySelector("texelcast-editor");
const output = document.querySelector("output");
// Its own, and no others: a link must not bring an "onload".
const attributes = new Set(TexelcastEditor.observedAttributes);
for (const [name, value] of new URLSearchParams(location.search)) {
  if (attributes.has(name)) editor?.setAttribute(name, value);
}

editor?.addEventListener("submit", ({ detail: { texture, assets } }) => {
  if (output) {
    output.value = `${texture.width} × ${texture.height}, ${assets.length} files, SHA-256 ${texture.sha256.slice(0, 16)}…`;
  }
});
