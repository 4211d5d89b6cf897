import { fileURLToPath } from "node:url";
import { type BuildEnvironmentOptions, defineConfig, type Plugin } from "vite";
import { filesByStarts, startsIn, workerInOneFile } from "./scripts/site-files.ts";
import { sitePolicy } from "./scripts/site-policy.ts";
import { watlasWithoutEval } from "./scripts/watlas-without-eval.ts";
import { parseUrl } from "./web/core/parse-url.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The editor, the element on a page of its own, and the page for iframes. */
const PAGES = [here("./web/app/index.html"), here("./web/app/element.html"), here("./web/app/embed.html")];

/** What they begin with, and what follows: the editor takes in its demo's pictures, the element becomes a shop or an editor, and is touched. */
const STARTS = startsIn({
  editor: ["app/main", "editor/state/asset-adoption"],
  element: ["app/element-page"],
  embed: ["app/embed-page"],
  full: ["element/full/full-mode"],
  shop: ["element/shop/shop-mode"],
  touch: ["element/shop/shop-bench", "element/shop/shop-tools", "element/desk/prints"],
});

/** The engine's worker shows its first pictures upright and in sRGB. */
const WORKERS = startsIn({ engine: ["engine/engine-worker", "engine/color-mention", "engine/orient-pixels"] });

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

type LogHandler = NonNullable<NonNullable<BuildEnvironmentOptions["rolldownOptions"]>["onLog"]>;

/** How long each plugin took is no news to whoever builds the site. */
const checks = { bundlerTimings: false };

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
    plugins: () => [watlasWithoutEval(), workerInOneFile(WORKERS)],
    rolldownOptions: { onLog: withoutNodeBranches, checks },
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
    rolldownOptions: { input: PAGES, onLog: withoutNodeBranches, checks },
  },
});
