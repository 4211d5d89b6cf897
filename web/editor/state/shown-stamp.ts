/** Which flat stamp the texture view shows with handles. */
import type { ViewerDecal } from "../../viewer/viewer-api.ts";
import { materialsOf } from "../document/index.ts";
import { isLocked } from "../document/layer-tree.ts";
import { layerById } from "./design-edits.ts";
import type { EditorState } from "./editor-state.ts";

/**
 * The selected stamp, where it lies in the texture that is shown; null otherwise. One that covers the whole texture is no
 * stamp to be moved but a sheet of pixels.
 */
export function shownStamp({ design, selectedId, material }: EditorState): ViewerDecal | null {
  const layer = layerById(design, selectedId);
  if ((layer?.type !== "decal" && layer?.type !== "text") || layer.projector.kind !== "uv") return null;
  const materials = materialsOf(layer);
  const { center, size, angle } = layer.projector;
  const isSheet = angle === 0 && center.every((place) => place === 0.5) && size.every((extent) => extent === 1);
  if (isSheet || material === null || !materials.includes(material)) return null;
  const { id, name, visible, projector } = layer;
  return { id, name, materials, visible, locked: isLocked(design, id), projector, aspect: 1 };
}
