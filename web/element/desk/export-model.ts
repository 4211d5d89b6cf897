/** The product with the design on it, as a page asks for it. */
import { paintedMaterials } from "../../editor/state/design-edits.ts";
import { ToldError } from "../../editor/strings/told-error.ts";
import type { ExportModelOptions } from "../element-api.ts";
import type { AtDesk } from "../mode.ts";
import { checkNames } from "./unknown-option.ts";

const FORMATS = ["glb", "usdz"] as const;

/** Rejects with "bad-argument", naming the option, what stands there and what may. */
export async function exportModel(mode: AtDesk, options: ExportModelOptions): Promise<Uint8Array<ArrayBuffer>> {
  const { desk } = mode;
  const { words } = desk.settings;
  checkNames(options, ["format"], words);
  const { format = "glb" } = options;
  if (!FORMATS.includes(format)) {
    const details = { field: "format", value: String(format), hint: FORMATS.map((each) => `"${each}"`).join(", ") };
    throw new ToldError("bad-argument", words.errors.badOption("format"), details);
  }
  await mode.idle();
  const materials = paintedMaterials(desk.shown);
  return await (format === "usdz" ? desk.engine.exportUsdz(materials) : desk.engine.exportGlb(materials));
}
