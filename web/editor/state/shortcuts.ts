/** Keys of the page. Fields keep their own: an event from one never gets here with a meaning of ours. */
import type { Editor } from "./editor.ts";

export interface ShortcutActions {
  readonly openModel: () => void;
}

/** True when the key was ours, and its default must not happen. */
export function handleShortcut(event: KeyboardEvent, editor: Editor, actions: ShortcutActions): boolean {
  if (event.defaultPrevented || event.isComposing || isTyping(event)) return false;
  const command = event.ctrlKey || event.metaKey;
  return command ? handleCommand(event, editor, actions) : handlePlain(event, editor);
}

function handleCommand(event: KeyboardEvent, { files, decals }: Editor, actions: ShortcutActions): boolean {
  if (event.altKey) return false;
  switch (event.key.toLowerCase()) {
    case "z":
      void files.travel(event.shiftKey ? "redo" : "undo");
      return true;
    case "y":
      void files.travel("redo");
      return true;
    case "d":
      decals.duplicate();
      return true;
    case "s":
      files.saveDesign();
      return true;
    case "o":
      actions.openModel();
      return true;
    default:
      return false;
  }
}

function handlePlain(event: KeyboardEvent, { decals, viewer }: Editor): boolean {
  if (event.altKey) return false;
  const coarse = event.shiftKey;
  // By place on the keyboard: with Shift, the characters of these keys differ between layouts.
  if (event.code === "BracketLeft") return decals.spin(1, coarse);
  if (event.code === "BracketRight") return decals.spin(-1, coarse);
  switch (event.key) {
    case "ArrowLeft":
      return decals.nudge(-1, 0, coarse);
    case "ArrowRight":
      return decals.nudge(1, 0, coarse);
    case "ArrowUp":
      return decals.nudge(0, 1, coarse);
    case "ArrowDown":
      return decals.nudge(0, -1, coarse);
    case "+":
    case "=":
      return decals.scale(1, false);
    case "-":
      return decals.scale(-1, false);
    case "Delete":
    case "Backspace":
      decals.remove();
      return true;
    case "Escape":
      decals.select(null);
      return true;
    case "f":
    case "F":
      viewer.frameModel();
      return true;
    default:
      return false;
  }
}

/** A field, a list or a menu has the focus, in whatever shadow root. */
function isTyping(event: KeyboardEvent): boolean {
  const [target] = event.composedPath();
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) {
    // Checkboxes know the space key only.
    return !["checkbox", "color", "button"].includes(target.type);
  }
  return target.isContentEditable || target.matches("textarea, select, dialog, dialog *, [role=menu] *");
}
