import "../../../web/element/define.ts";

const editor = document.createElement("texelcast-editor");
editor.zones = { texelcastZones: 1, zones: [] };
editor.addEventListener("change", ({ detail }) => detail.totalArea.toFixed(1));
editor.addEventListener("click", ({ clientX }) => clientX.toFixed(1));
export const hash: Promise<string> = editor
  .exportTexture({ zone: "front", flattened: true })
  .then((file) => file.sha256);
export const pictures: Promise<Blob[]> = editor.snapshot(["front", "30deg 75deg 105%"]);

// @ts-expect-error There is no such event of the element's or the browser's with a detail.
editor.addEventListener("load", ({ detail }) => detail.nothing);
