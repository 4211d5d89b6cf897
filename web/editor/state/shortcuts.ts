/** Keys of the page. What has the focus comes first: a text field keeps every key, a list its letters, a slider its arrows. */
import { isComposed } from "../ui/composed-key.ts";
import { takeTyped } from "../ui/open-field.ts";
import { bracketOf } from "./bracket-key.ts";
import type { Editor } from "./editor.ts";
import type { LayerCommands } from "./layer-commands.ts";
import { letterOf } from "./letter-key.ts";
import { VIEW_LAYOUTS } from "./view-state.ts";

export interface ShortcutActions {
  /** Null where there is none to be chosen. */
  readonly openModel: (() => void) | null;
  readonly help: () => void;
}

/** True when the key was ours, and its default must not happen. */
export function handleShortcut(event: KeyboardEvent, editor: Editor, actions: ShortcutActions): boolean {
  if (event.defaultPrevented || isComposed(event)) return false;
  const focus = focusOf(event);
  if (event.ctrlKey || event.metaKey) {
    if (focus === "text") {
      if (!["s", "o"].includes(letterOf(event))) return false;
      // What stands in a field is recorded when it is left: what is saved must hold it.
      takeTyped(event.composedPath()[0]);
    }
    return handleCommand(event, editor, actions);
  }
  if (focus === "text" && event.key === "Escape") return leaveField(event, editor);
  // Who has set a slider by pointer goes on with a tool by its letter.
  if (focus !== "page" && !(focus === "slider" && /^[a-z]$/.test(letterOf(event)))) return false;
  // Typed for the words whose font is not there yet: no tool is meant, and no layer is to be deleted.
  if (editor.texts.coming && !event.altKey && /^(?:\S|Delete|Backspace)$/u.test(event.key)) return true;
  if (event.key === "?") {
    actions.help();
    return true;
  }
  if (handleView(event, editor)) return true;
  if (editor.store.state.readonly) return handleLook(event, editor);
  // A Mac with a German keyboard has them on the level of Alt.
  const types = event.key === "[" || event.key === "]";
  return editor.tools.handleKey(event) || (event.altKey && !types ? handleAlt : handlePlain)(event, editor);
}

/** From a field in a panel to what it is about; a dialog's own is left with the dialog. */
function leaveField(event: KeyboardEvent, { work }: Editor): boolean {
  const [field] = event.composedPath();
  if (!(field instanceof HTMLElement) || field.closest("dialog")) return false;
  work.focus({ preventScroll: true });
  return true;
}

function handleCommand(event: KeyboardEvent, { files, layers, store }: Editor, actions: ShortcutActions): boolean {
  if (event.altKey) return false;
  if (store.state.readonly && letterOf(event) !== "s") return false;
  const bracket = bracketOf(event);
  if (bracket !== null) return arrange(layers, bracket, event.shiftKey);
  switch (letterOf(event)) {
    case "z":
      void files.travel(event.shiftKey ? "redo" : "undo");
      return true;
    case "y":
      void files.travel("redo");
      return true;
    case "a":
      // Not the words of the page, which the browser would mark.
      layers.selectAll();
      return true;
    case "d":
      layers.duplicate();
      return true;
    case "g":
      if (event.shiftKey) layers.ungroup();
      else layers.group();
      return true;
    case "e":
      layers.merge();
      return true;
    case "s":
      // Held, it would be a file each time that the key is repeated.
      if (!event.repeat) void files.saveDesign();
      return true;
    case "o":
      actions.openModel?.();
      return actions.openModel !== null;
    default:
      return false;
  }
}

/** Alt with a number chooses the views; Shift with a letter changes how the model is shown. */
function handleView(event: KeyboardEvent, { views, store }: Editor): boolean {
  if (event.altKey) {
    const layout = VIEW_LAYOUTS[["Digit1", "Digit2", "Digit3"].indexOf(event.code)];
    if (!layout || event.shiftKey) return false;
    views.setLayout(layout);
    return true;
  }
  if (!event.shiftKey) return false;
  switch (letterOf(event)) {
    case "u":
      views.toggleShading();
      return true;
    case "w":
      views.toggle("wireframe");
      return true;
    case "t":
      views.toggle("turntable");
      return true;
    case "g":
      views.toggle("guide");
      return true;
    case "l":
      views.toggle("aligns");
      return true;
    case "p":
      if (store.state.animation.clips.length > 0) views.animate({ playing: !store.state.animation.playing });
      return true;
    default:
      return false;
  }
}

function arrange(layers: LayerCommands, direction: 1 | -1, toEnd: boolean): true {
  if (toEnd) layers.toEnd(direction);
  else layers.step(direction);
  return true;
}

/** By place on the keyboard: with Alt, a Mac types other characters. */
function handleAlt(event: KeyboardEvent, { decals }: Editor): boolean {
  if (event.shiftKey) return false;
  switch (event.code) {
    case "KeyS":
      return decals.align("surface");
    case "KeyU":
      return decals.align("upright");
    case "KeyV":
      return decals.align("view");
    case "KeyM":
      return decals.align("middle");
    case "KeyP":
      return decals.convert("perspective");
    case "KeyW":
      return decals.convert("cylindrical");
    default:
      return false;
  }
}

/** What is left where the design is only looked at. */
function handleLook(event: KeyboardEvent, { layers, viewer }: Editor): boolean {
  if (event.key === "Escape") layers.select(null);
  else if (letterOf(event) === "f") viewer.frameModel();
  else return false;
  return true;
}

function handlePlain(event: KeyboardEvent, { decals, layers, viewer, store }: Editor): boolean {
  const coarse = event.shiftKey;
  const bracket = bracketOf(event);
  if (bracket !== null) return decals.spin(bracket === -1 ? 1 : -1, coarse);
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
      return decals.scale(1);
    case "-":
      return decals.scale(-1);
    case "Delete":
    case "Backspace":
      layers.remove();
      return true;
    case "Escape":
      if (store.state.toolPanel === null) layers.select(null);
      else store.set({ toolPanel: null });
      return true;
    default:
      if (letterOf(event) === "f") {
        viewer.frameModel();
        return true;
      }
      return /^\d$/.test(event.key) && layers.fade(Number(event.key) / 10 || 1);
  }
}

/** What the focused element does with keys: takes them as text, chooses with them, with its arrows alone, or leaves them to the page. */
export function focusOf(event: Event): "text" | "choice" | "slider" | "page" {
  const [target] = event.composedPath();
  if (!(target instanceof HTMLElement)) return "page";
  if (target instanceof HTMLInputElement) {
    if (["range", "radio"].includes(target.type)) return target.closest("dialog, [role=menu]") ? "choice" : "slider";
    if (target.type === "color") return "choice";
    return target.type === "checkbox" ? "page" : "text";
  }
  if (target.isContentEditable || target.matches("textarea, dialog, dialog *")) return "text";
  return target.matches("select, [role=menu] *") ? "choice" : "page";
}
