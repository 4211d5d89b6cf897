/** A design as a page gives it, made whole and safe: every field checked, every file fetched, looked at and taken in. */
import { parseUrl } from "../../core/parse-url.ts";
import { TexelcastError } from "../../core/texelcast-error.ts";
import { decodeDataUri } from "../../editor/document/data-uri.ts";
import type { Design, DesignAsset } from "../../editor/document/design.ts";
import type { AssetLibrary } from "../../editor/state/asset-library.ts";
import { isShippedFontAddress } from "../../engine/font-address.ts";
import type { UploadLimits } from "../../engine/upload-check.ts";
import type { DesignInput } from "../element-api.ts";
import { addressOf, type Fetching, fetchBytes, nameOf } from "./read-model.ts";

export interface DesignReading extends Fetching {
  readonly library: AssetLibrary;
  readonly limits: UploadLimits;
  /** Of the page. */
  readonly base: string;
}

/** JSON of a design without its pictures; those that stand in it are bounded by themselves. */
const MOST_BYTES = 256 * 2 ** 20;

/** Rejects with "bad-design", "missing-file", "outside-folder", and as uploads are refused. */
export async function readDesign(input: DesignInput, reading: DesignReading): Promise<Design> {
  const { data, name, base, files } = await dataOf(input, reading);
  const { parseDesign } = await import("../../editor/document/parse-design.ts");
  const { checkAsset, checkAssetAddress } = await import("../../editor/document/asset-check.ts");
  const design = parseDesign(data, name);
  const assets: Record<string, DesignAsset> = {};
  try {
    for (const [key, asset] of Object.entries(design.assets)) {
      if (isShippedFontAddress(asset.uri)) {
        assets[key] = asset;
        continue;
      }
      const bytes = files?.get(asset.uri) ?? (await bytesOf(key, asset, base, reading, checkAssetAddress));
      const clean = await checkAsset(key, asset, bytes, reading.limits);
      const taken = asset.type.startsWith("font/")
        ? await reading.library.addFont(key, clean)
        : await reading.library.add(key, clean);
      assets[key] = taken.asset;
    }
  } catch (thrown) {
    reading.library.release(Object.values(assets));
    throw thrown;
  }
  return { ...design, assets };
}

interface GivenDesign {
  readonly data: unknown;
  readonly name: string;
  /** Where relative addresses lead. */
  readonly base: string;
  readonly files?: ReadonlyMap<string, Uint8Array>;
}

async function dataOf(input: DesignInput, reading: DesignReading): Promise<GivenDesign> {
  const { words, base } = reading;
  if (input instanceof URL) return await dataOf(input.href, reading);
  if (typeof input === "string") {
    if (input.trimStart().startsWith("{")) return { data: input, name: "design", base };
    const url = addressOf(input, base, words);
    const bytes = await fetchBytes(url, { ...reading, most: MOST_BYTES });
    if (bytes.length > MOST_BYTES) throw new TexelcastError("too-large", `${url.href} is too large for a design.`);
    return { data: new TextDecoder().decode(bytes), name: nameOf(url), base: url.href };
  }
  if (typeof input !== "object") {
    throw new TexelcastError("bad-design", "The design is not plain data.", { field: "design", value: String(input) });
  }
  if ("design" in input && "assets" in input && Array.isArray(input.assets)) {
    const files = new Map<string, Uint8Array>();
    for (const { name, bytes } of input.assets) {
      if (typeof name === "string" && bytes instanceof Uint8Array) files.set(name, bytes);
    }
    return { data: plain(input.design), name: "design", base, files };
  }
  return { data: plain(input), name: "design", base };
}

/** A copy that nobody changes between the check and the use. */
function plain(data: unknown): unknown {
  try {
    return JSON.parse(JSON.stringify(data)) as unknown;
  } catch (cause) {
    throw new TexelcastError("bad-design", "The design is not plain data.", { cause });
  }
}

async function bytesOf(
  key: string,
  { uri }: DesignAsset,
  base: string,
  reading: DesignReading,
  checkAddress: (key: string, uri: string) => void,
): Promise<Uint8Array> {
  if (uri.startsWith("data:")) return decodeDataUri(uri, key);
  // A whole address is taken where it is the design's own server's: another one would learn who looks at the design.
  const own = parseUrl(uri)?.origin === new URL(base).origin;
  if (!own) checkAddress(key, uri);
  return await fetchBytes(addressOf(uri, base, reading.words), reading);
}
