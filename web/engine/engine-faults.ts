/** How the engine's client tells what happened to its worker. */
import { TexelcastError } from "../core/texelcast-error.ts";

/** One crash: the worker is replaced by itself. */
export function crashError(reason: string): TexelcastError {
  return new TexelcastError("engine-crashed", `The engine crashed: ${reason.replace(/\.$/, "")}.`, {
    hint: "It is started again by itself; if that fails, reload the page.",
  });
}

/** A crash that comes back with every worker: nothing more is drawn until there is something else to draw. */
export function haltError(crash: TexelcastError, times: number): TexelcastError {
  return new TexelcastError("engine-halted", `${crash.message} It did so ${times} times in a row.`, {
    hint: "Undo the last step, which may be the reason. Your work is kept.",
    cause: crash,
  });
}

/** Whoever called has called it off. */
export const cancelled = (): TexelcastError => new TexelcastError("cancelled", "The call was cancelled.");

/** What holds functions, or a framework's proxies. */
export const notSendable = (field: string, thrown: unknown): TexelcastError =>
  new TexelcastError("bad-argument", `“${field}” was given what cannot be sent: ${thrown}.`, { field });

/** Whatever is asked of an engine after `dispose`. */
export const disposed = (): TexelcastError => new TexelcastError("disposed", "The engine was ended.");

/** Whatever needs a model, before `loadModel`. */
export const noModel = (): TexelcastError => new TexelcastError("no-model", "No model is loaded yet.");

/** Whatever asks for the texels of a target whose layers could not be drawn: why they could not. */
export const notDrawn = (thrown: unknown): TexelcastError =>
  TexelcastError.wrap(thrown, "internal", "A texture could not be drawn.");

/** Whatever needs a material's target, before `openTarget`. */
export const notOpen = (material: number): TexelcastError =>
  new TexelcastError("bad-argument", `Material ${material} is not open for painting.`, {
    field: "material",
    value: String(material),
    hint: "Open it with openTarget first.",
    reason: "not-open",
  });
