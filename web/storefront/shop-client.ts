/** The order server as the pages see it. */
import { sha256 } from "@noble/hashes/sha2.js";
import { bytesToHex } from "@noble/hashes/utils.js";
import type { Cart, EditorReply, LineRequest, Order, Product, ShopFault } from "./api/shop-api.ts";
import { words } from "./words.ts";

/** A refusal of the server's, or that it did not answer. */
export class ShopError extends Error {
  readonly fault: ShopFault;

  constructor(fault: ShopFault) {
    super(fault.message);
    this.name = "ShopError";
    this.fault = fault;
  }
}

export interface LineReply {
  readonly line: string;
  readonly cart: Cart;
}

const json = (body: unknown): RequestInit => ({
  body: JSON.stringify(body),
  headers: { "content-type": "application/json" },
});
const part = encodeURIComponent;

export const shopClient = {
  products: async (): Promise<readonly Product[]> =>
    (await ask<{ readonly products: readonly Product[] }>("GET", "products")).products,

  /** Address of the editor's page on its own origin. */
  editorPage: async (): Promise<string> => (await ask<EditorReply>("GET", "editor")).page,

  makeCart: (): Promise<Cart> => ask("POST", "carts"),
  cart: (cart: string): Promise<Cart> => ask("GET", `carts/${part(cart)}`),
  addLine: (cart: string, line: LineRequest): Promise<LineReply> =>
    ask("POST", `carts/${part(cart)}/lines`, json(line)),
  replaceLine: (cart: string, id: string, line: LineRequest): Promise<LineReply> =>
    ask("PUT", `carts/${part(cart)}/lines/${part(id)}`, json(line)),
  setQuantity: (cart: string, id: string, quantity: number): Promise<LineReply> =>
    ask("PATCH", `carts/${part(cart)}/lines/${part(id)}`, json({ quantity })),
  removeLine: (cart: string, id: string): Promise<LineReply> => ask("DELETE", `carts/${part(cart)}/lines/${part(id)}`),

  order: (cart: string, name: string): Promise<Order> => ask("POST", `carts/${part(cart)}/order`, json({ name })),
  orderOf: (order: string): Promise<Order> => ask("GET", `orders/${part(order)}`),

  /** Stores a file, and gives its name: the SHA-256 of its bytes. */
  async putFile(bytes: Uint8Array): Promise<string> {
    const name = bytesToHex(sha256(bytes));
    const headers = { "content-type": "application/octet-stream" };
    await ask("PUT", `files/${name}`, { body: bytes as Uint8Array<ArrayBuffer>, headers });
    return name;
  },

  async file(address: string): Promise<Uint8Array> {
    const response = await send("GET", address);
    return new Uint8Array(await response.arrayBuffer().catch(notReached));
  },
};

export const fileAddress = (hash: string): string => `api/files/${hash}`;
export const printFileAddress = (order: string, line: string): string =>
  `api/orders/${part(order)}/lines/${part(line)}/print.png`;

async function ask<Reply>(method: string, path: string, init: RequestInit = {}): Promise<Reply> {
  const response = await send(method, `api/${path}`, init);
  // One that breaks off, or a hotel's page in its place, is no JSON of ours.
  return (await response.json().catch(notReached)) as Reply;
}

async function send(method: string, address: string, init: RequestInit = {}): Promise<Response> {
  const response = await fetch(address, { ...init, method }).catch(notReached);
  if (response.ok) return response;
  throw new ShopError(await faultOf(response));
}

/** What a proxy between answers is no JSON of ours, or none at all. */
async function faultOf(response: Response): Promise<ShopFault> {
  const body = (await response.json().catch(() => null)) as { readonly error?: Partial<ShopFault> | string } | null;
  const fault = body?.error;
  return typeof fault === "object" && fault?.message ? (fault as ShopFault) : OFFLINE;
}

const OFFLINE: ShopFault = { code: "offline", message: words.offline, hint: words.offlineHint };

function notReached(): never {
  throw new ShopError(OFFLINE);
}
