/** The worker's entry: an engine of its own, spoken to by engine-client.ts. */
import { type ServerPort, serveEngine } from "./engine-server.ts";

serveEngine(globalThis as unknown as ServerPort);
