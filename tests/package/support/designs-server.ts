/** The server of docs/guides/server.md, as it stands, in a process of its own. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { freePort } from "../../../scripts/test/free-port.mjs";

export interface DesignsServer {
  readonly port: number;
  /** What it wrote to its log of faults. */
  readonly faults: () => string;
  readonly stop: () => Promise<void>;
}

/** @param folder of the shop, with the script, the package and mug.glb */
export async function startDesignsServer(folder: string): Promise<DesignsServer> {
  const port = await freePort();
  const env = { ...process.env, PORT: String(port) };
  const server = spawn(process.execPath, ["designs-server.mjs"], {
    cwd: folder,
    env,
    stdio: ["ignore", "pipe", "pipe"],
  });
  let faults = "";
  server.stderr.setEncoding("utf8").on("data", (text) => {
    faults += text;
  });
  const ended = once(server, "exit");
  await Promise.race([once(server.stdout, "data"), ended]);
  if (server.exitCode !== null) throw new Error(`the guide's server ended: ${faults}`);
  return {
    port,
    faults: () => faults,
    stop: async () => {
      server.kill();
      await ended;
    },
  };
}
