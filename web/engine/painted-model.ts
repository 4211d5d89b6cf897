/** A model with the pictures of its open targets inside, as the files that are exported. */
import type { Session } from "../core/session.ts";
import { goesBeyond } from "./beyond-texture.ts";
import { checkValue, maybe } from "./check-value.ts";
import type { LoadedModel } from "./model-loader.ts";
import { type TextureEdit, writeModel } from "./model-writer.ts";
import type { OpenTarget } from "./open-target.ts";
import { encodePng } from "./png-encoder.ts";

const MATERIALS = maybe({
  must: "a list of materials' indices",
  holds: (value) => Array.isArray(value) && value.every(Number.isInteger),
});

/** By material, drawn. */
export type OpenTargets = ReadonlyMap<number, OpenTarget>;

/** @param materials those to paint; all that are open without them */
export async function paintedGlb(
  { original }: LoadedModel,
  session: Session,
  targets: OpenTargets,
  materials?: readonly number[],
): Promise<Uint8Array<ArrayBuffer>> {
  checkValue(materials, MATERIALS, "materials");
  const edits: TextureEdit[] = [];
  for (const [material, target] of targets) {
    if (materials?.includes(material) === false) continue;
    const png = await encodePng(target.exportedPicture());
    const info = session.materialInfo(material);
    const repeats = [goesBeyond(info, 0), goesBeyond(info, 1)] as const;
    edits.push({ material, png, texCoord: info.texCoord, factorBaked: target.factorBaked, repeats });
  }
  return writeModel(original, edits);
}

/** The same as USDZ. */
export async function paintedUsdz(...painted: Parameters<typeof paintedGlb>): Promise<Uint8Array<ArrayBuffer>> {
  const [{ writeUsdz }, glb] = await Promise.all([import("./usdz/write-usdz.ts"), paintedGlb(...painted)]);
  return await writeUsdz(glb, painted[0].name);
}
