/** A cart line as it arrives: what it must be to be kept, and to be printed later without asking anybody. */
import * as v from "valibot";
import type { TexelcastError } from "../../web/core/texelcast-error.ts";
import { type DesignProblem, designError, formatPath } from "../../web/editor/document/design-problem.ts";
import { type Design, materialsOf, parseDesign, walkLayers } from "../../web/editor/document/index.ts";
import { filledText, numberBetween, strict, text } from "../../web/editor/document/schema-parts.ts";
import { isShippedFontAddress } from "../../web/engine/font-address.ts";
import { type LineRequest, type Product, SHOP_LIMITS } from "../../web/storefront/api/shop-api.ts";
import { checkAsset } from "./asset-check.ts";
import { type AssetStore, isSha256 } from "./asset-store.ts";
import type { Catalogue } from "./catalogue.ts";
import { workOf } from "./design-work.ts";
import { notFound, shopError } from "./shop-error.ts";

const hash = v.pipe(
  v.string("must be a SHA-256"),
  v.check(isSha256, "must be a SHA-256: 64 digits of 0 to 9 and a to f"),
);
const whole = (least: number, most: number) => v.pipe(numberBetween(least, most), v.integer("must be a whole number"));
const KEY_LENGTH = 1000;
/**
 * SQLite ends a text at its first NUL, and what prints a name shows no other control character as it is; those that turn the
 * direction would turn what stands beside the name, too.
 */
const noControl = v.check(
  (name: string) => !/[\p{Cc}\u202a-\u202e\u2066-\u2069]/u.test(name),
  "must not hold control characters",
);
const seen = v.check((name: string) => /[^\p{C}\p{Z}]/u.test(name), "must hold something that is seen");

const lineRequest = strict({
  product: filledText(KEY_LENGTH),
  design: v.unknown(),
  assets: v.pipe(
    v.array(strict({ key: text(KEY_LENGTH), sha256: hash }), "must be a list"),
    v.maxLength(SHOP_LIMITS.assetsPerDesign, `must not name more than ${SHOP_LIMITS.assetsPerDesign} files`),
  ),
  approved: strict({ sha256: hash, width: whole(1, 16_384), height: whole(1, 16_384) }),
  snapshot: hash,
  unitPrice: whole(0, 1e9),
  quantity: whole(1, SHOP_LIMITS.quantity),
});

const orderRequest = strict({
  name: v.pipe(v.string("must be a string"), v.trim(), filledText(SHOP_LIMITS.nameLength), noControl, seen),
});
const quantityRequest = strict({ quantity: whole(1, SHOP_LIMITS.quantity) });

/** @throws TexelcastError "bad-request" */
export const readOrderRequest = (body: unknown) => read(orderRequest, body);
/** @throws TexelcastError "bad-request" */
export const readQuantityRequest = (body: unknown) => read(quantityRequest, body);

/** A line that can be kept. */
export interface CheckedLine extends Omit<LineRequest, "design" | "assets"> {
  /** Its assets' addresses are those of the stored files. */
  readonly design: Design;
  /** Pictures and texts. */
  readonly decals: number;
}

/** Where the server serves a stored file. */
export const addressOfFile = (sha256: string): string => `/api/files/${sha256}`;
/** The stored file that an address names; null for any other address. */
export function fileOfAddress(uri: string): string | null {
  const name = uri.startsWith("/api/files/") ? uri.slice("/api/files/".length) : "";
  return isSha256(name) ? name : null;
}

/**
 * Reads a request for a cart line.
 *
 * @throws TexelcastError "bad-request", "not-found" for a product or file that is not there, "too-large", "bad-design" for
 * a design that cannot be read, is for another material, or names files other than those it came with.
 */
export async function readLine(body: unknown, catalogue: Catalogue, store: AssetStore): Promise<CheckedLine> {
  const { assets, design: sent, ...request } = read(lineRequest, body);
  checkKeys(assets.map(({ key }) => key));
  const product = catalogue.products.get(request.product);
  if (product === undefined) throw notFound("product", request.product);
  const design = parseDesign(sent, "design");
  const decals = countDecals(design, product);
  checkWork(workOf(design, await catalogue.surfaceOf(product)));
  const files = new Map(assets.map(({ key, sha256 }) => [key, sha256]));
  const stored: Record<string, Design["assets"][string]> = {};
  for (const [key, asset] of Object.entries(design.assets)) {
    if (isShippedFontAddress(asset.uri)) {
      stored[key] = asset;
      continue;
    }
    const file = await fileOfAsset(asset.uri, files.get(key), key, store);
    const bytes = await store.read(file);
    await checkType(bytes, asset.type, key);
    stored[key] = { ...asset, uri: addressOfFile(file) };
  }
  if (!(await store.has(request.snapshot))) throw notFound("snapshot", request.snapshot);
  const snapshotType = await checkAsset(await store.read(request.snapshot), "snapshot");
  if (snapshotType !== "image/png") {
    throw shopError("bad-request", "snapshot: must be a PNG picture", { field: "snapshot", value: snapshotType });
  }
  return { ...request, design: { ...design, assets: stored }, decals };
}

