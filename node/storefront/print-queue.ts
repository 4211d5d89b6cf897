/**
 * Makes the print files of ordered lines, one after the other. What waits is in the database, so that a server that ends
 * goes on where it was.
 */
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { PrintFile } from "../../web/engine/print-report.ts";
import type { ShopFault } from "../../web/storefront/api/shop-api.ts";
import { type AssetStore, sha256Of } from "./asset-store.ts";
import type { ShopDatabase, StoredOrderLine } from "./shop-database.ts";

/** What became of a line: what is printed of it, or why it is not. */
type Outcome = Pick<StoredOrderLine, "status"> & Partial<Pick<StoredOrderLine, "printed" | "fault">>;

export type RenderLine = (line: StoredOrderLine) => Promise<PrintFile>;

export class PrintQueue {
  readonly #database: ShopDatabase;
  readonly #store: AssetStore;
  readonly #render: RenderLine;
  readonly #report: (error: unknown) => void;
  #work: Promise<void> | null = null;
  #ended = false;

  /** `report` is told of what nobody expected. */
  constructor(database: ShopDatabase, store: AssetStore, render: RenderLine, report: (error: unknown) => void) {
    this.#database = database;
    this.#store = store;
    this.#render = render;
    this.#report = report;
  }

  /** Looks whether something waits. Where the database fails, the lines wait until this is called again, and that is reported. */
  wake(): void {
    if (!this.#ended) this.#work ??= Promise.resolve().then(() => this.#printAll());
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
    try {
      this.#database.waitAgain();
      for (let line = this.#next(); line !== null; line = this.#next()) await this.#print(line);
    } catch (thrown) {
      // The database's own: to go on at once might ask it for the same line for ever.
      this.#report(thrown);
    } finally {
      this.#work = null;
    }
  }

  #next(): StoredOrderLine | null {
    return this.#ended ? null : this.#database.nextToPrint();
  }

  async #print(line: StoredOrderLine): Promise<void> {
    this.#database.setPrint(line.id, "rendering");
    const { status, ...told } = await this.#outcomeOf(line);
    this.#database.setPrint(line.id, status, told);
  }

  async #outcomeOf(line: StoredOrderLine): Promise<Outcome> {
    try {
      const { bytes, width, height } = await this.#render(line);
      const sha256 = sha256Of(bytes);
      const printed = { sha256, width, height, bytes: bytes.length };
      // What was not approved is not stored: the order tells its hash, and a stored file can be had by that.
      if (sha256 !== line.approved.sha256) {
        return { status: "held", printed, fault: notApproved(line.approved.sha256) };
      }
      await this.#store.put(bytes);
      return { status: "ready", printed };
    } catch (thrown) {
      if (!(thrown instanceof TexelcastError)) this.#report(thrown);
      const error = TexelcastError.wrap(thrown, "server-fault", "the print file could not be made", {
        hint: "Nothing was printed. Ask the shop, with the order's number.",
      });
      return { status: "held", fault: error.toJSON() };
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
