import { fileURLToPath } from "node:url";
import { defineConfig, normalizePath } from "vite";
import { filesByStarts } from "./scripts/site-files.ts";
import site from "./vite.config.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const PAGES = ["index", "product", "cart", "order", "editor"];

/** What the pages begin with, and what follows on a product's: the element, the shop, and its desk with the print zones. */
const STARTS = [
  ...["list", "product", "cart", "order"].map((name) => ({ name, modules: [`storefront/pages/${name}-page.ts`] })),
  { name: "editor", modules: ["embed/page.ts"] },
  { name: "element", modules: ["element/define.ts"] },
  { name: "shop", modules: ["element/shop/shop-mode.ts"] },
  { name: "desk", modules: ["element/shop/shop-bench.ts", "element/desk/prints.ts", "editor/document/zones.ts"] },
].map(({ name, modules }) => ({ name, modules: modules.map((path) => normalizePath(here(`./web/${path}`))) }));

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
      input: PAGES.map((page) => here(`./web/storefront/${page}.html`)),
    },
  },
});
