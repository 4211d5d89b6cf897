/** Putting pictures and words on the product. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { LayerMaterials } from "../../editor/document/design.ts";
import { freeIdIn } from "../../editor/document/layer-tree.ts";
import { makeDecalLayer } from "../../editor/document/make-layer.ts";
import { fileStem } from "../../editor/files/download.ts";
import { addOnTop, withAsset } from "../../editor/state/design-edits.ts";
import { diagonalOf } from "../../editor/state/design-state.ts";
import { contentHash } from "../../editor/storage/content-hash.ts";
import { ToldError } from "../../editor/strings/told-error.ts";
import type { Projector } from "../../engine/engine-api.ts";
import type { DecalViewer, SurfaceHit } from "../../viewer/viewer-api.ts";
import type { Acceptance, CandidateAsset, DecalSource, PlaceOptions, TextOptions } from "../element-api.ts";
import { PLACING_WORDS } from "../words/placing-words.ts";
import type { Words } from "../words/words.ts";
import type { Desk } from "./desk.ts";
import { addressOf, fetchBytes, nameOf } from "./read-model.ts";
import { startingPlace } from "./zone-place.ts";

/** How long a shop may make up its mind, milliseconds: it may ask a service, or a person. As long as through an iframe. */
const PATIENCE = 120_000;
/** Of the model's diagonal: a new decal's longer side. */
const NEW_SHARE = 0.22;

export interface Place {
  readonly projector: Projector;
  readonly material: LayerMaterials;
  readonly backfaces: boolean;
}

/** Where something of that aspect (width by height) goes. Rejects with "bad-argument" where there is no surface for it. */
export async function placeFor(
  desk: Desk,
  viewer: DecalViewer,
  aspect: number,
  options: PlaceOptions,
  at: SurfaceHit | null,
): Promise<Place> {
  const { store } = desk;
  const { words } = desk.settings;
  const { position } = options;
  const { width: usual = NEW_SHARE * diagonalOf(store.state.model) * Math.min(1, aspect) } = options;
  if (!(usual > 0 && Number.isFinite(usual))) {
    throw badOption(words, "width", usual);
  }
  const isFree = at === null && position === undefined;
  const start = isFree ? await startingPlace(viewer, desk.zones?.zones ?? [], { aspect, usual }) : null;
  const width = options.width ?? start?.width ?? usual;
  const hit = at ?? start?.hit ?? (position === undefined ? null : viewer.surface.near(position));
  if (options.projector === undefined && hit === null) {
    const { message, hint } = { ...PLACING_WORDS[words.language].nowhere, ...words.own?.nowhere };
    throw new ToldError("bad-argument", message, { hint });
  }
  const projector = options.projector ?? viewer.projectorAt(hit as SurfaceHit, width, aspect);
  const backfaces = !options.projector && !!hit?.isBack;
  const material = options.material ?? desk.reach.at(projector, backfaces, hit?.material ?? desk.material);
  return { projector, material, backfaces };
}

/** What a page says of something new, if it says anything: customers do not, and need not load what looks at it. */
export async function checkedOptions(
  desk: Desk,
  kind: "decal" | "text",
  options: TextOptions | undefined,
): Promise<TextOptions> {
  if (options === undefined) return {};
  const { checkOptions } = await import("./check-options.ts");
  await checkOptions(desk, kind, options);
  return options;
}

/** What stands in an option, and what may. */
export function badOption({ errors }: Words, field: string, value: unknown, hint = ""): ToldError {
  return new ToldError("bad-argument", errors.badOption(field), { field, value: String(value), hint });
}

/** Puts a picture on the product: checked, cleaned, accepted by the shop. Gives the layer's id. */
export async function addPicture(
  desk: Desk,
  source: DecalSource,
  given?: PlaceOptions,
  at: SurfaceHit | null = null,
): Promise<string> {
  desk.checkRoom();
  const options = await checkedOptions(desk, "decal", given);
  const { name, bytes } = await fileOf(desk, source);
  const admitted = await admitPicture(desk, name, bytes);
  // Not before: the shop may ask for the design while it makes up its mind.
  return await desk.during(putPicture(desk, name, admitted, options, at));
}

