/** What a user does with words: put on the model, typed, dressed; their box follows them. */
import { cutText } from "../../core/cut-text.ts";
import type { Engine, EngineText, Projector, TextMeasure } from "../../engine/engine-api.ts";
import { type ShippedFontId, shippedFontAddress } from "../../engine/shipped-fonts.ts";
import type { ModelViewer, SurfaceHit } from "../../viewer/viewer-api.ts";
import { DESIGN_LIMITS } from "../document/design-limits.ts";
import {
  type Design,
  type DesignAsset,
  type DesignLayer,
  makeTextLayer,
  materialsOf,
  type TextLayer,
} from "../document/index.ts";
import { isLocked, walkLayers } from "../document/layer-tree.ts";
import { resolveWords } from "../document/resolve-layers.ts";
import { withoutCount } from "../files/counted-name.ts";
import type { Unmeasured } from "../storage/last-words.ts";
import type { Admission } from "./admission.ts";
import type { AssetLibrary } from "./asset-library.ts";
import type { DecalCommands, NewPlace } from "./decal-commands.ts";
import { freeName, layerById, patchLayer, withAsset, withoutUnusedAssets } from "./design-edits.ts";
import type { DesignSession } from "./design-session.ts";
import type { EditorState } from "./editor-state.ts";
import { legibleColor } from "./legible-color.ts";
import type { NoticeBoard } from "./notice-board.ts";
import type { Store } from "./store.ts";
import type { Tasks } from "./tasks.ts";
import { emOf, fitsClosely, fitted, refitted, withEm } from "./text-box.ts";
import { isAllRound, newlyMissing, runsPastEdge, shareOfModel } from "./text-troubles.ts";
import { type WaitingChange, WaitingChanges } from "./waiting-changes.ts";

export type TextFieldsPatch = Partial<
  Pick<TextLayer, "text" | "letterSpacing" | "align" | "curve" | "color" | "outline">
>;
export interface TextPatch extends TextFieldsPatch {
  /** What takes the place of the layer's font. */
  readonly fontAsset?: { readonly name: string; readonly asset: DesignAsset };
}

type TextChange = WaitingChange<TextPatch>;

export interface TextCommandsParts {
  readonly engine: Pick<Engine, "measureText" | "readTexels">;
  readonly viewer: Pick<ModelViewer, "materialsReached" | "surface">;
  readonly session: DesignSession;
  readonly store: Store<EditorState>;
  readonly board: NoticeBoard;
  readonly library: AssetLibrary;
  readonly decals: DecalCommands;
  readonly admission: Admission | null;
  readonly tasks: Pick<Tasks, "run">;
}

/** A text that is on its way to the model. */
interface ComingText {
  readonly model: EditorState["model"];
  readonly fontName: string;
  /** Where it was asked for last; null for the middle of the view. */
  hit: SurfaceHit | null;
  readonly done: Promise<void>;
}

const FIRST_FONT: ShippedFontId = "inter-700";
const REMEMBERED = 400;

export class TextCommands {
  readonly #parts: TextCommandsParts;
  readonly #measured = new Map<string, TextMeasure>();
  /** Counts what was asked for: of several changes to be shown that wait for their measure only the newest is. */
  #asked = 0;
  /** The changes that wait for their measure, to be steps then, however slow their fonts are. */
  readonly #waiting = new WaitingChanges<TextPatch>();
  #coming: ComingText | null = null;

  constructor(parts: TextCommandsParts) {
    this.#parts = parts;
  }

  get selected(): TextLayer | undefined {
    const { selected } = this.#parts.session;
    return selected?.type === "text" ? selected : undefined;
  }

