/** A design on its way to a shop: files beside it, each under the hash of what is in it. */

import { decodeDataUri } from "../../editor/document/data-uri.ts";
import { ASSET_ENDINGS, type Design, type DesignAsset } from "../../editor/document/design.ts";
import { walkLayers } from "../../editor/document/layer-tree.ts";
import { contentHash } from "../../editor/storage/content-hash.ts";
import { isShippedFontAddress } from "../../engine/font-address.ts";
import type { DesignCounts, ExportedAsset, ExportedDesign } from "../element-api.ts";
import type { AtDesk } from "../mode.ts";

/** Hashes of files that were met before, by their addresses: they are asked for at each change. */
export class DesignExport {
  #names = new Map<string, { readonly name: string; readonly sha256: string }>();

  /** The design with its files' names in place of their bytes. */
  async named(design: Design): Promise<Design> {
    const assets: Record<string, DesignAsset> = {};
    const known = new Map<string, { readonly name: string; readonly sha256: string }>();
    for (const [key, asset] of Object.entries(design.assets)) {
      if (isShippedFontAddress(asset.uri)) {
        assets[key] = asset;
        continue;
      }
      const file = this.#names.get(asset.uri) ?? (await nameFile(key, asset));
      known.set(asset.uri, file);
      assets[key] = { type: asset.type, uri: file.name };
    }
    this.#names = known;
    return { ...design, assets };
  }

  async whole(design: Design): Promise<ExportedDesign> {
    const named = await this.named(design);
    const assets = Object.entries(design.assets).flatMap(([key, { type, uri }]): ExportedAsset[] => {
      const file = this.#names.get(uri);
      return file ? [{ key, type, ...file, bytes: decodeDataUri(uri, key) }] : [];
    });
    return { design: named, assets };
  }
}

/** The design as it is seen. */
export async function exportShown({ desk, idle }: AtDesk): Promise<ExportedDesign> {
  // A design can be kept also where it cannot be drawn.
  await idle().catch(() => undefined);
  return await new DesignExport().whole(desk.shown);
}

async function nameFile(key: string, { type, uri }: DesignAsset): Promise<{ name: string; sha256: string }> {
  const sha256 = await contentHash(decodeDataUri(uri, key));
  return { name: `assets/${sha256}.${ASSET_ENDINGS[type]}`, sha256 };
}

/** What a price may go by. */
export function countsOf(design: Design): DesignCounts {
  const counts = { decals: 0, texts: 0, layers: 0 };
  for (const { layer, shown } of walkLayers(design, { masks: false, strokes: false })) {
    if (!shown || layer.type === "group") continue;
    counts.layers += 1;
    if (layer.type === "decal") counts.decals += 1;
    if (layer.type === "text") counts.texts += 1;
  }
  return counts;
}
