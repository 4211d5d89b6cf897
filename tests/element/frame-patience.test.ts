/** How long the shop's side of the iframe waits for an answer. */
import { expect, test } from "vitest";
import { patienceFor } from "../../web/embed/frame.ts";
import { FRAME_METHODS } from "../../web/embed/frame-api.ts";

test("what loads or exports may take two minutes, what only changes the design half a minute", () => {
  const quick = FRAME_METHODS.filter((method) => patienceFor(method) === 30_000);
  expect(quick).toEqual(["redo", "removeLayer", "select", "undo"]);
  const long = FRAME_METHODS.filter((method) => !quick.includes(method));
  expect(long.map(patienceFor)).toEqual(long.map(() => 120_000));
});
