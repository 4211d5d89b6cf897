/** What a page says of a new picture or text, checked before anything is made of it: what is on the product can be read again. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { ToldError } from "../../editor/strings/told-error.ts";
import type { PlaceOptions, TextOptions } from "../element-api.ts";
import type { Words } from "../words/words.ts";
import type { Desk } from "./desk.ts";
import { checkNames } from "./unknown-option.ts";

/** Metres: wider or narrower than any product, and far from where a design's numbers end. */
const WIDTHS = [1e-6, 1e6] as const;

/** Those that a layer has under the same name. */
const OF_A_LAYER = ["name", "projector", "material", "color", "curve"] as const satisfies (keyof TextOptions)[];
const OF_A_PLACE = ["name", "projector", "position", "width", "material"] as const satisfies (keyof PlaceOptions)[];
const OF = { decal: OF_A_PLACE, text: [...OF_A_PLACE, "font", "color", "curve"] } as const;

/** Rejects with "bad-argument", naming the option, what stands there and what may. */
export async function checkOptions(desk: Desk, kind: keyof typeof OF, options: TextOptions): Promise<void> {
  const { words } = desk.settings;
  const refuse = (field: string, value: unknown, hint?: string): never => {
    const details = { field, value: String(value), ...(hint !== undefined && { hint }) };
    throw new ToldError("bad-argument", words.errors.badOption(field), details);
  };
  if (typeof options !== "object" || options === null) refuse("options", options, `{ ${OF[kind].join(", ")} }`);
  checkNames(options, OF[kind], words);
  const { position, width, material, font } = options;
  if (position !== undefined && !isPoint(position)) refuse("position", position, "[x, y, z]");
  if (width !== undefined && !isWidth(width)) refuse("width", width, WIDTHS.join(" – "));
  if (font !== undefined && !isFont(font)) refuse("font", font, '"inter-700", Blob, Uint8Array');
  const given = OF_A_LAYER.filter((name) => options[name] !== undefined);
  if (given.length === 0) return;
  // As a document that holds nothing else: its reader knows what every field may be.
  const { parseDesign } = await import("../../editor/document/parse-design.ts");
  const fields = Object.fromEntries(given.map((name) => [name, options[name]]));
  const base = {
    type: "text",
    text: "a",
    font: "a",
    projector: { kind: "uv", center: [0, 0], size: [1, 1], angle: 0 },
  };
  try {
    parseDesign({
      format: "texelcast-design",
      version: 1,
      assets: { a: { type: "font/ttf", uri: "a" } },
      layers: [{ ...base, ...fields }],
    });
  } catch (thrown) {
    const { field = "", value, message } = TexelcastError.wrap(thrown, "internal", "");
    refuse(field.replace("layers[0].", ""), value, message.replaceAll("layers[0].", ""));
  }
  const materials = desk.store.state.model?.info.materials ?? [];
  for (const each of [material ?? []].flat()) {
    if (materials.some(({ index }) => index === each)) continue;
    refuse("material", each, words.errors.zoneMaterialHint(materials.map(({ index }) => index).join(", ")));
  }
}

/** Of what is no text, is blank, or has more than so many characters. */
export function badText({ errors }: Words, text: unknown, most: number): ToldError {
  const blank = typeof text !== "string" || text.trim() === "";
  return new ToldError("bad-argument", blank ? errors.emptyText : errors.badOption("text"), {
    field: "text",
    value: blank ? String(text) : `${text.slice(0, 39)}…`,
    hint: `1 – ${most}`,
  });
}

const isWidth = (value: unknown): boolean => typeof value === "number" && value >= WIDTHS[0] && value <= WIDTHS[1];

const isFont = (value: unknown): boolean =>
  typeof value === "string" || value instanceof Blob || value instanceof Uint8Array;

const isPoint = (value: unknown): boolean =>
  Array.isArray(value) && value.length === 3 && value.every((part) => Number.isFinite(part));
