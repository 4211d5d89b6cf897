/**
 * A page's worker whose script lies on another origin, a CDN's: a browser begins only scripts of the page's own origin, so one
 * of two words, made here, imports it. The other origin must allow that (CORS), and the page's policy `worker-src blob:`.
 */

/** Beside the built package's other scripts. Not a literal in the address, as bundlers would take it for a file of theirs. */
const SCRIPT = "engine-worker.js";

/** Whether this script is of another origin than its page. */
export const isForeign = (): boolean => new URL(import.meta.url).origin !== location.origin;

/** The engine's worker, whose script lies beside this one. */
export function foreignWorker(options: WorkerOptions): Worker {
  const { href } = new URL(SCRIPT, import.meta.url);
  const own = URL.createObjectURL(new Blob([`import ${JSON.stringify(href)}`], { type: "text/javascript" }));
  const worker = new Worker(own, options);
  worker.addEventListener("message", () => URL.revokeObjectURL(own), { once: true });
  return worker;
}
