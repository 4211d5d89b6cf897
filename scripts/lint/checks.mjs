/** The format and lint checks, each by itself. */
import { readdirSync } from "node:fs";
import { CLANG_FORMAT_VERSION, findClangFormat } from "../bootstrap/build-tools.mjs";
import { inRoot, ROOT } from "../bootstrap/paths.mjs";
import { outputOf, runVisibly } from "../bootstrap/run.mjs";
import { layerFaults } from "./layers.mjs";

/**
 * @typedef {object} Check
 * @property {string} name
 * @property {(options: {write: boolean}) => Promise<"passed" | "failed" | "skipped">} run prints what it finds; with
 *   `write` it mends what it can
 */

/** @type {readonly Check[]} */
export const CHECKS = [
  {
    name: "biome: format and lint of TypeScript, JavaScript, JSON and CSS",
    run: ({ write }) =>
      verdict(nodeTool("@biomejs/biome/bin/biome", "check", "--error-on-warnings", ...(write ? ["--write"] : []), ".")),
  },
  { name: "clang-format: format of the C++ sources", run: clangFormat },
  { name: "tsc: types", run: () => verdict(nodeTool("typescript/bin/tsc", "--noEmit")) },
  { name: "rooms: no import goes upward", run: rooms },
];

/** @param {string} script in node_modules @param {...string} args */
function nodeTool(script, ...args) {
  return runVisibly(process.execPath, [inRoot("node_modules", script), ...args]);
}

/** @param {{write: boolean}} options */
async function clangFormat({ write }) {
  const program = findClangFormat();
  const version = program && /version (\d+)/.exec(outputOf(program, ["--version"]) ?? "")?.[1];
  if (!program || Number(version) !== CLANG_FORMAT_VERSION) {
    console.log(`clang-format ${CLANG_FORMAT_VERSION} is not installed (found: ${version ?? "none"}).`);
    return "skipped";
  }
  const files = ["wasm", "tests/native", "bench"].flatMap((folder) =>
    readdirSync(inRoot(folder), { recursive: true, encoding: "utf8" })
      .filter((file) => /\.(cpp|h)$/.test(file))
      .map((file) => `${folder}/${file}`),
  );
  return verdict(runVisibly(program, [...(write ? ["-i"] : ["--dry-run", "-Werror"]), ...files]));
}

async function rooms() {
  const faults = layerFaults(ROOT);
  for (const fault of faults) console.log(fault);
  return faults.length === 0 ? "passed" : "failed";
}

/** @param {Promise<number>} exitCode @returns {Promise<"passed" | "failed">} */
async function verdict(exitCode) {
  return (await exitCode) === 0 ? "passed" : "failed";
}
