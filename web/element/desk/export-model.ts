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
  const refuse = (field: string, value: unknown, hint: string): never => {
    throw new ToldError("bad-argument", words.errors.badOption(field), { field, value: String(value), hint });
  };
  if (typeof options !== "object" || options === null) refuse("options", options, "{ format }");
  checkNames(options, ["format"], words);
  const { format = "glb" } = options;
  if (!FORMATS.includes(format)) refuse("format", format, FORMATS.map((each) => `"${each}"`).join(", "));
  await mode.idle();
  const materials = paintedMaterials(desk.shown);
  return await (format === "usdz" ? desk.engine.exportUsdz(materials) : desk.engine.exportGlb(materials));
}
