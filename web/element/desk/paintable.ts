/** Which of a model's materials a desk works on. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { ToldError } from "../../editor/strings/told-error.ts";
import type { ModelInfo } from "../../engine/engine-api.ts";
import type { DeskHooks } from "./desk-settings.ts";

/** What the page asked for last, by the open model: another size of the texture is no reason to tell of it again. */
const asked = new WeakMap<ModelInfo, number | null>();

/**
 * The material that the page asks for, else the paintable one with the most triangles; of one that the model does not have the
 * page is told, once. Throws why there is none.
 */
export function paintableMaterial(model: ModelInfo, hooks: Pick<DeskHooks, "settings" | "warn">): number {
  const { name, materials } = model;
  const { material, words } = hooks.settings();
  const isNews = asked.get(model) !== material;
  asked.set(model, material);
  const open = materials.filter(({ refusal }) => refusal === null);
  const [largest] = open.toSorted((a, b) => b.triangles - a.triangles);
  if (open.some(({ index }) => index === material)) return material ?? 0;
  const named = material === null ? undefined : materials.find(({ index }) => index === material);
  if (named === undefined && largest) {
    if (material !== null && isNews) {
      const hint = words.errors.zoneMaterialHint(open.map(({ index }) => index).join(", "));
      const details = { field: "material", value: String(material), hint };
      hooks.warn(new ToldError("bad-argument", words.errors.badOption("material"), details));
    }
    return largest.index;
  }
  const refusal = named?.refusal ?? materials.find((each) => each.refusal !== null)?.refusal;
  throw new (refusal ? TexelcastError : ToldError)(
    refusal?.code.toLowerCase().replaceAll("_", "-") ?? "bad-argument",
    refusal?.message ?? words.errors.notOpenable,
    { subject: name, field: "material", value: String(material) },
  );
}
