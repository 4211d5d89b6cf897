/** Parts of the model whose material takes no paint: what lies on one of them alone is seen nowhere, which is said. */
import type { MaterialInfo } from "../../engine/engine-api.ts";
import type { Strings } from "../strings.ts";
import type { NoticeBoard } from "./notice-board.ts";

/** Why a material takes no paint, by its refusal's code, in a few words. */
export function whyNotPaintable(code: string, { target: { whyNot } }: Strings): string {
  return Object.hasOwn(whyNot, code) ? whyNot[code as keyof typeof whyNot] : whyNot.other;
}

/** Says that nothing is painted on a part of that material; nothing where `material` is null, or takes paint after all. */
export function tellBarePart(material: MaterialInfo | null, board: NoticeBoard): void {
  if (!material?.refusal) return;
  const { strings } = board;
  const name = strings.materialName(material.index, material.name);
  board.info({
    title: strings.notices.barePart,
    message: strings.notices.barePartWhy(name, whyNotPaintable(material.refusal.code, strings)),
    ...(material.refusal.code === "no-uvs" && { hint: strings.errors.noUvsHint }),
  });
}
