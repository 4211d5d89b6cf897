/**
 * The pictures and fonts that designs use, by their `data:` URI: their bytes in the engine, their size, an address to show them.
 * Nothing is thrown away while the page lives, because an undo may ask for any of them again.
 */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { Engine } from "../../engine/engine-api.ts";
import { readFontHeader } from "../../engine/font-file.ts";
import { readPictureHeader } from "../../engine/picture-decoder.ts";
import { isShippedFontAddress } from "../../engine/shipped-fonts.ts";
import { isSvg } from "../../engine/svg-file.ts";
import type { Design, DesignAsset } from "../document/index.ts";
import { decodeDataUri, encodeDataUri } from "../files/data-uri.ts";
import { fileStem } from "../files/download.ts";
import type { CollectedFile } from "../files/file-collection.ts";
import { bytesOf, findCompanion } from "../files/file-intake.ts";
import { strings } from "../strings.ts";

export interface LibraryPicture {
  /** Key in the engine; the design's own keys may mean different pictures after another design is opened. */
  readonly engineKey: string;
  readonly asset: DesignAsset;
  readonly width: number;
  readonly height: number;
  /** For `<img>`; valid while the page lives. */
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

const TYPES = { png: "image/png", jpeg: "image/jpeg", webp: "image/webp" } as const;

const LIVE_KEY = "picture-live";

export class AssetLibrary {
  readonly #engine: Engine;
  readonly #pictures = new Map<string, LibraryPicture>();
  readonly #fonts = new Map<string, LibraryFont>();
  #count = 0;

  constructor(engine: Engine) {
    this.#engine = engine;
  }

  get(asset: DesignAsset | undefined): LibraryPicture | undefined {
    return asset && this.#pictures.get(asset.uri);
  }

  /** The user's own font; undefined for those that come with Texelcast. */
  font(asset: DesignAsset | undefined): LibraryFont | undefined {
    return asset && this.#fonts.get(asset.uri);
  }

  /** Under which the engine has a picture or a font of the user's. */
  engineKey(asset: DesignAsset | undefined): string | undefined {
    return (this.get(asset) ?? this.font(asset))?.engineKey;
  }

  /** Checks a font file and gives it to the engine. Rejects with a TexelcastError ("bad-font"). */
  async addFont(fileName: string, bytes: Uint8Array): Promise<LibraryFont> {
    const type = `font/${readFontHeader(bytes, fileName).format}` as const;
    const uri = encodeDataUri(type, bytes);
    const known = this.#fonts.get(uri);
    if (known) return known;
    this.#count += 1;
    const engineKey = `font-${this.#count}`;
    const { name } = await this.#engine.setFont(engineKey, { name: fileName, bytes });
    const font: LibraryFont = { engineKey, asset: { type, uri }, name: name || fileStem(fileName), bytes };
    this.#fonts.set(uri, font);
    return font;
  }

  /** Decodes a picture and gives it to the engine. Rejects with a TexelcastError ("bad-picture", "out-of-budget"). */
  async add(name: string, bytes: Uint8Array): Promise<LibraryPicture> {
    const type = isSvg(bytes) ? "image/svg+xml" : TYPES[readPictureHeader(bytes, name).format];
    const uri = encodeDataUri(type, bytes);
    const known = this.#pictures.get(uri);
    if (known) return known;
    this.#count += 1;
    const engineKey = `picture-${this.#count}`;
    const { width, height } = await this.#engine.setAsset(engineKey, { name, bytes });
    const url = URL.createObjectURL(new Blob([bytes as BlobPart], { type }));
    const picture: LibraryPicture = { engineKey, asset: { type, uri }, width, height, url };
    this.#pictures.set(uri, picture);
    return picture;
  }

  /**
   * Shows a picture that is still being changed: each of a slot takes the place of the one before, in the engine too, and none
   * is kept. Its address stands in designs that are only previewed; no file has it. PNG. Rejects as `add` does.
   */
  async setLive(bytes: Uint8Array, slot = "picture"): Promise<LibraryPicture> {
    const engineKey = `${LIVE_KEY}-${slot}`;
    const { width, height } = await this.#engine.setAsset(engineKey, { name: engineKey, bytes });
    const asset: DesignAsset = { type: "image/png", uri: `live:${slot}` };
    URL.revokeObjectURL(this.#pictures.get(asset.uri)?.url ?? "");
    const url = URL.createObjectURL(new Blob([bytes as BlobPart], { type: asset.type }));
    const picture: LibraryPicture = { engineKey, asset, width, height, url };
    this.#pictures.set(asset.uri, picture);
    return picture;
  }

  /**
   * Fetches every asset of a design that was read from a file, and gives the design with `data:` URIs in their place.
   * Rejects with a TexelcastError that names the asset.
   */
  async adopt(design: Design, place: DesignPlace): Promise<Design> {
    const assets: Record<string, DesignAsset> = {};
    for (const [key, asset] of Object.entries(design.assets)) {
      const field = `assets.${key}.uri`;
      if (isShippedFontAddress(asset.uri) || this.engineKey(asset) !== undefined) {
        assets[key] = asset;
        continue;
      }
      const bytes = await readAsset(asset.uri, field, place);
      const name = asset.uri.startsWith("data:") ? key : asset.uri;
      const kept = asset.type.startsWith("font/") ? await this.addFont(name, bytes) : await this.add(name, bytes);
      assets[key] = kept.asset;
    }
    return { ...design, assets };
  }
}

async function readAsset(uri: string, field: string, { path, files, baseUrl, read }: DesignPlace): Promise<Uint8Array> {
  if (uri.startsWith("data:")) return decodeDataUri(uri, field);
  const inside = read?.(uri);
  if (inside) return inside;
  const companion = files && !uri.includes(":") ? findCompanion(uri, path, files) : undefined;
  if (companion) return bytesOf(companion.file);
  const address = URL.canParse(uri, baseUrl) ? new URL(uri, baseUrl) : undefined;
  const allowed = address && (uri.startsWith("https:") || (baseUrl !== undefined && !uri.includes(":")));
  if (!allowed) {
    throw new TexelcastError("missing-file", strings.errors.missingAsset(uri), {
      subject: path,
      field,
      value: uri,
      hint: strings.errors.missingAssetHint,
    });
  }
  const response = await fetch(address).catch(() => undefined);
  if (!response?.ok) {
    throw new TexelcastError("missing-file", strings.errors.unreachable(uri), { subject: path, field, value: uri });
  }
  return bytesOf(await response.blob());
}
