import { expect, it, vi } from "vitest";
import { english } from "../../web/element/words/english.ts";
import { wordsIn } from "../../web/element/words/words.ts";

const fault = new TypeError("Failed to fetch dynamically imported module: https://shop.example/worded.js");
vi.mock("../../web/element/words/worded.ts", () => ({
  get worded() {
    throw fault;
  },
}));

it("without what reads a shop's own words the element speaks by itself, and the page is told", async () => {
  const told: unknown[] = [];
  expect(await wordsIn("en", { submit: "Buy" }, (error) => told.push(error))).toBe(english);
  expect(told).toEqual([fault]);
});
