/** Words on the product: put on, typed, dressed; their box follows them. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { Design, DesignAsset, Projector, TextLayer } from "../../editor/document/design.ts";
import { freeIdIn } from "../../editor/document/layer-tree.ts";
import { makeTextLayer } from "../../editor/document/make-layer.ts";
import { resolveWords } from "../../editor/document/resolve-layers.ts";
import { addOnTop, layerById, patchLayer, withAsset, withoutUnusedAssets } from "../../editor/state/design-edits.ts";
import { fitsClosely, refitted } from "../../editor/state/text-box.ts";
import { contentHash } from "../../editor/storage/content-hash.ts";
import { ToldError } from "../../editor/strings/told-error.ts";
import type { EngineText, TextMeasure } from "../../engine/engine-api.ts";
import { SHIPPED_FONTS, type ShippedFontId, shippedFontAddress } from "../../engine/shipped-fonts.ts";
import type { DecalViewer } from "../../viewer/viewer-api.ts";
import type { TextOptions } from "../element-api.ts";
import { PLACING_WORDS } from "../words/placing-words.ts";
import type { Desk } from "./desk.ts";
import { askShop, badOption, checkedOptions, placeFor } from "./placing.ts";

export type TextPatch = Partial<Pick<TextLayer, "text" | "color" | "curve">> & { readonly font?: NamedFont };

export interface NamedFont {
  readonly name: string;
  readonly asset: DesignAsset;
}

const FIRST_FONT = "inter-700";
const FIRST_COLOR = "#1a1a1a";
const MOST_CHARACTERS = 10_000;
/** Milliseconds of rest after which what was typed is a step: a page that took the design for approved hears of it. */
const REST = 1000;
/** A place to measure at. */
const NOWHERE: Projector = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] };

export class Texts {
  readonly #desk: Desk;
  /** The change asked for last: of several that wait for their measure only the newest is shown. */
  #newest: TextPatch | null = null;
  /** What a text's field has said since the product last showed all of it. */
  #typed: { readonly id: string; readonly texts: string[] } = { id: "", texts: [] };
  /** By their layers' ids, those chosen last: one that comes later, as it is slow, does not take their place. */
  readonly #fonts: Record<string, NamedFont> = {};
  #rest: ReturnType<typeof setTimeout> | undefined;

  constructor(desk: Desk) {
    this.#desk = desk;
  }

