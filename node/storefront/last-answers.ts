/** A server that is ended answers first whom it works for. */
import type { FastifyInstance } from "fastify";

/** Less than what most that end servers give them, ten seconds. */
const PATIENCE_MS = 8000;

/**
 * Has `app.close()` wait for the answers that are on their way, and those who ask meanwhile answered as ever; then it closes their
 * connections. To be called before any route is added, of a server whose options have `return503OnClosing: false`.
 *
 * @param patience milliseconds, after which nobody is waited for
 */
export function giveLastAnswers(app: FastifyInstance, patience = PATIENCE_MS): void {
  let asked = 0;
  let allAnswered = (): void => {};
  app.addHook("onRequest", async (_request, { raw }) => {
    asked += 1;
    const answered = (): void => {
      raw.off("finish", answered).off("close", answered);
      asked -= 1;
      if (asked === 0) allAnswered();
    };
    // The latter alone where somebody has hung up.
    raw.on("finish", answered).on("close", answered);
  });
  app.addHook("preClose", async () => {
    if (asked === 0) return;
    let timer: ReturnType<typeof setTimeout> | undefined;
    await new Promise<void>((resolve) => {
      allAnswered = resolve;
      timer = setTimeout(resolve, patience);
    });
    clearTimeout(timer);
  });
}
