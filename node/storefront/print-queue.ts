/**
 * Makes the print files of ordered lines, one after the other. What waits is in the database, so that a server that ends
 * goes on where it was.
 */
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { PrintFile } from "../../web/engine/print-report.ts";
import type { ShopFault } from "../../web/storefront/api/shop-api.ts";
import type { AssetStore } from "./asset-store.ts";
import type { ShopDatabase, StoredOrderLine } from "./shop-database.ts";

export type RenderLine = (line: StoredOrderLine) => Promise<PrintFile>;

export class PrintQueue {
  readonly #database: ShopDatabase;
  readonly #store: AssetStore;
  readonly #render: RenderLine;
  #work: Promise<void> | null = null;
  #ended = false;

  constructor(database: ShopDatabase, store: AssetStore, render: RenderLine) {
    this.#database = database;
    this.#store = store;
    this.#render = render;
  }

  /** Looks whether something waits. */
  wake(): void {
    if (this.#ended) return;
    this.#work ??= this.#printAll().finally(() => {
      this.#work = null;
    });
  }

  /** Resolves when nothing waits any more. */
  async idle(): Promise<void> {
    while (this.#work !== null) await this.#work;
  }

  /** The line that is being made is finished; the others wait for the next start. */
  async end(): Promise<void> {
    this.#ended = true;
    await this.#work;
  }

  async #printAll(): Promise<void> {
    for (let line = this.#next(); line !== null; line = this.#next()) await this.#print(line);
  }

  #next(): StoredOrderLine | null {
    return this.#ended ? null : this.#database.nextToPrint();
  }

  async #print(line: StoredOrderLine): Promise<void> {
    this.#database.setPrint(line.id, "rendering");
    try {
      const { bytes, width, height } = await this.#render(line);
      const sha256 = await this.#store.put(bytes);
      const printed = { sha256, width, height, bytes: bytes.length };
      if (sha256 === line.approved.sha256) this.#database.setPrint(line.id, "ready", { printed });
      else this.#database.setPrint(line.id, "held", { printed, fault: notApproved(line.approved.sha256) });
    } catch (thrown) {
      const error = TexelcastError.wrap(thrown, "server-fault", "the print file could not be made", {
        hint: "Nothing was printed. Ask the shop, with the order's number.",
      });
      this.#database.setPrint(line.id, "held", { fault: error.toJSON() });
    }
  }
}

const notApproved = (approved: string): ShopFault => ({
  code: "hash-mismatch",
  message: "the print file is not what was approved, so nothing is printed",
  field: "approved.sha256",
  value: approved,
  hint: "Personalise the product again, and approve it as it looks now.",
});
