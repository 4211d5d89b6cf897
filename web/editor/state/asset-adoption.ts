/** The files of a design that was read from a file: fetched from where it lies, and taken in. */
import { parseUrl } from "../../core/parse-url.ts";
import { TexelcastError } from "../../core/texelcast-error.ts";
import { findCompanion } from "../../engine/companion-files.ts";
import { isShippedFontAddress } from "../../engine/font-address.ts";
import { decodeDataUri } from "../document/data-uri.ts";
import type { Design, DesignAsset } from "../document/design.ts";
import { fetchWhole } from "../files/fetch-whole.ts";
import { bytesOf } from "../files/file-bytes.ts";
import type { AssetLibrary, DesignPlace } from "./asset-library.ts";

/** On a slow line each would wait for the answer to the one before it; all at once would hold their bytes twice. */
const READ_AHEAD = 6;

/** `AssetLibrary.adopt`. They are fetched side by side, and taken in one after the other, in their order. */
export async function adoptAssets(library: AssetLibrary, design: Design, place: DesignPlace): Promise<Design> {
  const assets: Record<string, DesignAsset> = {};
  const entries = Object.entries(design.assets);
  const reads: Promise<Uint8Array | null>[] = [];
  /** Null for what is there. */
  const read = async (key: string, asset: DesignAsset): Promise<Uint8Array | null> => {
    if (!isShippedFontAddress(asset.uri) && !library.claim(asset))
      return readAsset(asset.uri, `assets.${key}.uri`, place);
    assets[key] = asset;
    return null;
  };
  try {
    for (const [index, [key, asset]] of entries.entries()) {
      for (const each of entries.slice(reads.length, index + READ_AHEAD)) {
        const ahead = read(...each);
        // Of several that fail, the first is told.
        ahead.catch(() => undefined);
        reads.push(ahead);
      }
      const bytes = await reads[index];
      if (!bytes) continue;
      const name = asset.uri.startsWith("data:") ? key : asset.uri;
      const kept = asset.type.startsWith("font/") ? await library.addFont(name, bytes) : await library.add(name, bytes);
      assets[key] = kept.asset;
    }
  } catch (thrown) {
    library.release(Object.values(assets));
    throw thrown;
  }
  return { ...design, assets };
}

async function readAsset(uri: string, field: string, { path, files, baseUrl, read }: DesignPlace): Promise<Uint8Array> {
  if (uri.startsWith("data:")) return decodeDataUri(uri, field);
  const inside = read?.(uri);
  if (inside) return inside;
  const companion = files && !uri.includes(":") ? findCompanion(uri, path, files) : undefined;
  if (companion) return bytesOf(companion.file);
  const address = parseUrl(uri, baseUrl);
  const allowed = address && (uri.startsWith("https:") || (baseUrl !== undefined && !uri.includes(":")));
  if (!allowed) {
    throw new TexelcastError("missing-file", `The design names the file ${uri}, which is not part of it.`, {
      subject: path,
      field,
      value: uri,
      hint: "Open the design together with its files: choose or drop all of them at once.",
    });
  }
  const bytes = await fetchWhole(address);
  if (!bytes) {
    const details = { subject: path, field, value: uri, reason: "not-loaded" };
    throw new TexelcastError("missing-file", `${uri} could not be fetched.`, details);
  }
  return bytes;
}
