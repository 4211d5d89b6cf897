/** The pages as the development server gives them: what each names is there. */
import { fileURLToPath } from "node:url";
import { createServer, type ViteDevServer } from "vite";
import { afterAll, beforeAll, expect, test } from "vitest";

let server: ViteDevServer;
let origin: string;
beforeAll(async () => {
  server = await createServer({
    configFile: fileURLToPath(new URL("../../vite.config.ts", import.meta.url)),
    server: { port: 0, strictPort: false, hmr: false, watch: null },
    optimizeDeps: { noDiscovery: true, include: [] },
    cacheDir: fileURLToPath(new URL("../../build/.vite-test", import.meta.url)),
    logLevel: "silent",
  });
  await server.listen();
  origin = server.resolvedUrls?.local[0] ?? "";
});
afterAll(() => server.close());

test.each(["index.html", "element.html", "embed.html"])("%s names only files that are served", async (page) => {
  const html = await (await fetch(new URL(page, origin))).text();
  const named = [...html.matchAll(/(?:src|href)="([^"]+)"/g)].map(
    ([, address]) => new URL(address ?? "", new URL(page, origin)),
  );
  expect(named.length).toBeGreaterThan(1);
  for (const address of named) {
    const { ok, headers } = await fetch(address);
    expect(ok, address.pathname).toBe(true);
    // What is not there is answered with the first page.
    expect(headers.get("content-type"), address.pathname).not.toContain("text/html");
  }
});
