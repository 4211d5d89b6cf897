/** The built site, served for a browser. */
import { fileURLToPath } from "node:url";
import { type PluginOption, preview } from "vite";
import { freePort } from "../../scripts/test/free-port.mjs";

export interface BuiltSite {
  readonly address: string;
  close(): Promise<void>;
}

/** @param headers sent with every file */
export async function serveBuiltSite(
  headers: Readonly<Record<string, string>> = {},
  plugins: readonly PluginOption[] = [],
): Promise<BuiltSite> {
  const server = await preview({
    configFile: fileURLToPath(new URL("../../vite.config.ts", import.meta.url)),
    logLevel: "warn",
    plugins: [...plugins],
    preview: { port: await freePort(), strictPort: true, headers },
  });
  return { address: server.resolvedUrls?.local[0] ?? "", close: () => server.close() };
}
