/** The engine at work for the shop: print files, and what of a product is printed. The page's own bytes and numbers. */
import type { PrintFile, PrintReport } from "../../web/engine/print-report.ts";
import type { Product } from "../../web/storefront/api/shop-api.ts";
import { type AssetReader, checkPrint, renderPrint } from "../print.ts";
import type { AssetStore } from "./asset-store.ts";
import type { Catalogue } from "./catalogue.ts";
import { fileOfAddress } from "./line-intake.ts";

export class Press {
  readonly #catalogue: Catalogue;
  readonly #readAsset: AssetReader;
  #last: Promise<unknown> = Promise.resolve();

  constructor(catalogue: Catalogue, store: AssetStore) {
    this.#catalogue = catalogue;
    this.#readAsset = async (uri) => {
      const file = fileOfAddress(uri);
      return file === null ? null : store.read(file);
    };
  }

  /**
   * The print file of a design as a cart keeps it: its assets' addresses are those of stored files. Throws as
   * `renderPrint` does.
   */
  print(product: Product, design: unknown): Promise<PrintFile> {
    return this.#inTurn(async () =>
      renderPrint({ ...(await this.#subject(product, design)), material: product.material }),
    );
  }

  /** What becomes of each layer on the product. Throws as `checkPrint` does. */
  measure(product: Product, design: unknown): Promise<PrintReport> {
    return this.#inTurn(async () => checkPrint(await this.#subject(product, design)));
  }

  async #subject(product: Product, design: unknown) {
    const [model, zones] = [await this.#catalogue.modelOf(product), await this.#catalogue.zonesOf(product)];
    return { model, zones, design, assets: this.#readAsset };
  }

  /** One after the other: each takes a core and some hundred megabytes. */
  #inTurn<Result>(work: () => Promise<Result>): Promise<Result> {
    const done = this.#last.then(work, work);
    this.#last = done.catch(() => undefined);
    return done;
  }
}
