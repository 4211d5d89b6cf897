/**
 * `npm start`: sets up, then serves the page for development.
 *   npm start -- [--port 5173] [--host localhost] [--open]
 */
import { parseArgs } from "node:util";
import { inRoot } from "./bootstrap/paths.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";

const { values } = parseArgs({
  options: { port: { type: "string" }, host: { type: "string" }, open: { type: "boolean" } },
});
await bootstrapOrExit("start");
const { createServer } = await import("vite");
const server = await createServer({
  configFile: inRoot("vite.config.ts"),
  server: {
    ...(values.port ? { port: Number(values.port) } : {}),
    ...(values.host ? { host: values.host } : {}),
    open: values.open ?? false,
  },
});
await server.listen();
server.printUrls();
server.bindCLIShortcuts({ print: true });
