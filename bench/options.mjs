/**
 * The words behind `npm run bench --` and `npm run bench:browser --`. Node's built-ins alone and no TypeScript: the
 * scripts read them before they set up or build anything, so that a slip of the keyboard is told at once.
 */
import { parseArgs } from "node:util";

/** Texels along a side that the core takes at most (wasm/texelcast.h). */
const LARGEST_SIZE = 8192;
export const MESHES = /** @type {const} */ (["torus20k", "torus200k"]);
/** In the order in which they run. bench/README.md says what each is. */
export const WORKS = /** @type {const} */ ([
  "bake",
  "local1",
  "local10",
  "whole",
  "occluded",
  "stacked",
  "open",
  "memory",
]);
export const BROWSER_WORKS = /** @type {const} */ (["bake", "local1", "local10", "whole", "drag"]);

/** @typedef {(typeof MESHES)[number]} MeshName */
/** @typedef {(typeof WORKS)[number] | (typeof BROWSER_WORKS)[number]} WorkName */
/**
 * @typedef {object} BenchOptions
 * @property {readonly number[]} sizes texels along a side
 * @property {readonly MeshName[]} meshes
 * @property {readonly WorkName[]} works
 * @property {number} rounds that count, after the warm-up
 * @property {string | null} json where to write the figures; the plot goes beside it
 */

/** @typedef {{name: string, works: readonly WorkName[], what: string, json: string}} Command */
/** @type {Command} */
export const BENCH = {
  name: "npm run bench",
  works: WORKS,
  what: "Times a bake and a decal's drag, ours against the paper's plain method, and prints a table (bench/README.md).",
  json: "writes the figures there too, and a plot beside them (.svg for .json)",
};
/** @type {Command} */
export const BROWSER_BENCH = {
  name: "npm run bench:browser",
  works: BROWSER_WORKS,
  what: "Times the same work in Chromium: ours, Babylon.js and three.js, and the upload to the GPU (bench/README.md).",
  json: "writes the figures there too",
};

/** @param {Command} command */
export function helpOf({ name, works, what, json }) {
  return `${name} -- [options]

${what}

  --sizes 1024,2048,4096   texels along a side, 1 to ${LARGEST_SIZE}
  --meshes NAME,…          of ${MESHES.join(", ")}; all by default
  --works NAME,…           of ${works.join(", ")}; all by default
  --rounds 15              runs that count, for each engine, after two to warm up
  --json FILE.json         ${json}
  --help                   this
`;
}

/** Wrong usage: what was asked, and what could have been. Exit code 2. */
export class UsageError extends Error {
  /** @param {string} option as it was written @param {string} message */
  constructor(option, message) {
    super(message);
    this.name = "UsageError";
    this.option = option;
  }
}

/**
 * @param {readonly string[]} args @param {Command} [command]
 * @returns {BenchOptions | "help"}
 */
export function parseBenchOptions(args, { works } = BENCH) {
  const values = parseWords(args);
  if (values.help) return "help";
  return {
    sizes: list("--sizes", values.sizes).map((text) => wholeNumber("--sizes", text, LARGEST_SIZE)),
    meshes: names("--meshes", values.meshes, MESHES),
    works: names("--works", values.works ?? works.join(), works),
    rounds: wholeNumber("--rounds", values.rounds, 10_000),
    json: values.json === undefined ? null : jsonFile(values.json),
  };
}

/** @param {readonly string[]} args */
function parseWords(args) {
  return knownWords(() =>
    parseArgs({
      args: [...args],
      options: {
        sizes: { type: "string", default: "1024,2048,4096" },
        meshes: { type: "string", default: MESHES.join() },
        works: { type: "string" },
        rounds: { type: "string", default: "15" },
        json: { type: "string" },
        help: { type: "boolean", short: "h" },
      },
    }),
  ).values;
}

/**
 * Node's own refusals as ours.
 * @template Words
 * @param {() => Words} parse @returns {Words}
 */
export function knownWords(parse) {
  try {
    return parse();
  } catch (error) {
    // Node's own words name the option; some go on to explain how to escape a "-", which is no help here.
    const [sentence] = (error instanceof Error ? error.message : String(error)).split(". ");
    throw new UsageError(/'(-[^' ]*)/.exec(sentence)?.[1] ?? "", `${sentence.replace(/\.$/, "")}.`);
  }
}

/** @param {string} option @param {string} text */
function list(option, text) {
  const parts = text.split(",").map((part) => part.trim());
  if (parts.includes("")) throw new UsageError(option, `${option} "${text}" has an empty part between its commas.`);
  return [...new Set(parts)];
}

/**
 * @template {string} Name
 * @param {string} option @param {string} text @param {readonly Name[]} known
 * @returns {Name[]} in the order of `known`
 */
export function names(option, text, known) {
  const chosen = list(option, text);
  const unknown = chosen.find((name) => !known.includes(/** @type {Name} */ (name)));
  if (unknown !== undefined) {
    throw new UsageError(option, `${option} has no "${unknown}". There are: ${known.join(", ")}.`);
  }
  return known.filter((name) => chosen.includes(name));
}

/** @param {string} option @param {string} text @param {number} most */
export function wholeNumber(option, text, most) {
  const number = Number(text);
  if (/^\d+$/.test(text) && number >= 1 && number <= most) return number;
  throw new UsageError(option, `${option} takes whole numbers from 1 to ${most}, not "${text}".`);
}

/** @param {string} file */
export function jsonFile(file) {
  if (file.endsWith(".json")) return file;
  throw new UsageError("--json", `--json takes a file that ends in .json, not "${file}".`);
}

/**
 * For a script that sets up before it runs: help and refusals are told, and end the process.
 * @param {readonly string[]} args @param {Command} command
 */
export function checkOptionsOrExit(args, command) {
  checkOrExit(command.name, helpOf(command), () => parseBenchOptions(args, command));
}

/**
 * @param {string} name of the command @param {string} help
 * @param {() => unknown} parse gives "help" where that is asked for, throws a UsageError
 */
export function checkOrExit(name, help, parse) {
  try {
    if (parse() !== "help") return;
    console.log(help);
    process.exit(0);
  } catch (error) {
    if (!(error instanceof UsageError)) throw error;
    console.error(`${error.message}\n${name} -- --help lists the options.`);
    process.exit(2);
  }
}
