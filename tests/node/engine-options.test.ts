import { expect, it } from "vitest";
import { createEngine } from "../../node/package.ts";

it.each<[string, unknown]>([
  ["text, as an environment has it", "512"],
  ["nothing", 0],
  ["less than nothing", -1],
  ["no number", Number.NaN],
  ["more than there is", 65_537],
  ["null", null],
])("an engine's budget that is %s is refused by its name as the engine is made", (_what, memoryBudgetMib) => {
  const make = () => createEngine({ memoryBudgetMib } as never);
  expect(make).toThrow(expect.objectContaining({ code: "bad-argument", field: "memoryBudgetMib" }));
});

it("an engine's options that are none are refused", () => {
  expect(() => createEngine(null as never)).toThrow(
    expect.objectContaining({ code: "bad-argument", field: "options" }),
  );
});
