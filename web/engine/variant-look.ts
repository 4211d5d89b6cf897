/**
 * A model in the look of one of its variants (KHR_materials_variants), its materials numbered as before: what a design says of
 * a material holds in every look, and what is designed on one is on the others, too.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { ModelSource } from "./engine-api.ts";
import { stringifyExact } from "./exact-numbers.ts";
import { parseJson, readContainer, writeGlb } from "./gltf-container.ts";
import { indexAt, type JsonObject, listOf, objectAt } from "./gltf-json.ts";
import { materialFor, primitivesOf, VARIANTS, variantsOf } from "./material-variants.ts";

/**
 * The model with each material in the place of the one that the variant takes away, and without the variants. Where a variant
 * parts what has one material, the first part keeps its number and the others have new ones, behind all that there are.
 *
 * @param variant as the model calls it
 * @throws TexelcastError "bad-container"; "bad-model", its reason "which-variant", naming those that there are
 */
export function inVariant(source: ModelSource, variant: string): ModelSource {
  const container = readContainer(source);
  const json = parseJson(container);
  dress(json, placeOf(variant, source), source.name);
  takeOut(json, source.name);
  const bytes = container.isBinary
    ? writeGlb(json, container.binary, container.extraChunks)
    : new TextEncoder().encode(stringifyExact(json));
  return { ...source, bytes };
}

function placeOf(variant: string, source: ModelSource): number {
  const names = variantsOf(source)?.names ?? [];
  const place = names.indexOf(variant);
  if (place >= 0) return place;
  const all = names.map((name) => `“${name}”`).join(", ");
  throw new TexelcastError("bad-model", `“${source.name}” has no variant “${variant}”${all && `, but ${all}`}.`, {
    subject: source.name,
    field: "variant",
    value: variant,
    hint: all ? "Name one of them." : `Leave out “#variant=${variant}”: the model has one look.`,
    reason: "which-variant",
  });
}

function dress(json: JsonObject, variant: number, name: string): void {
  const before = listOf(json, "materials", name);
  const looks: JsonObject[] = [...before];
  const primitives = primitivesOf(json, name);
  // What glTF implies has the number behind all others, which is to stay its own.
  const implied = before.length;
  if (primitives.some((primitive) => primitive.material === undefined)) looks.push({});
  /** Of each material by its number the ones that it became, with their numbers. */
  const became = new Map<number, Map<number, number>>();
  for (const primitive of primitives) {
    const own = indexAt(primitive, "material");
    const mapped = materialFor(primitive, variant);
    // What the file has no material for, and what is no number, stays for whoever reads the model to refuse.
    if (own === undefined ? primitive.material !== undefined : own >= before.length) continue;
    if (mapped !== undefined && mapped >= before.length) {
      primitive.material = mapped;
      continue;
    }
    const from = own ?? implied;
    const to = mapped ?? implied;
    const numbers = became.get(from) ?? new Map<number, number>();
    became.set(from, numbers);
    const number = numbers.get(to) ?? (numbers.size === 0 ? from : looks.length);
    numbers.set(to, number);
    looks[number] = before[to] ?? {};
    primitive.material = number;
  }
  if (looks.length > 0) json.materials = looks;
}

function takeOut(json: JsonObject, name: string): void {
  for (const holder of [json, ...primitivesOf(json, name)]) {
    const extensions = objectAt(holder, "extensions");
    if (extensions === undefined) continue;
    delete extensions[VARIANTS];
    if (Object.keys(extensions).length === 0) delete holder.extensions;
  }
  for (const list of ["extensionsUsed", "extensionsRequired"]) {
    const named = json[list];
    if (!Array.isArray(named)) continue;
    const others = named.filter((extension) => extension !== VARIANTS);
    if (others.length > 0) json[list] = others;
    else delete json[list];
  }
}