async function putPicture(
  desk: Desk,
  name: string,
  bytes: Uint8Array,
  options: PlaceOptions,
  at: SurfaceHit | null,
): Promise<string> {
  const picture = await desk.library.add(name, bytes);
  try {
    const viewer = await desk.takeHands();
    const label = options.name ?? fileStem(name);
    const place = await placeFor(desk, viewer, picture.width / picture.height, options, at);
    // Somebody may have added another one meanwhile.
    desk.checkRoom();
    // What is typed meanwhile stays.
    desk.keepShown();
    const { design, key } = withAsset(desk.design, label, picture.asset);
    const layer = makeDecalLayer({ id: freeIdIn(design), name: label, asset: key, ...place });
    const { words } = desk.settings;
    desk.record(addOnTop(design, layer), words.steps.add);
    if (!isTyping(desk)) desk.select(layer.id);
    desk.hooks.announce(words.announce.added(label));
    return layer.id;
  } finally {
    desk.library.release([picture.asset]);
  }
}

/** Whether the keyboard is in a field of what is chosen, which would go from under it if something else were. */
function isTyping({ viewer }: Desk): boolean {
  const { activeElement } = viewer.element.getRootNode() as ShadowRoot;
  return !!activeElement?.matches("textarea, tc-number");
}

async function fileOf(desk: Desk, source: DecalSource): Promise<{ name: string; bytes: Uint8Array }> {
  const { words, limits } = desk.settings;
  if (source instanceof Uint8Array) return { name: "picture", bytes: source };
  if (source instanceof ArrayBuffer) return { name: "picture", bytes: new Uint8Array(source) };
  if (source instanceof Blob) {
    const name = source instanceof File ? source.name : "picture";
    // Of a file that is too large nothing is read beyond what tells so.
    return { name, bytes: new Uint8Array(await source.slice(0, limits.bytes + 1).arrayBuffer()) };
  }
  if (!source || !(typeof source === "string" || source instanceof URL)) {
    throw badOption(words, "source", typeof source, "Blob, URL, Uint8Array, …");
  }
  const url = addressOf(String(source), document.baseURI, words);
  return { name: pictureName(url), bytes: await fetchBytes(url, { words, signal: desk.signal, most: limits.bytes }) };
}

/** What a picture from an address is called; those of `data:` and `blob:` hold no name. */
export const pictureName = (url: URL): string => (/^(data|blob):/.test(url.protocol) ? "picture" : nameOf(url));

/** A picture's bytes without metadata: checked, and accepted by the shop. */
export async function admitPicture(desk: Desk, name: string, bytes: Uint8Array): Promise<Uint8Array> {
  const { checkUpload } = await import("../../engine/upload-check.ts");
  const checked = await checkUpload(name, bytes, desk.settings.limits);
  await askShop(desk, { name, ...checked, sha256: await contentHash(checked.bytes) });
  return checked.bytes;
}

/** Rejects with "refused" where the shop does not take an asset, or its hook fails or is silent; "disposed" where the desk is closed. */
export async function askShop({ settings, signal }: Desk, asset: CandidateAsset): Promise<void> {
  const { beforeAccept, words } = settings;
  if (beforeAccept === null) return;
  const refused = (reason: string | undefined, cause?: unknown): TexelcastError =>
    new ToldError("refused", reason || words.errors.refused(asset.name), {
      subject: asset.name,
      hint: words.errors.refusedHint,
      cause,
    });
  let answer: Acceptance;
  try {
    answer = await inTime(signal, (signal) => beforeAccept({ ...asset, bytes: asset.bytes.slice() }, { signal }));
  } catch (cause) {
    signal.throwIfAborted();
    throw refused(undefined, cause);
  }
  if (answer === true) return;
  if (typeof answer !== "object" || answer === null) throw refused(undefined);
  if (answer.accept !== true) throw refused(answer.reason);
}

/** What somebody answers, asked with a signal that is aborted when nobody waits for it any more: then it rejects with the reason. */
async function inTime<T>(end: AbortSignal, ask: (signal: AbortSignal) => T): Promise<Awaited<T>> {
  end.throwIfAborted();
  // (AbortSignal.any is younger than browsers that customers still have.)
  const patience = new AbortController();
  const { signal } = patience;
  const silence = new Promise<never>((_, reject) => {
    signal.addEventListener("abort", () => reject(signal.reason));
  });
  const stop = (): void =>
    patience.abort(
      end.reason ?? new TexelcastError("timeout", "“beforeAccept” did not answer.", { value: String(PATIENCE) }),
    );
  const timer = setTimeout(stop, PATIENCE);
  end.addEventListener("abort", stop);
  try {
    // One that throws at once is raced, too: alone, the silence would reject unheard.
    return await Promise.race([Promise.resolve(signal).then(ask), silence]);
  } finally {
    clearTimeout(timer);
    end.removeEventListener("abort", stop);
  }
}
