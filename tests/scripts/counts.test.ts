import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, describe, expect, test } from "vitest";
import { doctestCounts, playwrightCounts, vitestCounts } from "../../scripts/test/counts.mjs";

const folder = mkdtempSync(join(tmpdir(), "texelcast-counts-"));
afterAll(() => rmSync(folder, { recursive: true }));

function reportFile(content: unknown): string {
  const file = join(folder, "report.json");
  writeFileSync(file, JSON.stringify(content));
  return file;
}

describe("counting doctest's tests", () => {
  const summary = "[doctest] test cases:  7 |  5 passed | 2 failed | 1 skipped\n[doctest] assertions: 90 | …";

  test("test cases are counted, not assertions", () => {
    expect(doctestCounts({ output: summary, exitCode: 1 })).toEqual({ passed: 5, failed: 2, skipped: 1 });
  });

  test("a coloured summary reads the same", () => {
    const coloured = "test cases: \x1b[0m7\x1b[0m | \x1b[32m7 passed\x1b[0m | \x1b[31m0 failed\x1b[0m | 0 skipped";
    expect(doctestCounts({ output: coloured, exitCode: 0 })).toEqual({ passed: 7, failed: 0, skipped: 0 });
  });

  test("a crash before the summary is a failure", () => {
    expect(doctestCounts({ output: "Segmentation fault", exitCode: 128 }).failed).toBe(1);
  });

  test("a sanitizer's finding after a clean summary is a failure", () => {
    const clean = "test cases: 3 | 3 passed | 0 failed | 0 skipped";
    expect(doctestCounts({ output: clean, exitCode: 1 })).toEqual({ passed: 3, failed: 1, skipped: 0 });
  });
});

describe("counting vitest's tests", () => {
  test("a file that could not be loaded is a failure", () => {
    const file = reportFile({
      numPassedTests: 4,
      numFailedTests: 0,
      numPendingTests: 1,
      numTodoTests: 0,
      testResults: [
        { status: "passed", assertionResults: [{ status: "passed" }] },
        { status: "failed", assertionResults: [] },
      ],
    });
    expect(vitestCounts(file, 1)).toEqual({ passed: 4, failed: 1, skipped: 1 });
  });

  test("no report at all is a failure", () => {
    expect(vitestCounts(join(folder, "none.json"), 0).failed).toBe(1);
  });
});

test("a flaky end-to-end test is a failure, since nothing is tried twice", () => {
  const file = reportFile({ stats: { expected: 9, unexpected: 1, flaky: 1, skipped: 2 } });
  expect(playwrightCounts(file, 1)).toEqual({ passed: 9, failed: 2, skipped: 2 });
});
