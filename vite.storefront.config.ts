import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { filesByStarts, startsIn } from "./scripts/site-files.ts";
import site from "./vite.config.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const PAGES = ["index", "product", "cart", "order", "editor"];

/** What the pages begin with, and what follows on a product's: the element, the shop, and its desk with the print zones. */
const STARTS = startsIn({
  list: ["storefront/pages/list-page"],
  product: ["storefront/pages/product-page"],
  cart: ["storefront/pages/cart-page"],
  order: ["storefront/pages/order-page"],
  editor: ["embed/page"],
  element: ["element/define"],
  shop: ["element/shop/shop-mode"],
  desk: ["element/shop/shop-bench", "element/desk/prints", "editor/document/zones"],
});

/** The example shop's pages, as its order server serves them (docs/storefront.md). */
export default defineConfig({
  ...site,
  // The order server writes the shop's origin into the editor's page.
  plugins: [filesByStarts(STARTS)],
  root: here("./web/storefront"),
  cacheDir: here("./build/.vite-storefront"),
  build: {
    ...site.build,
    outDir: here("./build/storefront"),
    rolldownOptions: {
      ...site.build?.rolldownOptions,
      // What an element asks for when it needs it, a product's page begins with: that is no news.
      checks: { ...site.build?.rolldownOptions?.checks, ineffectiveDynamicImport: false },
      input: PAGES.map((page) => here(`./web/storefront/${page}.html`)),
    },
  },
});
