/** The worker's half of the protocol: an EngineHost behind a message port. */
import { TexelcastError } from "../core/texelcast-error.ts";
import { EngineHost, type EngineHostOptions } from "./engine-host.ts";
import type { Call, ClientMessage, WorkerMessage } from "./engine-protocol.ts";
import { callLater } from "./event-loop.ts";
import { LayerReceiver } from "./sent-layers.ts";

/** What a worker's global scope and a MessagePort have in common. */
export interface ServerPort {
  postMessage(message: WorkerMessage, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<ClientMessage>) => void) | null;
}

/** Serves one engine on the port until the thread ends. */
export function serveEngine(port: ServerPort): void {
  let host: EngineHost | null = null;
  const receiver = new LayerReceiver();
  const cancels = new Map<number, AbortController>();
  const send = (message: WorkerMessage, transfer: Transferable[] = []): void => port.postMessage(message, transfer);

  const start = (options: EngineHostOptions): EngineHost => {
    const started = new EngineHost(options);
    started.onUpdate((update) => send({ type: "update", update }, [update.bytes.buffer as ArrayBuffer]));
    started.onError((error) => {
      send({ type: "error", error: TexelcastError.wrap(error, "internal", error.message).toJSON() });
    });
    return started;
  };

  const answer = async (engine: EngineHost, id: number, call: Call): Promise<void> => {
    const cancel = new AbortController();
    cancels.set(id, cancel);
    try {
      const onProgress = (share: number): void => send({ type: "progress", id, share });
      const value = await runCall(engine, call, onProgress, cancel.signal);
      send({ type: "result", id, value }, transferablesOf(value));
    } catch (thrown) {
      const error = TexelcastError.wrap(thrown, "internal", `The engine failed: ${String(thrown)}`);
      send({ type: "failure", id, error: error.toJSON() });
    } finally {
      cancels.delete(id);
    }
  };

  /** Once the newest layers are drawn, however many turns that takes. */
  const tellDrawn = (engine: EngineHost): void => {
    if (engine.drawingSoon) callLater(() => tellDrawn(engine));
    else send({ type: "drawn" });
  };

  port.onmessage = ({ data }) => {
    host ??= start(data.type === "start" ? data : {});
    switch (data.type) {
      case "start":
        break;
      case "ping":
        send({ type: "pong" });
        break;
      case "call":
        void answer(host, data.id, data.call);
        break;
      case "cancel":
        cancels.get(data.id)?.abort();
        break;
      case "expect":
        host.expect(data.change);
        break;
      case "layers":
      case "unreadable":
        host.setLayers(data.type === "layers" ? receiver.unpack(data.layers) : data.layers, data.revision);
        tellDrawn(host);
        break;
    }
  };
}

function runCall(
  engine: EngineHost,
  call: Call,
  onProgress: (share: number) => void,
  signal: AbortSignal,
): Promise<unknown> {
  // What a message brought is nobody else's.
  if (call.name === "loadModel") return engine.loadModel(call.args[0], true);
  if (call.name === "openTarget") return engine.openTarget(call.args[0], onProgress, signal);
  if (call.name === "exportPrint") return engine.exportPrint(call.args[0], onProgress, signal);
  // Name and arguments belong together by the type of Call; TypeScript cannot see it across the union.
  const method = engine[call.name] as (...args: readonly unknown[]) => Promise<unknown>;
  return method.apply(engine, call.args);
}

/** The large arrays of a result. The host keeps none of them: each is a copy made for the caller. */
function transferablesOf(value: unknown): Transferable[] {
  if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
  if (typeof value !== "object" || value === null) return [];
  return Object.values(value).flatMap((member) => (ArrayBuffer.isView(member) ? [member.buffer as ArrayBuffer] : []));
}
