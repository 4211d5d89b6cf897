/** The editor's page for iframes: one element over the whole page, driven by the shop that framed it. */
import { TexelcastError } from "../core/texelcast-error.ts";
import { TexelcastEditor } from "../element/define.ts";
import { hostEditor } from "./host.ts";

const editor = new TexelcastEditor();
try {
  const listed = document.querySelector<HTMLMetaElement>("meta[name=texelcast-shops]")?.content.trim() ?? "";
  hostEditor(editor, { shops: listed === "*" ? null : listed.split(/\s+/).filter(Boolean) });
  document.body.append(editor);
} catch (thrown) {
  const { message, hint = "" } = TexelcastError.wrap(thrown, "internal", "The editor could not be started.");
  const told = document.createElement("p");
  told.textContent = `${message} ${hint}`;
  document.body.append(told);
}
