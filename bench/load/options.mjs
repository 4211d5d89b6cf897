/** The words behind `npm run bench:load --`; Node's built-ins alone, as it is read before anything is set up. */
import { parseArgs } from "node:util";
import { jsonFile, knownWords, names, wholeNumber } from "../options.mjs";

/** In the order in which they run. */
export const PAGES = /** @type {const} */ (["html", "shop", "framed"]);

/**
 * @typedef {object} LoadOptions
 * @property {readonly (typeof PAGES)[number][]} pages
 * @property {number} rounds loads of each page under each condition
 * @property {string | null} json where to write the figures
 * @property {boolean} readme whether to write the tables into README.md
 */

export const LOAD_BENCH = {
  name: "npm run bench:load",
  help: `npm run bench:load -- [options]

Opens pages with the element in Chromium with nothing cached, and prints tables of times and bytes (bench/README.md).

  --pages html,shop    of ${PAGES.join(", ")}; without it all but the last
  --rounds 3           loads of each page under each condition
  --json FILE.json     writes the figures there too
  --readme             writes the budget's tables into README.md
  --help               this
`,
};

/**
 * @param {readonly string[]} args
 * @returns {LoadOptions | "help"}
 */
export function parseLoadOptions(args) {
  const { values } = knownWords(() =>
    parseArgs({
      args: [...args],
      options: {
        pages: { type: "string", default: "html,shop" },
        rounds: { type: "string", default: "3" },
        json: { type: "string" },
        readme: { type: "boolean", default: false },
        help: { type: "boolean", short: "h" },
      },
    }),
  );
  if (values.help) return "help";
  return {
    pages: names("--pages", values.pages, PAGES),
    rounds: wholeNumber("--rounds", values.rounds, 100),
    json: values.json === undefined ? null : jsonFile(values.json),
    readme: values.readme,
  };
}
