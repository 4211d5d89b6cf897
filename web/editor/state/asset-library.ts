/**
 * The pictures and fonts that designs use, by their `data:` URI: their bytes in the engine, their size, an address to show them.
 * What no step of the history holds any more is thrown away; of what an undo may ask for, the engine keeps the newest, and
 * is given the others again from their URIs.
 */
import type { Engine } from "../../engine/engine-api.ts";
import { isSvg } from "../../engine/svg-start.ts";
import type { Design, DesignAsset } from "../document/design.ts";
import { fileStem } from "../files/download.ts";
import type { CollectedFile } from "../files/file-collection.ts";
import { MEBIBYTE } from "./megabytes.ts";

export interface LibraryPicture {
  /** Key in the engine; the design's own keys may mean different pictures after another design is opened. */
  readonly engineKey: string;
  readonly asset: DesignAsset;
  readonly width: number;
  readonly height: number;
  /** For `<img>`; valid while the design or a step of the history uses the picture. */
  readonly url: string;
}

/** Where a design's relative addresses lead. */
export interface DesignPlace {
  /** The design's own path among `files`, or its address on the web. */
  readonly path: string;
  readonly files?: readonly CollectedFile[];
  readonly baseUrl?: string;
  /** Bytes of an address inside the design's own archive. */
  readonly read?: (uri: string) => Uint8Array | undefined;
}

export interface LibraryFont {
  /** Key in the engine. */
  readonly engineKey: string;
  readonly asset: DesignAsset;
  /** As the file calls it, or the file's own name. */
  readonly name: string;
  readonly bytes: Uint8Array;
}

const LIVE_KEY = "picture-live";

/** Bytes that the engine may hold of pictures and fonts that only the history's steps use. */
const SPARE_BYTES = 64 * MEBIBYTE;
/** A decoded picture's pixel, with the coarser levels and what else the core keeps of it. */
const DECODED_PIXEL_BYTES = 15;

interface Kept {
  readonly held: LibraryPicture | LibraryFont;
  /** What it takes up outside the design, about. */
  readonly bytes: number;
  /** The engine has it. */
  given: boolean;
  /** A recorded design had it. Before that, it stays for those who are about to use it. */
  used: boolean;
  /** How many those are. */
  claims: number;
}

export class AssetLibrary {
  readonly #engine: Engine;
  /** By URI, those used last at the end. */
  readonly #kept = new Map<string, Kept>();
  readonly #returning = new Map<string, Promise<void>>();
  /** What is being taken in. */
  readonly #coming = new Map<string, Promise<void>>();
  #count = 0;

  constructor(engine: Engine) {
    this.#engine = engine;
  }

  get(asset: DesignAsset | undefined): LibraryPicture | undefined {
    const held = asset && this.#kept.get(asset.uri)?.held;
    return held && "url" in held ? held : undefined;
  }

  /** The user's own font; undefined for those that come with Texelcast. */
  font(asset: DesignAsset | undefined): LibraryFont | undefined {
    const held = asset && this.#kept.get(asset.uri)?.held;
    return held && "url" in held ? undefined : held;
  }

  /** Under which the engine has a picture or a font of the user's. */
  engineKey(asset: DesignAsset | undefined): string | undefined {
    return asset && this.#kept.get(asset.uri)?.held.engineKey;
  }

