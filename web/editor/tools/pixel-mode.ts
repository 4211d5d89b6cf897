/** Where a texture is painted texel by texel. */
import type { EditorState } from "../state/editor-state.ts";

/** Texels: textures up to this size are skins that are painted texel by texel, unless the user says otherwise. */
const PIXEL_MODE_UP_TO = 128;

/** As the user says, else where the material's texture is small. */
export function isPixelated(
  { toolSettings, targets }: Pick<EditorState, "toolSettings" | "targets">,
  material: number | null,
): boolean {
  const target = material === null ? undefined : targets.get(material);
  if (target === undefined) return false;
  return toolSettings.pixelMode ?? Math.max(target.width, target.height) <= PIXEL_MODE_UP_TO;
}
