/** The price of a personalised product: one rule for the page that shows it and the server that charges it. */
import type { PriceRule } from "./shop-api.ts";

export interface PrintedAmount {
  /** Pictures and texts. */
  readonly decals: number;
  /** Printed surface, square centimetres. */
  readonly area: number;
}

/** Of one piece, in the currency's smallest unit. Begun square centimetres count as whole ones. */
export function unitPriceOf(rule: PriceRule, { decals, area }: PrintedAmount): number {
  return rule.base + rule.perDecal * decals + rule.perSquareCentimetre * Math.ceil(area);
}
