/** The cart of this browser: its id is kept here, and what is in it at the server. */
import type { Cart } from "./api/shop-api.ts";
import { keepFor, keptFor } from "./kept.ts";
import { ShopError, shopClient } from "./shop-client.ts";
import { words } from "./words.ts";

const KEY = "handprint-cart";

/** The cart, or null where there was none yet. */
export async function findCart(): Promise<Cart | null> {
  const id = keptFor("visits", KEY);
  if (id === null) return null;
  try {
    return await shopClient.cart(id);
  } catch (error) {
    if (!(error instanceof ShopError) || error.fault.code !== "not-found") throw error;
    keepFor("visits", KEY, null);
    return null;
  }
}

export async function openCart(): Promise<Cart> {
  const found = await findCart();
  if (found !== null) return found;
  const made = await shopClient.makeCart();
  // The cart's page would not find it.
  if (!keepFor("visits", KEY, made.id)) {
    throw new ShopError({ code: "no-cart", message: words.noCart, hint: words.noCartHint });
  }
  return made;
}

export const piecesIn = (cart: Cart | null): number =>
  cart?.lines.reduce((sum, { quantity }) => sum + quantity, 0) ?? 0;
