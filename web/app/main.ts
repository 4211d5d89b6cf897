/** The editor page: engine, views and editor put together, and the handle for tests. */
import { TexelcastError } from "../core/texelcast-error.ts";
import { Editor } from "../editor/state/editor.ts";
import { applyLanguage, pageLanguage } from "../editor/strings/language.ts";
import { stringsIn } from "../editor/strings.ts";
import "../editor/workbench.ts";
import { createEngineClient } from "../engine/engine-client.ts";
import { refused } from "../engine/refused-worker.ts";
import { createModelViewer } from "../viewer/model-viewer.ts";
import { createTextureView } from "../viewer/texture-view.ts";
import { showStartFailure } from "./start-failure.ts";
import { makeTestHandle } from "./test-handle.ts";

document.getElementById("coming")?.remove();
applyLanguage(document.documentElement);
const strings = stringsIn(pageLanguage);
const workbench = document.createElement("tc-workbench");
try {
  const engine = createEngineClient();
  const viewer = createModelViewer(addView("view"), { label: strings.stage.view });
  const textureView = createTextureView(addView("texture"), {
    label: strings.texture.view,
    onNeedsFullUpdate: (material) => editor.refresh(material),
    readTexels: (material, x, y, width, height) => engine.readTexels(material, x, y, width, height),
  });
  const editor = new Editor({
    ...{ engine, viewer, textureView, language: pageLanguage },
    unwrap: async (...work) => (await import("../editor/files/unwrap-client.ts")).unwrapInWorker(...work),
  });
  workbench.editor = editor;
  document.body.append(workbench);
  window.texelcast = makeTestHandle(editor, editor.start(document.baseURI));
} catch (thrown) {
  workbench.remove();
  const hint = strings.errors.noWebGlHint;
  showStartFailure(TexelcastError.wrap(refused(thrown), "unsupported", strings.errors.noWebGl, { hint }));
}

/** A view's place: a child of the workbench, which shows it where its slot is. */
function addView(slot: string): HTMLElement {
  const host = document.createElement("div");
  host.slot = slot;
  host.style.cssText = "position:absolute;inset:0";
  workbench.append(host);
  return host;
}
