/** From what the editor submits to a line in the cart: files first, each under its hash, then the line that names them. */
import type { SubmitDetail } from "../element/element-api.ts";
import type { Cart, CartLine, LineRequest } from "./api/shop-api.ts";
import { openCart } from "./my-cart.ts";
import { shopClient } from "./shop-client.ts";

export interface PersonalisedProduct extends Pick<SubmitDetail, "design" | "assets" | "texture"> {
  readonly product: string;
  /** PNG. */
  readonly snapshot: Blob;
  /** As the page shows it. */
  readonly unitPrice: number;
  readonly quantity: number;
}

/** @param line the cart's line that it takes the place of; null for a new one */
export async function putInCart(made: PersonalisedProduct, line: string | null): Promise<Cart> {
  const { sha256, width, height } = made.texture;
  const files = new Map(made.assets.map((asset) => [asset.sha256, asset.bytes]));
  for (const bytes of files.values()) await shopClient.putFile(bytes);
  const request: LineRequest = {
    product: made.product,
    design: made.design,
    assets: made.assets.map((asset) => ({ key: asset.key, sha256: asset.sha256 })),
    approved: { sha256, width, height },
    snapshot: await shopClient.putFile(new Uint8Array(await made.snapshot.arrayBuffer())),
    unitPrice: made.unitPrice,
    quantity: made.quantity,
  };
  const { id } = await openCart();
  const reply = line === null ? shopClient.addLine(id, request) : shopClient.replaceLine(id, line, request);
  return (await reply).cart;
}

/** A line's design with its files, as the editor's `design` property takes it. */
export async function designOf(line: CartLine): Promise<object> {
  const { assets } = line.design as { readonly assets: Readonly<Record<string, { readonly uri: string }>> };
  const addresses = new Set(Object.values(assets).map(({ uri }) => uri));
  const stored = [...addresses].filter((uri) => uri.startsWith("/api/files/"));
  const files = stored.map(async (name) => ({ name, bytes: await shopClient.file(name.slice(1)) }));
  return { design: line.design, assets: await Promise.all(files) };
}