  /** Checks a font file and gives it to the engine, until it is released. Rejects with a TexelcastError ("bad-font"). */
  async addFont(fileName: string, bytes: Uint8Array): Promise<LibraryFont> {
    const { readFontHeader } = await import("../../engine/font-file.ts");
    const type = `font/${readFontHeader(bytes, fileName).format}` as const;
    const { encodeDataUri } = await import("../document/data-uri.ts");
    const uri = encodeDataUri(type, bytes);
    return await this.#take(uri, async (count) => {
      const engineKey = `font-${count}`;
      const { name } = await this.#engine.setFont(engineKey, { name: fileName, bytes });
      const held: LibraryFont = { engineKey, asset: { type, uri }, name: name || fileStem(fileName), bytes };
      return { held, bytes: 2 * bytes.length };
    });
  }

  /**
   * Decodes a picture and gives it to the engine, until it is released. Rejects with a TexelcastError ("bad-picture",
   * "out-of-budget").
   */
  async add(name: string, bytes: Uint8Array): Promise<LibraryPicture> {
    const { readPictureHeader } = await import("../../engine/picture-header.ts");
    const type = isSvg(bytes) ? "image/svg+xml" : (`image/${(await readPictureHeader(bytes, name)).format}` as const);
    const { encodeDataUri } = await import("../document/data-uri.ts");
    const uri = encodeDataUri(type, bytes);
    return await this.#take(uri, async (count) => {
      const engineKey = `picture-${count}`;
      const { width, height } = await this.#engine.setAsset(engineKey, { name, bytes });
      const url = URL.createObjectURL(new Blob([bytes as BlobPart], { type }));
      const held: LibraryPicture = { engineKey, asset: { type, uri }, width, height, url };
      const decoded = type === "image/svg+xml" ? 0 : width * height * DECODED_PIXEL_BYTES;
      return { held, bytes: decoded + 2 * bytes.length };
    });
  }

  /** Makes what an address stands for, once however many ask for it at a time. */
  async #take<Held extends Kept["held"]>(
    uri: string,
    make: (count: number) => Promise<Pick<Kept, "bytes"> & { readonly held: Held }>,
  ): Promise<Held> {
    while (!this.claim({ uri })) {
      let coming = this.#coming.get(uri);
      if (coming === undefined) {
        this.#count += 1;
        coming = make(this.#count)
          .then((made) => void this.#kept.set(uri, { ...made, given: true, used: false, claims: 0 }))
          .finally(() => this.#coming.delete(uri));
        this.#coming.set(uri, coming);
      }
      await coming;
    }
    const { held } = this.#kept.get(uri) as Kept;
    await this.#giveBack(uri);
    return held as Held;
  }

  /** As `add`, of what is there already; false where it is not. */
  claim({ uri }: Pick<DesignAsset, "uri">): boolean {
    const kept = this.#kept.get(uri);
    if (kept !== undefined) kept.claims += 1;
    return kept !== undefined;
  }

  /**
   * To be called once for each that was added, when it has been used, or will not be: what no recorded design has had by then,
   * and nobody else is about to use, goes.
   */
  release(assets: Iterable<DesignAsset>): void {
    for (const { uri } of assets) {
      const kept = this.#kept.get(uri);
      if (kept === undefined) continue;
      kept.claims = Math.max(0, kept.claims - 1);
      if (!kept.used && kept.claims === 0) this.#drop(uri, kept);
    }
  }

  #drop(uri: string, kept: Kept): void {
    this.#takeAway(kept);
    this.#kept.delete(uri);
    if ("url" in kept.held) URL.revokeObjectURL(kept.held.url);
  }

  #takeAway(kept: Kept): void {
    if (!kept.given) return;
    kept.given = false;
    // An engine that was ended, or that crashes over it, has nothing of it any more.
    this.#engine.removeAsset(kept.held.engineKey).catch(() => undefined);
  }

  /** Whether the engine lacks something that a design uses and that `giveBack` can give it. */
  lacks({ assets }: Design): boolean {
    return Object.values(assets).some(({ uri }) => uri.startsWith("data:") && this.#kept.get(uri)?.given !== true);
  }

  /** Gives the engine what it lacks of a design. Rejects as `add` and `addFont` do. */
  async giveBack({ assets }: Design): Promise<void> {
    const lacking = Object.entries(assets).filter(([, { uri }]) => uri.startsWith("data:"));
    await Promise.all(lacking.map(([key, asset]) => this.#giveBack(asset.uri, key, asset.type)));
  }

  async #giveBack(uri: string, name = "", type = ""): Promise<void> {
    const kept = this.#kept.get(uri);
    if (kept?.given) return;
    const returning = this.#returning.get(uri) ?? this.#giveAgain(uri, kept, name, type);
    this.#returning.set(uri, returning);
    await returning.finally(() => this.#returning.delete(uri));
  }

  async #giveAgain(uri: string, kept: Kept | undefined, name: string, type: string): Promise<void> {
    const { decodeDataUri } = await import("../document/data-uri.ts");
    const bytes = decodeDataUri(uri, name);
    if (kept === undefined) {
      const { asset } = await (type.startsWith("font/") ? this.addFont(name, bytes) : this.add(name, bytes));
      // For as long as a design shows it: nobody else waits for it.
      const added = this.#kept.get(asset.uri);
      if (added) added.claims -= 1;
      return;
    }
    const { held } = kept;
    const file = { name: name || held.engineKey, bytes };
    if ("url" in held) await this.#engine.setAsset(held.engineKey, file);
    else await this.#engine.setFont(held.engineKey, file);
    kept.given = true;
  }

  /**
   * Frees what is not needed any more.
   *
   * @param shown the designs that are looked at now, which keep all that they use
   * @param reachable all designs that an undo or redo could bring back
   */
  sweep(shown: readonly Design[], reachable: () => Iterable<Design>): void {
    const inUse = urisOf(shown);
    for (const uri of inUse) {
      const kept = this.#kept.get(uri);
      if (kept === undefined) continue;
      kept.used = true;
      this.#kept.delete(uri);
      this.#kept.set(uri, kept);
    }
    const idle = [...this.#kept].filter(([uri, { used, claims }]) => (used || claims === 0) && !inUse.has(uri));
    if (idle.length === 0) return;
    const wanted = urisOf(reachable());
    let spare = 0;
    for (const [uri, kept] of idle.reverse()) {
      const isWanted = wanted.has(uri);
      if (isWanted && kept.given) spare += kept.bytes;
      if (!isWanted) this.#drop(uri, kept);
      else if (kept.given && spare > SPARE_BYTES) {
        spare -= kept.bytes;
        this.#takeAway(kept);
      }
    }
  }

  /** Gives back the addresses of all pictures; the library is of no use then. The engine's own are the engine's. */
  dispose(): void {
    for (const { held } of this.#kept.values()) if ("url" in held) URL.revokeObjectURL(held.url);
    this.#kept.clear();
  }

  /**
   * Shows a picture that is still being changed: each of a slot takes the place of the one before, in the engine too, and none
   * is kept. Its address stands in designs that are only previewed; no file has it. PNG. Rejects as `add` does.
   */
  async setLive(bytes: Uint8Array, slot = "picture"): Promise<LibraryPicture> {
    const engineKey = `${LIVE_KEY}-${slot}`;
    const { width, height } = await this.#engine.setAsset(engineKey, { name: engineKey, bytes });
    const asset: DesignAsset = { type: "image/png", uri: `live:${slot}` };
    URL.revokeObjectURL(this.get(asset)?.url ?? "");
    const url = URL.createObjectURL(new Blob([bytes as BlobPart], { type: asset.type }));
    const picture: LibraryPicture = { engineKey, asset, width, height, url };
    this.#kept.set(asset.uri, { held: picture, bytes: 0, given: true, used: false, claims: 1 });
    return picture;
  }

  /**
   * Fetches every asset of a design that was read from a file, and gives the design with `data:` URIs in their place; all are
   * to be released as those that were added. Rejects with a TexelcastError that names the asset.
   */
  async adopt(design: Design, place: DesignPlace): Promise<Design> {
    const { adoptAssets } = await import("./asset-adoption.ts");
    return await adoptAssets(this, design, place);
  }
}

function urisOf(designs: Iterable<Design>): Set<string> {
  const uris = new Set<string>();
  for (const { assets } of designs) for (const { uri } of Object.values(assets)) uris.add(uri);
  return uris;
}
