/** A material by its index, or the error that says which there are. */
import { TexelcastError } from "../web/core/texelcast-error.ts";
import type { MaterialInfo, ModelInfo } from "../web/engine/engine-api.ts";

/**
 * @param wantedBy The design and its field that ask for the material; without it, `--material` does.
 * @throws TexelcastError "no-material".
 */
export function findMaterial(
  model: ModelInfo,
  index: number,
  wantedBy?: { readonly file: string; readonly field: string },
): MaterialInfo {
  const material = model.materials[index];
  if (material !== undefined) return material;
  const last = model.materials.length - 1;
  const there = last < 0 ? "none" : last === 0 ? "only material 0" : `materials 0 to ${last}`;
  const field = wantedBy?.field ?? "--material";
  throw new TexelcastError("no-material", `${field}: the model has no material ${index}, it has ${there}`, {
    subject: wantedBy?.file ?? model.name,
    field,
    value: String(index),
    hint: "`texelcast inspect` lists the materials of a model.",
  });
}
