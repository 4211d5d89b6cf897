import { describe, expect, test } from "vitest";
import { runInParts } from "../../scripts/test/doctest-parts.mjs";

const FILES = Array.from({ length: 21 }, (_, at) => `part${at}_test.cpp`);

/** A program with `perFile` tests in each file and `elsewhere` beside them, as doctest would report it. */
function program(perFile: number, { elsewhere = 0, broken = "" } = {}) {
  const parts: string[][] = [];
  let running = 0;
  let most = 0;
  const run = async ([filter]: readonly string[]) => {
    const files = filter.replace("--source-file=", "").replaceAll("*native?", "").split(",");
    parts.push(files);
    most = Math.max(most, ++running);
    await new Promise((done) => setTimeout(done, 1));
    running -= 1;
    const failed = files.includes(broken) ? 1 : 0;
    const ran = files.length * perFile;
    const skipped = FILES.length * perFile + elsewhere - ran;
    const output = `test cases: ${ran} | ${ran - failed} passed | ${failed} failed | ${skipped} skipped\n`;
    return { output: `${broken}: what went wrong\n${output}`, exitCode: failed };
  };
  return { run, parts, most: () => most };
}

describe("a test program in parts", () => {
  test("runs each file once, side by side as far as there are processors, and adds up", async () => {
    const { run, parts, most } = program(3);
    expect(await runInParts(FILES, run, { show: () => {}, processors: 2 })).toEqual({
      passed: 63,
      failed: 0,
      skipped: 0,
    });
    expect(parts.flat().sort()).toEqual([...FILES].sort());
    expect(most()).toBe(2);
  });

  test("shows all that a part with a failure said, and of the others a line", async () => {
    let shown = "";
    const { run } = program(3, { broken: "part4_test.cpp" });
    const show = (text: string) => {
      shown += text;
    };
    expect(await runInParts(FILES, run, { show, processors: 1 })).toEqual({ passed: 62, failed: 1, skipped: 0 });
    expect(shown.match(/what went wrong/g)).toHaveLength(1);
    expect(shown).toMatch(/^ +\d+ passed {2}part1_test\.cpp/m);
  });

  test("counts tests that no part ran as skipped, and a part that crashed as a failure", async () => {
    const { run } = program(1, { elsewhere: 2 });
    expect((await runInParts(FILES, run, { show: () => {}, processors: 3 })).skipped).toBe(2);
    const crash = async () => ({ output: "Segmentation fault", exitCode: 128 });
    expect((await runInParts(["a_test.cpp"], crash, { show: () => {}, processors: 3 })).failed).toBe(1);
  });
});