/** Also refuses a design that paints what the product does not print. */
function countDecals(design: Design, product: Product): number {
  let decals = 0;
  for (const { layer, path, shown, inMask } of walkLayers(design)) {
    if (layer.type === "group" || layer.type === "paint") continue;
    if (materialsOf(layer).some((material) => material !== product.material)) {
      const message = `must be ${product.material}, the material that is printed on this product`;
      throw refusal([...path, "material"], message, layer.material);
    }
    if ((layer.type === "decal" || layer.type === "text") && shown && !inMask) decals += 1;
  }
  return decals;
}

/** @throws TexelcastError "too-large" for a design that would keep the press from everybody else. */
function checkWork(pictures: number): void {
  const most = SHOP_LIMITS.layersPerDesign;
  if (pictures <= most) return;
  const message = `the design is as much work as ${Math.ceil(pictures)} pictures, ${most} are the most`;
  throw shopError("too-large", message, {
    field: "design.layers",
    value: String(Math.ceil(pictures)),
    hint: "Use fewer pictures and texts, or paint less of it with large brushes.",
  });
}

/** @throws TexelcastError "bad-request": of two files of one key it cannot be known which is meant. */
function checkKeys(keys: readonly string[]): void {
  const second = keys.findIndex((key, index) => keys.indexOf(key) < index);
  if (second < 0) return;
  const field = `assets[${second}].key`;
  throw shopError("bad-request", `${field}: must not be named twice`, { field, value: keys[second] as string });
}

/**
 * The stored file that an asset's bytes lie in: the one that came with the design, the one of an earlier visit, or what is
 * inside a `data:` address. No other address is followed, whatever it says.
 */
async function fileOfAsset(uri: string, sent: string | undefined, key: string, store: AssetStore): Promise<string> {
  const field = ["assets", key, "uri"];
  if (/^data:/i.test(uri)) return store.put(await readDataAddress(uri, field));
  const file = sent ?? fileOfAddress(uri);
  if (file === null) throw refusal(field, "must name a file that came with the design", uri);
  if (!(await store.has(file))) throw notFound("file", file);
  return file;
}

/** Its bytes must be what the address says they are. */
async function readDataAddress(uri: string, field: readonly (string | number)[]): Promise<Uint8Array> {
  // Checked by its length before anything is decoded.
  if (uri.length > SHOP_LIMITS.jsonBytes) throw refusal(field, "must not be as long as this", uri.slice(0, 60));
  let said: string;
  let bytes: Uint8Array;
  try {
    const response = await fetch(uri);
    said = (response.headers.get("content-type") ?? "").split(";")[0]?.trim() ?? "";
    bytes = new Uint8Array(await response.arrayBuffer());
  } catch {
    throw refusal(field, "is not a valid data: address", uri.slice(0, 60));
  }
  const found = await checkAsset(bytes, formatPath(field));
  if (said !== found) throw refusal(field, `says it is ${said}, but its bytes are ${found}`, uri.slice(0, 60));
  return bytes;
}

async function checkType(bytes: Uint8Array, said: string, key: string): Promise<void> {
  const found = await checkAsset(bytes, key);
  if (found !== said) throw refusal(["assets", key, "type"], `must be ${found}, as that is what the file is`, said);
}

function refusal(path: readonly (string | number)[], message: string, value: unknown): TexelcastError {
  const problem: DesignProblem = { path, message, value };
  return designError("design", [problem]);
}

function read<const Schema extends v.GenericSchema>(schema: Schema, body: unknown): v.InferOutput<Schema> {
  const result = v.safeParse(schema, body, { abortEarly: true });
  if (result.success) return result.output;
  const [issue] = result.issues;
  const path = (issue.path ?? []).map((item) => item.key as string | number);
  const field = path.length === 0 ? "body" : formatPath(path);
  throw shopError("bad-request", `${field}: ${issue.message}`, {
    field,
    hint: "docs/storefront.md says what the server takes.",
  });
}
