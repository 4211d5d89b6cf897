/**
 * The glue of three's Basis Universal transcoder as a module that browsers, bundlers and Node all load: the package has it as a plain
 * script, which Node takes for a module without exports, and a page's policy refuses what it makes of text.
 */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { CALLER, INVOKER, withPlaces } from "./embind-without-eval.mjs";
import { inRoot } from "./paths.mjs";

const SOURCE = "node_modules/three/examples/jsm/libs/basis/basis_transcoder.js";

/** What the script does at its end to be found. */
const EXPORTS = `if (typeof exports === 'object' && typeof module === 'object')
  module.exports = BASIS;
else if (typeof define === 'function' && define['amd'])
  define([], () => BASIS);`;

/** What is never so here: the WebAssembly is handed over in Node too, where a module has no `require`. */
const IN_NODE =
  'ENVIRONMENT_IS_NODE=typeof process=="object"&&typeof process.versions=="object"&&typeof process.versions.node=="string"';

const HEAD =
  "// Basis Universal transcoder, from three, without eval. Copyright 2019-2024 Binomial LLC. Apache License 2.0.\n";

/** Writes the module; web/engine/basis-transcoder.ts says what it has. */
export function writeBasisGlue() {
  const code = readFileSync(inRoot(SOURCE), "utf8");
  const plain = withPlaces("three's basis_transcoder.js", code, [
    ["newFunc(Function,args)(...closureArgs)", INVOKER],
    ["newFunc(Function,params)(...args)", CALLER],
    [IN_NODE, "ENVIRONMENT_IS_NODE=false"],
    ['if(ENVIRONMENT_IS_NODE){var fs=require("fs");', 'if(false){var fs=require("fs");'],
    [EXPORTS, "export default BASIS;"],
  ]);
  mkdirSync(inRoot("build/basis"), { recursive: true });
  writeFileSync(inRoot("build/basis/basis-transcoder.js"), HEAD + plain);
  writeFileSync(
    inRoot("build/basis/basis-transcoder.d.ts"),
    "declare const startBasis: unknown;\nexport default startBasis;\n",
  );
}
