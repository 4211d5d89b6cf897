/** Whether a design was made for a model: what it names of the model must be there, before anything is drawn of it. */
import { TexelcastError } from "../web/core/texelcast-error.ts";
import { formatPath } from "../web/editor/document/design-problem.ts";
import { type Design, materialsOf, walkLayers } from "../web/editor/document/index.ts";
import type { ModelInfo } from "../web/engine/engine-api.ts";
import { findMaterial } from "./find-material.ts";

type Path = readonly (string | number)[];

/**
 * Every material and triangle that a layer names must be there, even of one that is hidden, is a mask, or is left out of this
 * run: a design is taken whole or not at all.
 *
 * @throws TexelcastError "no-material", "bad-design".
 */
export function checkFit(model: ModelInfo, design: Design, file: string): void {
  for (const { layer, path } of walkLayers(design)) {
    if (layer.type === "group" || layer.type === "paint") continue;
    materialsOf(layer).forEach((index, place) => {
      const at = typeof layer.material === "number" ? [] : [place];
      const material = findMaterial(model, index, { file, field: formatPath([...path, "material", ...at]) });
      if (layer.type !== "fill" || !layer.parts) return;
      const { kind } = layer.parts;
      const named = layer.parts.kind === "charts" ? layer.parts.charts : layer.parts.faces;
      checkTriangles(named, material.triangles, { file, path: [...path, "parts", kind], index });
    });
  }
}

/**
 * What is to be painted must have a texture: told by the layer that asks for it, which the engine does not know.
 *
 * @throws TexelcastError with the code of the material's refusal, such as "no-uvs".
 */
export function checkPaintable(model: ModelInfo, design: Design, file: string, materials: readonly number[]): void {
  for (const { layer, path, shown, inMask } of walkLayers(design)) {
    if (layer.type === "group" || layer.type === "paint" || !shown || inMask) continue;
    const index = materialsOf(layer).find((own) => materials.includes(own) && model.materials[own]?.refusal);
    const material = index === undefined ? undefined : model.materials[index];
    if (!material?.refusal) continue;
    const field = formatPath([...path, "material"]);
    const name = material.name === "" ? "" : ` (${JSON.stringify(material.name)})`;
    const message = `${field}: material ${index}${name} cannot be painted: ${material.refusal.message}`;
    throw new TexelcastError(material.refusal.code, message, {
      subject: file,
      field,
      value: String(index),
      hint: "Put the layer on another material; `texelcast inspect` tells which can take decals.",
    });
  }
}

function checkTriangles(
  named: readonly number[],
  count: number,
  { file, path, index }: { readonly file: string; readonly path: Path; readonly index: number },
): void {
  const place = named.findIndex((triangle) => triangle >= count);
  if (place < 0) return;
  const field = formatPath([...path, place]);
  const message = `${field}: is ${named[place]}, but material ${index} has ${count} triangles, counted from 0`;
  throw new TexelcastError("bad-design", message, {
    subject: file,
    field,
    value: String(named[place]),
    hint: "The fill was made for another model, or for another material: choose its parts anew.",
  });
}
