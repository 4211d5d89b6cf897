/** The worker's entry: an engine of its own, spoken to by engine-client.ts. */
import { type ServerPort, serveEngine } from "./engine-server.ts";
import { holdLifeLock } from "./worker-watch.ts";

const port = globalThis as unknown as ServerPort;
serveEngine(port);
holdLifeLock((lock) => port.postMessage({ type: "alive", lock }, []));