  /**
   * Puts a text on the model: at `hit`, else in the middle of the view, and asks the panel to have it typed. Asked for again
   * while its font is on its way, it is that one text, at the place that was named last.
   */
  async add(hit: SurfaceHit | null = null, font = shippedFont(FIRST_FONT)): Promise<void> {
    const { session, store } = this.#parts;
    const { model } = store.state;
    const coming = this.#coming;
    if (coming?.fontName === font.name && coming.model === model) {
      coming.hit = hit ?? coming.hit;
      return await coming.done;
    }
    const place = (): SurfaceHit | null => asked.hit;
    const asked: ComingText = { model, fontName: font.name, hit, done: this.#run(() => this.#add(place, font)) };
    this.#coming = asked;
    // What is saved meanwhile waits for the text.
    session.recordsLater(asked.done);
    try {
      await asked.done;
    } finally {
      if (this.#coming === asked) this.#coming = null;
    }
  }

  /** Puts words that were on the clipboard in the middle of the view. False for blank ones. */
  paste(pasted: string): boolean {
    const { session, store, board } = this.#parts;
    const words = pastedWords(pasted);
    if (words === "") return false;
    const { readonly, layers } = board.strings;
    if (store.state.readonly) board.info({ title: readonly.title, message: readonly.message });
    else if (!store.state.model) board.info({ title: layers.emptyWithoutModel, message: "" });
    else session.recordsLater(this.#run(() => this.#add(() => null, shippedFont(FIRST_FONT), words)));
    return true;
  }

  /** Whether a text is on its way that will have the keyboard once it is there. */
  get coming(): boolean {
    return this.#coming !== null;
  }

  /** Fonts may take long to come. */
  #run<T>(work: () => Promise<T>): Promise<T> {
    return this.#parts.tasks.run(this.#parts.board.strings.tasks.writing, work, { cancellable: false });
  }

  async #add(place: () => SurfaceHit | null, font: ReturnType<typeof shippedFont>, pasted?: string): Promise<void> {
    const { session, store, board, decals } = this.#parts;
    const { model } = store.state;
    if (!model || store.state.switching) return;
    const dressed = (): ReturnType<typeof withAsset> => withAsset(session.recordedDesign, font.name, font.asset);
    try {
      this.#parts.admission?.checkRoom(1);
      const { design: measured, key: measuredFont } = dressed();
      const text = pasted ?? board.strings.text.sample;
      const plain = makeTextLayer({ id: "", text, font: measuredFont, projector: NOWHERE });
      const name = pasted === undefined ? plain.name : titleOf(pasted);
      const room = await this.#measure(this.#wordsOf(plain, measured.assets));
      // The place was one on that model.
      const isGone = (): boolean => store.state.model !== model || store.state.switching;
      const placed = await this.#placed(place, room.width / room.height, isGone);
      if (placed === null) return;
      const { spot, color } = placed;
      this.#parts.admission?.checkRoom(1);
      decals.addLayer(spot, board.strings.steps.addText, (id, projector, material) => {
        // The design may be another one since the words were measured.
        const { design, key } = dressed();
        const look = { color: color ?? plain.color, font: key, fontSize: 1 / room.height };
        return { design, layer: { ...plain, ...look, id, name, projector, material } };
      });
      if (pasted === undefined) store.set({ textToType: session.selected?.id ?? null });
      board.announce(board.strings.announce.added(pasted === undefined ? board.strings.text.name : name));
      this.#tellUndrawn(name, room.missing);
    } catch (thrown) {
      board.error(board.strings.errors.couldNotWrite, thrown);
    }
  }

  /** Where words of that aspect go, and in which colour they are read there: anew where another place is named meanwhile. */
  async #placed(
    place: () => SurfaceHit | null,
    aspect: number,
    isGone: () => boolean,
  ): Promise<{ readonly spot: NewPlace; readonly color: string | null } | null> {
    const { viewer, decals } = this.#parts;
    while (!isGone()) {
      const hit = place();
      const spot = decals.placeFor(aspect, hit);
      const color = await legibleColor(this.#parts, viewer.surface, spot.projector);
      if (hit === place() && !isGone()) return { spot, color };
    }
    return null;
  }

  /** Shows a change that is still going on (typing, the scrub of a field); the newest one asked for wins. */
  async preview(id: string, patch: TextPatch): Promise<void> {
    this.#asked += 1;
    const request = this.#asked;
    const show = (design: Design): void => this.#parts.session.preview(design);
    const work = this.#apply({ id, patch }, () => request === this.#asked, show);
    // A page that asks for the design meanwhile gets it with the newest letter.
    this.#parts.session.recordsLater(work);
    await work;
  }

  cancelPreview(): void {
    this.#asked += 1;
    this.#parts.session.cancelPreview();
  }

  /** One step of the history, at once or when the words are measured; none where the layer is so already. */
  async change(id: string, patch: TextPatch, label: string, mergeKey?: string): Promise<void> {
    const { session } = this.#parts;
    this.#waiting.supersede(id, patch);
    const layer = layerById(session.recordedDesign, id);
    const fields = Object.entries(patch) as [keyof TextLayer, unknown][];
    if (layer?.type === "text" && fields.every(([name, value]) => Object.is(layer[name], value))) {
      this.cancelPreview();
      return;
    }
    this.#asked += 1;
    const record = (design: Design): void => session.record(design, label, mergeKey);
    const work = this.#run(() => this.#waiting.add({ id, patch }, (change) => this.#apply(change, () => true, record)));
    // What is saved meanwhile waits until the words are measured.
    session.recordsLater(work);
    const before = await work;
    if (before) await this.#tellTroubles(before);
  }

  /** What a page that is left now would lose, as nobody waits for a measure then. Null for nothing, and for what cannot be noted. */
  get unmeasured(): Unmeasured | null {
    const { recordedDesign } = this.#parts.session;
    const { only } = this.#waiting;
    if (!only || only.patch.fontAsset || isLocked(recordedDesign, only.id)) return null;
    const { id, patch } = only;
    const layer = layerById(recordedDesign, id);
    if (layer?.type !== "text" || patchLayer<TextLayer>(recordedDesign, id, patch) === recordedDesign) return null;
    return { id, before: picked(layer, patch), after: patch };
  }

  /** Does in this visit what was unmeasured when the page was left. */
  async finish({ id, after }: Unmeasured): Promise<void> {
    const { steps, text } = this.#parts.board.strings;
    await this.change(id, after, steps.change(text.name));
  }

  /** What an export lacks is told with it: characters that no font has. */
  async tellMissing(): Promise<void> {
    const { session, board } = this.#parts;
    const told: string[] = [];
    for (const { layer, shown } of walkLayers(session.recordedDesign, { masks: false, strokes: false })) {
      if (layer.type !== "text" || !shown) continue;
      // A font that cannot be had is told by the engine.
      const { missing } = await this.measure(layer).catch(() => ({ missing: [] }));
      if (missing.length > 0) told.push(board.strings.text.missingIn(layer.name, listed(missing)));
    }
    const { missingTitle, missingHint } = board.strings.text;
    if (told.length > 0) board.info({ title: missingTitle, message: told.join(" "), hint: missingHint });
  }

  /** What a recorded change has brought about that its user would not see until it is printed. */
  async #tellTroubles(before: TextLayer): Promise<void> {
    const { session, board, store } = this.#parts;
    const now = layerById(session.recordedDesign, before.id);
    if (now?.type !== "text" || now === before) return;
    const words = board.strings.text;
    const [old, room] = [this.measureOf(before), this.measureOf(now)];
    const missing = old && room ? newlyMissing(old, room) : [];
    this.#tellUndrawn(now.name, missing);
    const { model } = store.state;
    const action = { label: words.makeFit, run: () => this.#makeFit(now.id) };
    const troubles = [
      null,
      { title: words.pastEdgeTitle, message: words.pastEdge },
      { title: words.largeTitle, message: words.large },
    ];
    const troubleOf = (layer: TextLayer): number =>
      shareOfModel(model, layer.projector) > 1 ? 2 : this.#runsPastEdge(layer) ? 1 : 0;
    const trouble = troubleOf(now);
    const told = troubles[trouble];
    // What was so before is not told again, nor what has become less.
    if (told && trouble > troubleOf(before)) board.info({ ...told, action });
    if (isAllRound(now.projector) && !this.isClose(now) && this.isClose(before)) {
      const action = { label: words.fitBox, run: () => void this.fitBox(now) };
      board.info({ title: words.longTitle, message: words.long, action });
    }
  }

  #tellUndrawn(name: string, missing: readonly string[]): void {
    const { board } = this.#parts;
    const { missingTitle: title, missingIn, missingHint: hint } = board.strings.text;
    if (missing.length > 0) board.info({ title, message: missingIn(name, listed(missing)), hint });
  }

