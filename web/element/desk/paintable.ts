/** Which of a model's materials a desk works on. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { ModelInfo } from "../../engine/engine-api.ts";
import type { DeskSettings } from "./desk-settings.ts";

/** The material that the page asks for, else the paintable one with the most triangles. Throws why there is none. */
export function paintableMaterial({ name, materials }: ModelInfo, { material, words }: DeskSettings): number {
  const open = materials.filter(({ refusal }) => refusal === null);
  const [largest] = open.toSorted((a, b) => b.triangles - a.triangles);
  if (open.some(({ index }) => index === material)) return material ?? 0;
  const asked = material === null ? undefined : materials.find(({ index }) => index === material);
  if (material === null && largest) return largest.index;
  const refusal = asked?.refusal ?? materials.find((each) => each.refusal !== null)?.refusal;
  throw new TexelcastError(
    refusal?.code.toLowerCase().replaceAll("_", "-") ?? "bad-argument",
    refusal?.message ?? words.errors.notOpenable,
    { subject: name, field: "material", value: String(material) },
  );
}
