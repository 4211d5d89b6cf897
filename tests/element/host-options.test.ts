/** Which shops an editor's page lets in, written wrongly, is told to that page: the shop's own would wait for an answer in vain. */
import { expect, test } from "vitest";
import { hostEditor } from "../../web/embed/host.ts";

test.each([
  ["nothing", undefined, "shops", "undefined"],
  ["no list", { shops: "https://shop.example.com" }, "shops", "https://shop.example.com"],
  ["none said", {}, "shops", "undefined"],
  [
    "an origin with a slash",
    { shops: ["https://a.example", "https://shop.example/"] },
    "shops[1]",
    "https://shop.example/",
  ],
  ["a host alone", { shops: ["shop.example"] }, "shops[0]", "shop.example"],
  ["every shop as a star", { shops: ["*"] }, "shops[0]", "*"],
])("%s is refused by its place", (_what, options, field, value) => {
  let thrown: unknown;
  try {
    hostEditor({} as never, options as never);
  } catch (error) {
    thrown = error;
  }
  expect(thrown).toMatchObject({
    code: "bad-argument",
    field,
    value,
    hint: expect.stringContaining("https://shop.example"),
  });
});
