/** `npm start`: sets up, then serves the page for development. */
import { inRoot } from "./bootstrap/paths.mjs";
import { refuse, wordsOrExit } from "./bootstrap/words-or-exit.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";

const USAGE = "npm start -- [--port 5173] [--host localhost] [--open]";
const { values } = wordsOrExit(
  { options: { port: { type: "string" }, host: { type: "string" }, open: { type: "boolean" } } },
  USAGE,
);
if (values.port !== undefined && !(/^\d+$/.test(values.port) && Number(values.port) <= 65_535)) {
  refuse(`--port: "${values.port}" is no port, which is a whole number up to 65535.`, USAGE);
}
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
