/** The browser's own clipboard events, which need no permission. Text fields keep theirs, and so does text that is marked. */
import { collectDrop } from "../files/file-collection.ts";
import { pastedDrawing } from "../files/pasted-drawing.ts";
import type { Editor } from "./editor.ts";
import { focusOf } from "./shortcuts.ts";

/** Nothing else reads it: pasted into a letter, layers are nothing. */
const LAYERS_TYPE = "application/x-texelcast-layers";
/** What browsers call a picture that lies on the clipboard as one, and not as a file. */
const NAMELESS = "image.png";

/** True when what is copied or pasted is ours, and the event's default must not happen. */
export function handleClipboard(event: ClipboardEvent, editor: Editor): boolean {
  const { clipboardData } = event;
  if (event.defaultPrevented || !clipboardData || focusOf(event) === "text") return false;
  if (event.type === "paste") return paste(clipboardData, editor);
  if (getSelection()?.toString()) return false;
  const text = event.type === "cut" ? editor.clipboard.cut() : editor.clipboard.copy();
  if (text !== null) clipboardData.setData(LAYERS_TYPE, text);
  return text !== null;
}

function paste(transfer: DataTransfer, { clipboard, files, texts, strings }: Editor): boolean {
  const text = transfer.getData(LAYERS_TYPE);
  if (text) {
    void clipboard.paste(text);
    return true;
  }
  if (transfer.files.length === 0) {
    const words = transfer.getData("text/plain");
    const drawing = pastedDrawing(words);
    if (drawing === null) return texts.paste(words);
    const path = `${strings.files.pasted}.svg`;
    void files.openFiles([{ path, file: new File([drawing], path, { type: "image/svg+xml" }) }]);
    return true;
  }
  const collected = collectDrop(transfer).then((all) =>
    all.map(({ path, file }) => {
      if (path !== NAMELESS) return { path, file };
      const name = `${strings.files.pasted}.png`;
      return { path: name, file: new File([file], name, { type: file.type }) };
    }),
  );
  void files.openFiles(collected);
  return true;
}
