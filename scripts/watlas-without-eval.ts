/** watlas for pages whose Content-Security-Policy allows no `eval`, which its glue would ask for in two places. */
import type { Plugin } from "vite";
import { CALLER, INVOKER, withPlaces } from "./bootstrap/embind-without-eval.mjs";

/** The package's code without functions made of text. Throws where a place is not found. */
export const withoutEval = (code: string): string =>
  withPlaces("watlas", code, [
    ["new Function(...args,invokerFnBody)(...closureArgs)", INVOKER],
    ["new Function(...params,functionBody)(...args)", CALLER],
  ]);

/** For the page's build, and for its workers'. */
export const watlasWithoutEval = (): Plugin => ({
  name: "texelcast-watlas",
  transform: { filter: { id: /watlas[/\\]dist[/\\]watlas\.js/ }, handler: (code) => withoutEval(code) },
});