  /** Gives the layer's id. */
  async add(text: string, given?: TextOptions): Promise<string> {
    const desk = this.#desk;
    const { words } = desk.settings;
    desk.checkRoom();
    if (!isText(text)) throw (await import("./check-options.ts")).badText(words, text, MOST_CHARACTERS);
    const options = await checkedOptions(desk, "text", given);
    const font = await this.#font(options.font ?? FIRST_FONT);
    try {
      // Not before: the shop may ask for the design while it makes up its mind about a font.
      return await desk.during(this.#put(text, font, options));
    } finally {
      desk.library.release([font.asset]);
    }
  }

  async #put(text: string, font: NamedFont, options: TextOptions): Promise<string> {
    const desk = this.#desk;
    const { design, key } = withAsset(desk.design, font.name, font.asset);
    const { name = shortened(text), curve = 0 } = options;
    const plain = makeTextLayer({ id: "", name, projector: NOWHERE, text, font: key, curve });
    const [viewer, room] = await Promise.all([desk.takeHands(), this.#measure(plain, design.assets)]);
    const place = await placeFor(desk, viewer, room.width / room.height, options, null);
    const color = options.color ?? (await this.#legible(viewer, place.projector)) ?? FIRST_COLOR;
    desk.checkRoom();
    desk.keepShown();
    // The design may be another one since the words were measured.
    const now = withAsset(desk.design, font.name, font.asset);
    const id = freeIdIn(now.design);
    const layer = { ...plain, ...place, id, color, font: now.key, fontSize: 1 / room.height };
    const { words } = desk.settings;
    desk.record(addOnTop(now.design, layer), words.steps.addText);
    desk.select(id);
    desk.hooks.announce(words.announce.added(name));
    return id;
  }

  /** Where what looks at the product does not come, nothing is known of it. */
  async #legible({ surface }: DecalViewer, projector: Projector): Promise<string | null> {
    const found = await import("../../editor/state/legible-color.ts").catch(() => null);
    return (await found?.legibleColor(this.#desk, surface, projector)) ?? null;
  }

  /** Shows a change and records it when it rests, or at once (`final`); the box goes on lying close about the words. */
  change(id: string, patch: TextPatch, final: boolean): Promise<void> {
    const desk = this.#desk;
    if (patch.font) this.#fonts[id] = patch.font;
    if (patch.text !== undefined) {
      if (this.#typed.id !== id) this.#typed = { id, texts: [] };
      this.#typed.texts.push(patch.text);
    }
    clearTimeout(this.#rest);
    if (!final) this.#rest = setTimeout(() => desk.settled().then(() => desk.keepShown()), REST);
    const failed = async (thrown: unknown): Promise<never> => {
      // Where that fails too, the first fault is the one to tell.
      if (patch === this.#newest && patch.text !== undefined) await this.#typeAgain(id, patch).catch(() => undefined);
      throw thrown;
    };
    return desk.during(this.#change(id, patch, final).catch(failed));
  }

  /** Shows what was typed without the letters that cannot be drawn: those before and behind them stay. */
  async #typeAgain(id: string, newest: TextPatch): Promise<void> {
    const { texts } = this.#typed;
    const layer = this.#layer(id);
    const shown = layerById(this.#desk.shown, id);
    if (layer === null || shown?.type !== "text") return;
    const { withoutUndrawable } = await import("./retyped.ts");
    const draws = (text: string): Promise<unknown> => this.#measure({ ...layer, text }, this.#desk.design.assets);
    const kept = await withoutUndrawable(shown.text, texts, draws, () => this.#newest === newest);
    // What is typed meanwhile sees to itself.
    if (kept === null) return;
    this.#typed = { id, texts: [] };
    if (kept !== shown.text) await this.#change(id, { text: kept }, false);
  }

  async #change(id: string, patch: TextPatch, final: boolean): Promise<void> {
    const desk = this.#desk;
    const layer = this.#layer(id);
    if (layer === null || desk.settings.readonly) return;
    const { font, ...fields } = patch;
    this.#newest = patch;
    if (final && !font && isSame(layer, fields)) {
      desk.session.cancelPreview();
      return;
    }
    const dressed = (): { design: Design; key: string } =>
      font ? withAsset(desk.design, font.name, font.asset) : { design: desk.design, key: layer.font };
    const { design, key } = dressed();
    const named =
      fields.text === undefined || layer.name !== shortened(layer.text) ? {} : { name: shortened(fields.text) };
    const changed: TextLayer = { ...layer, ...fields, ...named, font: key };
    const [old, now] = await Promise.all([this.#measure(layer, design.assets), this.#measure(changed, design.assets)]);
    // A newer one shows itself; what is to be recorded must not go for it.
    if (!final && patch !== this.#newest) return;
    if (fields.text !== undefined && patch === this.#newest) this.#typed = { id, texts: [] };
    const superseded = font && font !== this.#fonts[id];
    if (superseded || this.#layer(id) !== layer) {
      await this.#change(id, superseded ? fields : patch, final);
      return;
    }
    const target = desk.store.state.targets.get(desk.material);
    const close = fitsClosely(layer, old, target ? target.width / target.height : 1);
    const box: Partial<TextLayer> = close ? refitted(changed, old, now) : {};
    const projector = box.projector && desk.hands?.resized(layer.projector, box.projector);
    // The design may have got other layers since the words were measured.
    const present = dressed();
    const edited = patchLayer<TextLayer>(present.design, id, {
      ...fields,
      ...named,
      font: present.key,
      ...box,
      ...(projector && { projector }),
    });
    if (final) desk.session.record(font ? withoutUnusedAssets(edited) : edited, desk.settings.words.steps.change);
    else desk.session.preview(edited);
  }

  #layer(id: string): TextLayer | null {
    const layer = layerById(this.#desk.design, id);
    return layer?.type === "text" ? layer : null;
  }

  async #font(font: string | Blob | Uint8Array): Promise<NamedFont> {
    if (typeof font === "string") {
      if (!Object.hasOwn(SHIPPED_FONTS, font)) {
        throw badOption(this.#desk.settings.words, "font", font, Object.keys(SHIPPED_FONTS).join(", "));
      }
      return shippedFont(font as ShippedFontId);
    }
    const bytes = font instanceof Uint8Array ? font : new Uint8Array(await font.arrayBuffer());
    const name = font instanceof File ? font.name : "font";
    await admitFont(this.#desk, name, bytes);
    return await this.#desk.library.addFont(name, bytes);
  }

  async #measure(layer: TextLayer, assets: Readonly<Record<string, DesignAsset>>): Promise<TextMeasure> {
    const words: EngineText = resolveWords(layer, assets);
    const key = this.#desk.library.engineKey(assets[layer.font]);
    try {
      return await this.#desk.engine.measureText({ ...words, font: key ?? words.font, fontSize: 1 });
    } catch (thrown) {
      throw fontMissing(thrown) ? this.#plainly(thrown) : thrown;
    }
  }

  /** Whoever types has no say in the address that could not be fetched; the page is told it beside. */
  #plainly(cause: TexelcastError): ToldError {
    const { words } = this.#desk.settings;
    const { message, hint } = { ...PLACING_WORDS[words.language].noFont, ...words.own?.noFont };
    return new ToldError(cause.code, message, { ...cause.toJSON(), hint, cause });
  }
}

/** What letters are drawn with lies beside the element's own scripts, and comes when it is needed. */
const fontMissing = (thrown: unknown): thrown is TexelcastError =>
  thrown instanceof TexelcastError && thrown.reason === "not-loaded";

/** Rejects with "bad-font", and with "refused" where the shop does not take it. */
export async function admitFont(desk: Desk, name: string, bytes: Uint8Array): Promise<void> {
  const { readFontHeader } = await import("../../engine/font-file.ts");
  const type = `font/${readFontHeader(bytes, name).format}` as const;
  const own = new Uint8Array(bytes);
  await askShop(desk, { name, type, bytes: own, width: 0, height: 0, sha256: await contentHash(bytes) });
}

/** A font that comes with Texelcast, as a text takes it. */
export function shippedFont(id: ShippedFontId): NamedFont {
  return { name: id, asset: { type: "font/ttf", uri: shippedFontAddress(id) } };
}

const isText = (text: unknown): boolean =>
  typeof text === "string" && text.trim() !== "" && text.length <= MOST_CHARACTERS;

/** The end of typing may have been recorded before: what is handed in holds it. */
const isSame = (layer: TextLayer, fields: Partial<TextLayer>): boolean =>
  Object.entries(fields).every(([name, value]) => layer[name as keyof TextLayer] === value);

const shortened = (text: string): string => {
  const line = text.trim().replace(/\s+/g, " ");
  return line.length > 40 ? `${line.slice(0, 39)}…` : line;
};
