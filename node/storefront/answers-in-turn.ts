/** What is asked in one go on a connection (HTTP pipelining) is answered in its turn. */
import type { Socket } from "node:net";
import type { FastifyInstance } from "fastify";

/** Browsers and proxies ask nothing more before they have their answer. */
const MOST_WAITING = 100;

interface Line {
  /** Resolves when the newest is answered, or nobody hears it any more. */
  last: Promise<void>;
  waiting: number;
}

/**
 * Has the server begin with no answer before its turn. Node tells only whose turn it is that the connection is gone: what was opened
 * for the others, as files, would stay open for good. To be called after `giveLastAnswers`, and before any route is added.
 */
export function answerInTurn(app: FastifyInstance): void {
  const lines = new WeakMap<Socket, Line>();
  app.addHook("onRequest", async ({ raw: { socket } }, reply) => {
    const { raw } = reply;
    const line = lines.get(socket) ?? { last: Promise.resolve(), waiting: 0 };
    lines.set(socket, line);
    const before = line.last;
    line.waiting += 1;
    line.last = new Promise((resolve) => {
      const answered = (): void => {
        raw.off("finish", answered).off("close", answered);
        line.waiting -= 1;
        resolve();
      };
      raw.on("finish", answered).on("close", answered);
    });
    if (line.waiting === 1) return;
    if (line.waiting > MOST_WAITING) socket.destroy();
    await before;
    if (raw.socket !== null && !socket.destroyed) return;
    reply.hijack();
    // As Node does for whose turn it is: nobody waits for it any more.
    raw.emit("close");
  });
}
