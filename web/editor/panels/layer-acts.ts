/** What the layer list's bar and menus offer. */
import {
  ArrowDown,
  ArrowUp,
  Blend,
  Brush,
  CircleOff,
  ClipboardCopy,
  ClipboardPaste,
  Contrast,
  Copy,
  FolderPlus,
  type IconNode,
  ImagePlus,
  ImageUp,
  Layers2,
  Link2,
  PaintBucket,
  Pencil,
  SquareDashed,
  SquareStack,
  Trash,
  Type,
  Ungroup,
  Unlink2,
} from "lucide";
import { type DecalLayer, findLayer, makeFillLayer, makeGroupLayer, makePaintLayer } from "../document/index.ts";
import { isLocked } from "../document/layer-tree.ts";
import { alignedGradient, fadingGradient } from "../state/aligned-gradient.ts";
import type { ClipboardCommands } from "../state/clipboard-commands.ts";
import type { Editor } from "../state/editor.ts";
import { layerBelow } from "../state/layer-merge.ts";
import { canGoAlong, maskFade } from "../state/mask-edits.ts";
import { ACCEPT } from "../ui/accepted-files.ts";
import { pickFiles } from "../ui/file-picker.ts";
import type { MenuItem } from "../ui/menu.ts";

/** A quiet middle grey-blue: seen on light and on dark models, and clearly a beginning. */
const FIRST_COLOR = "#7c86c4";

export interface LayerAct {
  readonly action: string;
  readonly label: string;
  readonly drawing: IconNode;
  readonly disabled: boolean;
  readonly run: () => void;
}

/** Acts that have a button of their own. */
export function barActs({ layers, store, strings }: Editor): LayerAct[] {
  const words = strings.layers;
  const { selection, selectedId, design } = store.state;
  const none = selection.length === 0;
  const masked = findLayer(design, selectedId)?.mask !== null;
  return [
    { action: "mask", label: words.addMask, drawing: SquareDashed, disabled: masked, run: () => layers.addMask(false) },
    { action: "group", label: words.groupAct, drawing: FolderPlus, disabled: none, run: () => layers.group() },
    { action: "up", label: words.up, drawing: ArrowUp, disabled: none, run: () => layers.step(1) },
    { action: "down", label: words.down, drawing: ArrowDown, disabled: none, run: () => layers.step(-1) },
    { action: "duplicate", label: words.duplicate, drawing: Copy, disabled: none, run: () => layers.duplicate() },
    { action: "delete", label: words.remove, drawing: Trash, disabled: none, run: () => layers.remove() },
  ];
}

/**
 * What can be done with the chosen layers, as the bar's menu and the context menus of the rows and of the model have it.
 *
 * @param rename null where there is no field for a name
 */
