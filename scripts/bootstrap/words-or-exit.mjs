/** A script's words on the command line; what it does not know ends it with its usage, not with a trace of Node's. */
import { parseArgs } from "node:util";

/**
 * @template {import("node:util").ParseArgsConfig} Config
 * @param {Config} config
 * @param {string} usage one command a line
 */
export function wordsOrExit(config, usage) {
  if (process.argv.includes("--help")) {
    console.log(usage);
    process.exit(0);
  }
  try {
    return parseArgs(config);
  } catch (error) {
    return refuse(error instanceof Error ? error.message : String(error), usage);
  }
}

/**
 * Says what was wrong, and what is right; exit code 2.
 * @param {string} message @param {string} usage
 * @returns {never}
 */
export function refuse(message, usage) {
  console.error(`${message}\n\n${usage}`);
  process.exit(2);
}
