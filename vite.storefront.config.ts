import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import site from "./vite.config.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const PAGES = ["index", "product", "cart", "order", "editor"];

/** The example shop's pages, as its order server serves them (docs/storefront.md). */
export default defineConfig({
  ...site,
  // The order server writes the shop's origin into the editor's page.
  plugins: [],
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
