/** What a page asks of a print, checked before the engine is asked: it is told in the element's words which option is wrong. */
import { ToldError } from "../../editor/strings/told-error.ts";
import { type OptionFault, printOptionFault, saidPrintOptions } from "../../engine/print-options.ts";
import type { ExportedTexture, ExportTextureOptions } from "../element-api.ts";
import type { AtDesk } from "../mode.ts";
import type { Words } from "../words/words.ts";
import type { Desk } from "./desk.ts";
import { exportTexture, printOptions } from "./prints.ts";
import { unknownOption } from "./unknown-option.ts";

/** Rejects with "bad-argument", naming the option, what stands there and what may. */
export async function exportAsAsked(mode: AtDesk, options: ExportTextureOptions): Promise<ExportedTexture> {
  const { desk } = mode;
  checkPrintOptions(desk, options);
  return await exportTexture(mode, printOptions(mode, saidPrintOptions(options), desk.settings));
}

const CLASH = {
  en: {
    message: (dpi: string) => `A print whose size is given cannot be made to have ${dpi} DPI.`,
    hint: "Give size or dpi; with flattened, both.",
  },
  de: {
    message: (dpi: string) => `Ein Druck, dessen Größe feststeht, kann nicht auf ${dpi} DPI gebracht werden.`,
    hint: "Gib size oder dpi an; mit flattened auch beide.",
  },
};

function clash({ field, value }: OptionFault, { language }: Words): ToldError {
  const { message, hint } = CLASH[language];
  return new ToldError("bad-argument", message(value), { field, value, hint });
}

function checkPrintOptions(desk: Desk, options: ExportTextureOptions): void {
  const { words } = desk.settings;
  const { errors } = words;
  const refuse = (field: string, value: string, hint: string): never => {
    throw new ToldError("bad-argument", errors.badOption(field), { field, value, hint });
  };
  const fault = printOptionFault(options);
  if (fault?.kind === "unknown") throw unknownOption(fault.field, fault.value, fault.allowed, words);
  if (fault?.kind === "clash") throw clash(fault, words);
  if (fault) refuse(fault.field, fault.value, fault.allowed);
  const { material, zone, flattened } = options;
  const materials = (desk.store.state.model?.info.materials ?? []).filter(({ refusal }) => refusal === null);
  if (material !== undefined && !materials.some(({ index }) => index === material)) {
    refuse("material", String(material), errors.zoneMaterialHint(materials.map(({ index }) => index).join(", ")));
  }
  const ids = (desk.zones?.zones ?? []).map(({ id }) => JSON.stringify(id)).join(", ");
  const named = desk.zones?.zones.find(({ id }) => id === zone);
  if (zone !== undefined && !named) refuse("zone", JSON.stringify(zone), ids || "zones: { … }");
  if (flattened && !named) refuse("flattened", "true", `zone: ${ids || "…"}`);
  if (named && material !== undefined && material !== named.material) {
    refuse("material", String(material), String(named.material));
  }
}
