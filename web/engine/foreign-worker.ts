/**
 * A page's worker whose script lies on another origin, a CDN's: a browser begins only scripts of the page's own origin, so one
 * of two words, made here, imports it. The other origin must allow that (CORS), and the page's policy `worker-src blob:`.
 */

/** Beside the built package's other scripts. */
const SCRIPT = "engine-worker.js";

/**
 * Whether this script is of another origin than its page. In webpack's bundles a script's address is that of the source at the time
 * of the build, a `file:`, which tells nothing of where it came from; the worker's own is right there.
 */
export const isForeign = (): boolean => {
  const { protocol, origin } = new URL(import.meta.url);
  return protocol !== "file:" && origin !== location.origin;
};

/** The engine's worker, whose script lies beside this one. */
export function foreignWorker(options: WorkerOptions): Worker {
  // The base is no bare `import.meta.url`, which bundlers would take for a file of theirs to copy.
  const { href } = new URL(SCRIPT, new URL(import.meta.url));
  const own = URL.createObjectURL(new Blob([`import ${JSON.stringify(href)}`], { type: "text/javascript" }));
  const worker = new Worker(own, options);
  worker.addEventListener("message", () => URL.revokeObjectURL(own), { once: true });
  return worker;
}
