/** A material by its index, or the error that says which there are. */
import { TexelcastError } from "../web/core/texelcast-error.ts";
import type { MaterialInfo, ModelInfo } from "../web/engine/engine-api.ts";

/** What asks for a material: a document and its field, or an option. */
export interface WantedBy {
  readonly file: string;
  readonly field: string;
}

/**
 * @param wantedBy Without it, `--material` asks.
 * @throws TexelcastError "no-material".
 */
export function findMaterial(model: ModelInfo, index: number, wantedBy?: WantedBy): MaterialInfo {
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

/**
 * The same, and it has a texture that can be painted.
 *
 * @throws TexelcastError "no-material", or with the code of the material's refusal, such as "no-uvs".
 */
export function findPaintable(model: ModelInfo, index: number, wantedBy?: WantedBy): MaterialInfo {
  const material = findMaterial(model, index, wantedBy);
  const { refusal } = material;
  if (refusal === null) return material;
  const field = wantedBy?.field ?? "--material";
  const others = model.materials.filter((other) => other.refusal === null).map(nameOf);
  throw new TexelcastError(
    refusal.code,
    `${field}: material ${nameOf(material)} cannot be painted: ${refusal.message}`,
    {
      subject: wantedBy?.file ?? model.name,
      field,
      value: String(index),
      hint:
        others.length > 0
          ? `Choose one that can: ${others.join(", ")}.`
          : "Unwrap the model with “texelcast unwrap”, or in a 3D program.",
    },
  );
}

const nameOf = ({ index, name }: MaterialInfo): string =>
  name === "" ? `${index}` : `${index} (${JSON.stringify(name)})`;