  /** In a frame, which words need not fill, nobody knows where they end. */
  #runsPastEdge(layer: TextLayer): boolean {
    return this.isClose(layer) && runsPastEdge(this.#parts.viewer, layer);
  }

  /** Makes a text that is larger than the model, or runs past its edge, as small as lies well on it. */
  #makeFit(id: string): void {
    const { session, board, store } = this.#parts;
    const layer = layerById(session.recordedDesign, id);
    if (layer?.type !== "text" || isLocked(session.recordedDesign, id)) return;
    const large = shareOfModel(store.state.model, layer.projector);
    let factor = large > 1 ? FITTING_SHARE / large : 1;
    let projector = withEm(layer, emOf(layer) * factor);
    const isPast = (box: Projector): boolean => runsPastEdge(this.#parts.viewer, { ...layer, projector: box });
    if (isPast(projector)) {
      // The side that its lines are aligned to may lie beyond the edge whatever its size, its middle hardly does.
      const about = (share: number): Projector => withEm({ ...layer, align: "center" }, emOf(layer) * share);
      while (factor > LEAST_FITTING && isPast(about(factor))) factor *= FITTING_STEP;
      projector = about(factor * FROM_EDGE);
    } else if (factor === 1) return;
    session.record(
      patchLayer<TextLayer>(session.recordedDesign, id, this.#parts.decals.placed(id, projector)),
      board.strings.steps.change(board.strings.text.size),
    );
  }

  /** A font of the user's: taken into the design, and given to the text. Rejects with "bad-font". */
  async useFontFile(fileName: string, bytes: Uint8Array, hit: SurfaceHit | null): Promise<void> {
    const { name, asset } = await this.#parts.library.addFont(fileName, bytes);
    const { selected } = this;
    try {
      if (selected)
        await this.change(
          selected.id,
          { fontAsset: { name, asset } },
          this.#parts.board.strings.steps.change(this.#parts.board.strings.text.font),
        );
      else await this.add(hit, { name, asset });
    } finally {
      this.#parts.library.release([asset]);
    }
  }

  /** Lays the box close about the words again, its height as it is. */
  async fitBox({ id }: TextLayer): Promise<void> {
    const { session, board, decals } = this.#parts;
    const present = (): DesignLayer | undefined => layerById(session.recordedDesign, id);
    let layer = present();
    while (layer?.type === "text") {
      const room = await this.#measure(this.#wordsOf(layer, session.recordedDesign.assets));
      if (present() === layer) {
        const fit = fitted(layer, room, this.#textureAspect(layer));
        session.record(
          patchLayer<TextLayer>(session.recordedDesign, id, decals.laid(layer, fit)),
          board.strings.steps.change(board.strings.properties.size),
        );
        return;
      }
      // It became another one meanwhile.
      layer = present();
    }
  }

  /** What is known of the room that a text asks for; undefined until it was measured, which `measure` does. */
  measureOf(layer: TextLayer): TextMeasure | undefined {
    return this.#measured.get(keyOf(this.#wordsOf(layer, this.#parts.session.design.assets)));
  }

  async measure(layer: TextLayer): Promise<TextMeasure> {
    return await this.#measure(this.#wordsOf(layer, this.#parts.session.design.assets));
  }

  isClose(layer: TextLayer): boolean {
    const room = this.measureOf(layer);
    return room === undefined || fitsClosely(layer, room, this.#textureAspect(layer));
  }

  /**
   * Puts the design with a change, when its words and those before it are measured and while it is `wanted`. The design, and
   * the change itself, may have become others in the meantime. Gives the layer that it was put to, if it was.
   */
  async #apply(change: TextChange, wanted: () => boolean, put: (design: Design) => void): Promise<TextLayer | null> {
    const { session, board } = this.#parts;
    const { model } = session.recorded;
    try {
      // Of another model's design nothing was asked.
      while (wanted() && session.recorded.model === model) {
        const before = session.recordedDesign;
        const layer = layerById(before, change.id);
        const { fontAsset, ...fields } = change.patch;
        if (layer?.type !== "text" || isLocked(before, layer.id) || isEmpty(change.patch)) return null;
        const { design, key } = fontAsset
          ? withAsset(before, fontAsset.name, fontAsset.asset)
          : { design: before, key: layer.font };
        const changed: TextLayer = { ...layer, ...fields, font: key };
        const words = [this.#wordsOf(layer, design.assets), this.#wordsOf(changed, design.assets)] as const;
        const [old, now] = words.map((each) => this.#measured.get(keyOf(each)));
        if (!old || !now) {
          await Promise.all(words.map((each) => this.#measure(each)));
          continue;
        }
        // Known at once, so that a click elsewhere, which ends the typing, comes after its step.
        const box = fitsClosely(layer, old, this.#textureAspect(layer))
          ? refitted({ ...layer, align: changed.align }, old, now)
          : null;
        const laid = box && this.#parts.decals.laid(layer, box);
        const name = this.#nameFor(layer, fields.text);
        const edited = patchLayer<TextLayer>(design, layer.id, { ...fields, name, font: key, ...laid });
        put(fontAsset ? withoutUnusedAssets(edited) : edited);
        return layer;
      }
    } catch (thrown) {
      board.error(this.#parts.board.strings.errors.couldNotWrite, thrown);
    }
    return null;
  }

  /** A text is called by its words for as long as nobody has called it otherwise. */
  #nameFor({ id, name, text: before }: TextLayer, text = before): string {
    const { sample } = this.#parts.board.strings.text;
    const [old, now] = [titleOf(before) || sample, titleOf(text) || sample];
    if (old === now || ![name, withoutCount(name)].includes(old)) return name;
    return freeName(this.#parts.session.recordedDesign, now, id);
  }

  #wordsOf(layer: TextLayer, assets: Readonly<Record<string, DesignAsset>>): EngineText {
    const words = resolveWords(layer, assets);
    const key = this.#parts.library.engineKey(assets[layer.font]);
    // What does not change the room is left out, so that a scrub of a colour measures nothing.
    return { ...words, font: key ?? words.font, fontSize: 1, color: BLACK, outline: thickness(words.outline) };
  }

  async #measure(words: EngineText): Promise<TextMeasure> {
    const key = keyOf(words);
    const known = this.#measured.get(key);
    if (known) return known;
    const room = await this.#parts.engine.measureText(words);
    if (this.#measured.size >= REMEMBERED) this.#measured.clear();
    this.#measured.set(key, room);
    return room;
  }

  #textureAspect(layer: TextLayer): number {
    const target = this.#parts.store.state.targets.get(materialsOf(layer)[0] ?? 0);
    return target ? target.width / target.height : 1;
  }
}

const BLACK = [0, 0, 0, 1] as const;
/** A place to measure at. */
const NOWHERE: Projector = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] };

/** Of the model's width: further out, round forms turn away. */
const FITTING_SHARE = 0.6;
/** Made smaller by so much at a time, and no further than that, until no side lies beyond the edge. */
const FITTING_STEP = 0.95;
const LEAST_FITTING = 0.1;
/** Then once more, as round forms turn away before they end. */
const FROM_EDGE = 0.92;
/** Characters of a name that is made of words. */
const MOST_IN_TITLE = 60;
/** More would be no list any more. */
const MOST_LISTED = 20;
const listed = (characters: readonly string[]): string => characters.slice(0, MOST_LISTED).join(" ");

/** Those fields of a layer that a patch changes. */
function picked(layer: TextLayer, patch: TextFieldsPatch): TextFieldsPatch {
  return Object.fromEntries(Object.keys(patch).map((name) => [name, layer[name as keyof TextFieldsPatch]]));
}

const isEmpty = (patch: TextPatch): boolean => Object.keys(patch).length === 0;

/** What a text says first, as long as a row of the layer list shows. */
const titleOf = (text: string): string => cutText(/\S.*/.exec(text)?.[0].trimEnd() ?? "", MOST_IN_TITLE);

/** As a field takes them, without what is blank around them. */
const pastedWords = (pasted: string): string => {
  const lines = pasted.split(/\r\n?|\n/).map((line) => line.trimEnd());
  return cutText(lines.join("\n").trim(), DESIGN_LIMITS.textLength);
};

const keyOf = (words: EngineText): string => JSON.stringify(words);
const thickness = (outline: EngineText["outline"]): EngineText["outline"] =>
  outline && { width: outline.width, color: BLACK };

/** A font that comes with Texelcast, as a text takes it. */
export function shippedFont(id: ShippedFontId): { readonly name: string; readonly asset: DesignAsset } {
  return { name: id, asset: { type: "font/ttf", uri: shippedFontAddress(id) } };
}
