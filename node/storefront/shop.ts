/** What the routes of the example shop share. */
import type { AssetStore } from "./asset-store.ts";
import type { Catalogue } from "./catalogue.ts";
import type { Press } from "./press.ts";
import type { PrintQueue } from "./print-queue.ts";
import type { ShopDatabase } from "./shop-database.ts";

export interface Shop {
  readonly catalogue: Catalogue;
  readonly store: AssetStore;
  readonly database: ShopDatabase;
  readonly press: Press;
  readonly queue: PrintQueue;
  /** Of one address. */
  readonly linesPerMinute: number;
}
