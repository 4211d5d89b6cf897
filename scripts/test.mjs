/**
 * `npm test`: sets up, runs every kind of test, and closes with one line: `N passed, N failed[, N skipped]`.
 * A stage that fails does not stop the ones after it.
 */
import { seconds } from "./bootstrap/progress.mjs";
import { wordsOrExit } from "./bootstrap/words-or-exit.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";

const USAGE = `npm test                              all of it
npm test -- --only vitest             one stage, or several with commas
npm test -- --only vitest tests/core  arguments for that stage's runner`;
const { values, positionals } = wordsOrExit({ options: { only: { type: "string" } }, allowPositionals: true }, USAGE);

await bootstrapOrExit("test");
// Only now: the stages use packages.
const { STAGES, stagesOf } = await import("./test/stages.mjs");
const chosen = values.only?.split(",") ?? STAGES.map((stage) => stage.key);
const unknown = chosen.find((key) => !STAGES.some((stage) => stage.key === key));
if (unknown !== undefined) {
  console.error(`There is no stage "${unknown}". Stages: ${STAGES.map((stage) => stage.key).join(", ")}`);
  process.exit(2);
}

const total = { passed: 0, failed: 0, skipped: 0 };
/** @type {string[]} */
const summary = [];
for (const stage of stagesOf(chosen)) {
  console.log(`\n== ${stage.title} ==`);
  const start = performance.now();
  const counts = await stage.run(positionals).catch((error) => {
    console.log(error instanceof Error ? error.message : String(error));
    return { passed: 0, failed: 1, skipped: 0 };
  });
  total.passed += counts.passed;
  total.failed += counts.failed;
  total.skipped += counts.skipped;
  summary.push(`${line(counts).padEnd(34)}${seconds(performance.now() - start).padStart(7)}  ${stage.title}`);
}
console.log(`\n== Summary ==\n${summary.join("\n")}\n`);
console.log(line(total));
process.exitCode = total.failed > 0 || total.passed === 0 ? 1 : 0;

/** @param {{passed: number, failed: number, skipped: number}} counts */
function line({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed${skipped > 0 ? `, ${skipped} skipped` : ""}`;
}
