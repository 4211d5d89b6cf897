/**
 * How many tests passed, failed and were skipped, from what each runner reports. A runner that ended badly without
 * saying which test failed (a crash, a sanitizer's finding, a file that could not be loaded) counts as one failure.
 */
import { existsSync, readFileSync } from "node:fs";

/** @typedef {{passed: number, failed: number, skipped: number}} Counts */

const NO_REPORT = { passed: 0, failed: 1, skipped: 0 };

/**
 * @param {{output: string, exitCode: number}} run of a doctest program
 * @returns {Counts}
 */
export function doctestCounts({ output, exitCode }) {
  // biome-ignore lint/suspicious/noControlCharactersInRegex: doctest colours its summary on a terminal
  const plain = output.replace(/\x1b\[[0-9;]*m/g, "");
  const found = /test cases:\s*(\d+)\s*\|\s*(\d+) passed\s*\|\s*(\d+) failed(?:\s*\|\s*(\d+) skipped)?/.exec(plain);
  if (!found) return NO_REPORT;
  const [, , passed, failed, skipped] = found.map((text) => Number(text ?? 0));
  return withExitCode({ passed, failed, skipped }, exitCode);
}

/**
 * @param {string} file vitest's JSON report
 * @param {number} exitCode
 * @returns {Counts}
 */
export function vitestCounts(file, exitCode) {
  if (!existsSync(file)) return NO_REPORT;
  /** @type {{numPassedTests: number, numFailedTests: number, numPendingTests: number, numTodoTests: number,
   *   testResults: {status: string, assertionResults: {status: string}[]}[]}} */
  const report = JSON.parse(readFileSync(file, "utf8"));
  const brokenFiles = report.testResults.filter(
    ({ status, assertionResults }) => status === "failed" && !assertionResults.some((test) => test.status === "failed"),
  ).length;
  return withExitCode(
    {
      passed: report.numPassedTests,
      failed: report.numFailedTests + brokenFiles,
      skipped: report.numPendingTests + report.numTodoTests,
    },
    exitCode,
  );
}

/**
 * @param {string} file Playwright's JSON report
 * @param {number} exitCode
 * @returns {Counts}
 */
export function playwrightCounts(file, exitCode) {
  if (!existsSync(file)) return NO_REPORT;
  /** @type {{stats: {expected: number, unexpected: number, flaky: number, skipped: number}}} */
  const { stats } = JSON.parse(readFileSync(file, "utf8"));
  return withExitCode(
    { passed: stats.expected, failed: stats.unexpected + stats.flaky, skipped: stats.skipped },
    exitCode,
  );
}

/** @param {Counts} counts @param {number} exitCode @returns {Counts} */
function withExitCode(counts, exitCode) {
  return exitCode !== 0 && counts.failed === 0 ? { ...counts, failed: 1 } : counts;
}
