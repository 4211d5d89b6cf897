/** The element on a page of its own: attributes may be given in the address, `?src=demo/avatar.glb&mode=full`. */
import "../element/define.ts";

const editor = document.querySelector("texelcast-editor");
const output = document.querySelector("output");
for (const [name, value] of new URLSearchParams(location.search)) editor?.setAttribute(name, value);

editor?.addEventListener("submit", ({ detail: { texture, assets } }) => {
  if (output) {
    output.value = `${texture.width} × ${texture.height}, ${assets.length} files, SHA-256 ${texture.sha256.slice(0, 16)}…`;
  }
});
