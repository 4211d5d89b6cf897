/** Which flat stamp the texture view shows with handles. */
import type { ViewerDecal } from "../../viewer/viewer-api.ts";
import { isPlaced, materialsOf, type PlacedLayer } from "../document/index.ts";
import { isLocked } from "../document/layer-tree.ts";
import { TOGETHER } from "./chosen-together.ts";
import { layerById } from "./design-edits.ts";
import type { EditorState } from "./editor-state.ts";
import { stampsBox, stampsIn } from "./stamps-together.ts";

/**
 * The selected stamp, where it lies in the texture that is shown, or the box round several; null otherwise.
 *
 * @param movable what is chosen and not locked
 */
export function shownStamp(
  { design, selectedId, material }: EditorState,
  movable: readonly PlacedLayer[],
): ViewerDecal | null {
  const several = stampsIn(movable, material);
  const selected = layerById(design, selectedId);
  const own = isPlaced(selected) ? stampsIn([selected], material) : [];
  const [layer] = own.length > 0 ? own : several;
  if (!layer) return null;
  const { id, name, visible, projector } = layer;
  const held = { id, name, materials: materialsOf(layer), visible, projector, aspect: 1 };
  if (several.length > 1) return { ...held, id: TOGETHER, projector: stampsBox(several) };
  return { ...held, locked: isLocked(design, id) };
}
