/** The files of a design that was read from a file: fetched from where it lies, and taken in. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { isShippedFontAddress } from "../../engine/font-address.ts";
import type { Design, DesignAsset } from "../document/design.ts";
import { bytesOf, findCompanion } from "../files/companions.ts";
import { decodeDataUri } from "../files/data-uri.ts";
import type { AssetLibrary, DesignPlace } from "./asset-library.ts";

/** `AssetLibrary.adopt`. */
export async function adoptAssets(library: AssetLibrary, design: Design, place: DesignPlace): Promise<Design> {
  const assets: Record<string, DesignAsset> = {};
  try {
    for (const [key, asset] of Object.entries(design.assets)) {
      const field = `assets.${key}.uri`;
      if (isShippedFontAddress(asset.uri) || library.claim(asset)) {
        assets[key] = asset;
        continue;
      }
      const bytes = await readAsset(asset.uri, field, place);
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
  const address = URL.canParse(uri, baseUrl) ? new URL(uri, baseUrl) : undefined;
  const allowed = address && (uri.startsWith("https:") || (baseUrl !== undefined && !uri.includes(":")));
  if (!allowed) {
    throw new TexelcastError("missing-file", `The design names the picture ${uri}, which is not part of it.`, {
      subject: path,
      field,
      value: uri,
      hint: "Open the design together with its pictures: choose or drop all of them at once.",
    });
  }
  const response = await fetch(address).catch(() => undefined);
  if (!response?.ok) {
    throw new TexelcastError("missing-file", `${uri} could not be fetched.`, { subject: path, field, value: uri });
  }
  return bytesOf(await response.blob());
}
