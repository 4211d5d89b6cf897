import { describe, expect, test } from "vitest";
import { MESHES, parseBenchOptions, UsageError, WORKS } from "../../bench/options.mjs";

function refusal(...args: string[]): UsageError {
  try {
    parseBenchOptions(args);
  } catch (error) {
    if (error instanceof UsageError) return error;
    throw error;
  }
  throw new Error(`${args.join(" ")} was taken`);
}

describe("the benchmark's options", () => {
  test("nothing said is everything, fifteen times", () => {
    expect(parseBenchOptions([])).toEqual({
      sizes: [1024, 2048, 4096],
      meshes: MESHES,
      works: WORKS,
      rounds: 15,
      json: null,
    });
  });

  test("what is said is taken, each once, works in the order in which they run", () => {
    const words = ["--sizes", "64, 32,64", "--works", "whole,bake", "--meshes=torus200k", "--rounds", "3"];
    expect(parseBenchOptions([...words, "--json", "a/b.json"])).toEqual({
      sizes: [64, 32],
      meshes: ["torus200k"],
      works: ["bake", "whole"],
      rounds: 3,
      json: "a/b.json",
    });
  });

  test("help wins over the rest", () => {
    expect(parseBenchOptions(["--rounds", "many", "-h"])).toBe("help");
  });

  test.each([
    ["--size", "--size", "2048"],
    ["--json", "--json"],
    ["--sizes", "--sizes", "2048,"],
    ["--sizes", "--sizes", "0"],
    ["--sizes", "--sizes", "8193"],
    ["--sizes", "--sizes", "1e3"],
    ["--rounds", "--rounds", "-1"],
    ["--rounds", "--rounds=1.5"],
    ["--json", "--json", "results.txt"],
  ])("a slip is refused by the name of its option, %s: %s %s", (option, ...args) => {
    expect(refusal(...args).option).toBe(option);
    expect(refusal(...args).message).toContain(option);
  });

  test("a name that there is not is answered with those that there are", () => {
    expect(refusal("--works", "bake,local5").message).toBe(`--works has no "local5". There are: ${WORKS.join(", ")}.`);
  });

  test("a word without an option is refused", () => {
    expect(refusal("2048").message).toContain("'2048'");
  });
});
