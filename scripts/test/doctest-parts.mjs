/** Runs a doctest program in parts, as many side by side as there are processors. */
import { availableParallelism } from "node:os";
import { doctestCounts } from "./counts.mjs";

/** @typedef {import("./counts.mjs").Counts} Counts */
/** @typedef {(args: readonly string[]) => Promise<{output: string, exitCode: number}>} RunPart */

/** Parts for each processor: enough that those which began late do not wait for a long one. */
const PARTS_A_PROCESSOR = 8;

/** Of either kind of path; with the folder, since some names are the ends of others. @param {string} file */
const filterOf = (file) => `*native?${file}`;

/**
 * @param {readonly string[]} files of tests/native, with tests in them, which tell the parts apart
 * @param {RunPart} run the program with these arguments, its output not shown
 * @param {{show?: (text: string) => void, processors?: number}} [options]
 * @returns {Promise<Counts>} tests that no part ran count as skipped
 */
export async function runInParts(
  files,
  run,
  { show = (text) => process.stdout.write(text), processors = availableParallelism() } = {},
) {
  const waiting = dealt(files, processors * PARTS_A_PROCESSOR);
  const total = { passed: 0, failed: 0, skipped: 0 };
  let registered = 0;
  const work = async () => {
    for (let part = waiting.shift(); part !== undefined; part = waiting.shift()) {
      const result = await run([`--source-file=${part.map(filterOf).join(",")}`]);
      const { passed, failed, skipped } = doctestCounts(result);
      total.passed += passed;
      total.failed += failed;
      registered = Math.max(registered, passed + failed + skipped);
      show(failed > 0 ? result.output : `${String(passed).padStart(4)} passed  ${part.join(" ")}\n`);
    }
  };
  await Promise.all(Array.from({ length: processors }, work));
  return { ...total, skipped: Math.max(0, registered - total.passed - total.failed) };
}

/** @template T @param {readonly T[]} all @param {number} count @returns {T[][]} none of them empty */
function dealt(all, count) {
  return Array.from({ length: Math.min(count, all.length) }, (_, part) => all.filter((_, at) => at % count === part));
}