export function moreItems(editor: Editor, rename: ((id: string) => void) | null): MenuItem[] {
  const { layers, clipboard, store, strings } = editor;
  const words = strings.layers;
  const { selection, selectedId, design } = store.state;
  const layer = findLayer(design, selectedId);
  const none = selection.length === 0;
  const masked = layer !== undefined && layer.mask !== null;
  const linked = layer?.mask?.linked ?? true;
  const grouped = selection.some((id) => findLayer(design, id)?.type === "group");
  const above = selectedId !== null && layerBelow(design, selectedId) !== undefined;
  const naming = (name: (id: string) => void): MenuItem => ({
    label: words.rename,
    icon: Pencil,
    disabled: selection.length !== 1,
    run: () => name(selectedId ?? ""),
  });
  return [
    ...(rename ? [naming(rename)] : []),
    { label: words.duplicate, icon: Copy, disabled: none, run: () => layers.duplicate() },
    { label: words.remove, icon: Trash, disabled: none, run: () => layers.remove() },
    ...(layer?.type === "decal" && selection.length === 1 ? [replacing(editor, layer)] : []),
    { label: words.copy, icon: ClipboardCopy, disabled: none, separated: true, run: () => copyNow(clipboard) },
    { label: words.paste, icon: ClipboardPaste, disabled: !clipboard.holds, run: () => void clipboard.pasteAgain() },
    { label: words.groupAct, icon: FolderPlus, disabled: none, separated: true, run: () => layers.group() },
    { label: words.ungroup, icon: Ungroup, disabled: !grouped, run: () => layers.ungroup() },
    { label: words.merge, icon: Layers2, disabled: selection.length < 2 && !above, run: () => layers.merge() },
    { label: words.selectAll, icon: SquareStack, disabled: design.layers.length === 0, run: () => layers.selectAll() },
    {
      label: words.addMask,
      icon: SquareDashed,
      disabled: none || masked,
      separated: true,
      run: () => layers.addMask(false),
    },
    {
      label: words.addHidingMask,
      icon: SquareDashed,
      disabled: none || masked,
      run: () => layers.addMask(true),
    },
    {
      label: words.addFadingMask,
      icon: Blend,
      disabled: none || maskFade(layer) !== undefined,
      run: () => layer && layers.startMask(fadingGradient(store.state.model, layer), strings.steps.addFadingMask),
    },
    { label: words.invertMask, icon: Contrast, disabled: !masked, run: () => layers.invertMask() },
    {
      label: linked ? words.unlinkMask : words.linkMask,
      icon: linked ? Unlink2 : Link2,
      disabled: !masked || !canGoAlong(layer),
      run: () => layers.linkMask(!linked),
    },
    { label: words.removeMask, icon: CircleOff, disabled: !masked, run: () => layers.removeMask() },
  ];
}

/** Where it lies and how it looks stay; so a logo is exchanged for its newer version. */
const replacing = ({ files, store, strings }: Editor, { id }: DecalLayer): MenuItem => ({
  label: strings.layers.replacePicture,
  icon: ImageUp,
  disabled: isLocked(store.state.design, id),
  run: () => replacePicture(files, id),
});

/** Must be called from a user's gesture. */
export const replacePicture = (files: Editor["files"], id: string): void =>
  pickFiles({ accept: ACCEPT.picture, multiple: false }, (chosen) => void files.replacePicture(id, chosen));

/** Onto the browser's clipboard, by the event that this brings about; where it lets no page do that, for this page alone. */
function copyNow(clipboard: ClipboardCommands): void {
  // Words that are marked somewhere would be copied in their place.
  getSelection()?.removeAllRanges();
  if (!document.execCommand("copy")) clipboard.copy();
}

export function addItems({ layers, files, store, texts, strings }: Editor): MenuItem[] {
  const material = store.state.material ?? 0;
  const { steps, layers: words } = strings;
  return [
    {
      label: words.addPaint,
      hint: words.addPaintHint,
      icon: Brush,
      run: () =>
        layers.add((id) => makePaintLayer({ id, strokes: [], material, name: words.names.paint }), steps.addPaint),
    },
    {
      label: words.addFill,
      hint: words.addFillHint,
      icon: PaintBucket,
      run: () =>
        layers.add((id) => makeFillLayer({ id, color: FIRST_COLOR, material, name: words.names.fill }), steps.addFill),
    },
    {
      label: words.addGradient,
      hint: words.addGradientHint,
      icon: Blend,
      run: () => {
        const gradient = alignedGradient(store.state.model, "y");
        const { gradient: name } = words.names;
        layers.add((id) => makeFillLayer({ id, color: FIRST_COLOR, gradient, material, name }), steps.addGradient);
      },
    },
    {
      label: words.addPicture,
      icon: ImagePlus,
      run: () => pickFiles({ accept: ACCEPT.picture }, (chosen) => void files.openFiles(chosen)),
    },
    { label: strings.text.add, icon: Type, run: () => void texts.add() },
    {
      label: words.addGroup,
      icon: FolderPlus,
      separated: true,
      run: () => layers.add((id) => makeGroupLayer({ id, layers: [], name: words.group }), steps.addGroup),
    },
  ];
}
