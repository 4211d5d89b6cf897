import { fileURLToPath } from "node:url";
import { type BuildEnvironmentOptions, defineConfig, normalizePath, type Plugin } from "vite";
import { entryInOneFile, filesByStarts } from "./scripts/site-files.ts";
import { sitePolicy } from "./scripts/site-policy.ts";
import { watlasWithoutEval } from "./scripts/watlas-without-eval.ts";
import { parseUrl } from "./web/core/parse-url.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The editor, the element on a page of its own, and the page for iframes. */
const PAGES = [here("./web/app/index.html"), here("./web/app/element.html"), here("./web/app/embed.html")];

const module = (path: string) => normalizePath(here(path));

/** What they begin with, and what follows: the editor takes in its demo's pictures, the element becomes a shop or an editor, and is touched. */
const STARTS = [
  { name: "editor", modules: [module("./web/app/main.ts"), module("./web/editor/state/asset-adoption.ts")] },
  { name: "element", modules: [module("./web/app/element-page.ts")] },
  { name: "embed", modules: [module("./web/app/embed-page.ts")] },
  { name: "full", modules: [module("./web/element/full/full-mode.ts")] },
  { name: "shop", modules: [module("./web/element/shop/shop-mode.ts")] },
  {
    name: "touch",
    modules: ["shop/shop-bench", "shop/shop-tools", "desk/prints"].map((path) => module(`./web/element/${path}.ts`)),
  },
];
/**
 * The shops that may frame embed.html: those of TEXELCAST_SHOPS, exact origins with spaces between, and without it none. The
 * development server lets any, as it is one's own.
 */
const texelcastShops = (): Plugin => ({
  name: "texelcast-shops",
  transformIndexHtml(html, { server }) {
    const listed = server === undefined ? (process.env.TEXELCAST_SHOPS ?? "").split(/\s+/).filter(Boolean) : ["*"];
    const wrong = listed.find((shop) => shop !== "*" && parseUrl(shop)?.origin !== shop);
    if (wrong !== undefined) {
      throw new Error(`TEXELCAST_SHOPS: "${wrong}" is no exact origin. Write it as "https://shop.example".`);
    }
    return html.replace('name="texelcast-shops" content=""', `name="texelcast-shops" content="${listed.join(" ")}"`);
  },
});

/** With what shows its first pictures upright and in sRGB, but for the part that is asked for by name. */
const engineInOneFile = (): Plugin => {
  const more = ["./web/engine/color-mention.ts", "./web/engine/orient-pixels.ts"];
  return entryInOneFile(module("./web/engine/engine-worker.ts"), ...more.map(module));
};

type LogHandler = NonNullable<NonNullable<BuildEnvironmentOptions["rolldownOptions"]>["onLog"]>;

/** glTF-Transform and Draco carry a branch for Node, which the page never takes: no news. */
const withoutNodeBranches: LogHandler = (level, log, handle) => {
  if (!log.message.includes("externalized for browser compatibility")) handle(level, log);
};

export default defineConfig({
  root: here("./web/app"),
  // Relative, so that the built site works in any folder of any host.
  base: "./",
  plugins: [texelcastShops(), sitePolicy(), filesByStarts(STARTS)],
  publicDir: here("./build/public"),
  cacheDir: here("./build/.vite"),
  server: {
    host: "localhost",
    port: 5173,
    strictPort: false,
    fs: { allow: [here(".")] },
    watch: { ignored: ["**/build/**"] },
  },
  preview: { host: "localhost", port: 4173 },
  worker: {
    format: "es",
    plugins: () => [watlasWithoutEval(), engineInOneFile()],
    rolldownOptions: { onLog: withoutNodeBranches },
  },
  optimizeDeps: {
    // The worker's packages are found with the page's, not when it first runs, which would load the page again.
    entries: [...PAGES, here("./web/engine/engine-worker.ts")],
    // They find their .wasm beside themselves, which pre-bundling would move.
    exclude: ["@jsquash/png", "@jsquash/jpeg", "@jsquash/webp", "@jsquash/avif", "watlas"],
  },
  build: {
    outDir: here("./build/site"),
    emptyOutDir: true,
    target: "es2022",
    // The module and the codecs stay files of their own, so that they are compiled while they stream in.
    assetsInlineLimit: (file) => (file.endsWith(".wasm") ? false : undefined),
    // three.js is the most of it.
    chunkSizeWarningLimit: 1200,
    rolldownOptions: { input: PAGES, onLog: withoutNodeBranches },
  },
});
