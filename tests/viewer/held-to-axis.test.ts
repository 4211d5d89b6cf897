import { describe, expect, it } from "vitest";
import { heldToAxis } from "../../web/viewer/held-to-axis.ts";

describe("a slide that Shift holds", () => {
  it("keeps to the row or the column that it began in, whichever it has gone further along", () => {
    const from = { x: 10, y: 20 };
    expect(heldToAxis(from, { x: 40, y: 25 })).toEqual({ x: 40, y: 20 });
    expect(heldToAxis(from, { x: -40, y: 60 })).toEqual({ x: -40, y: 20 });
    expect(heldToAxis(from, { x: 15, y: -20 })).toEqual({ x: 10, y: -20 });
  });

  it("stays where it began until it has gone anywhere", () => {
    const from = { x: 10, y: 20 };
    expect(heldToAxis(from, from)).toEqual(from);
  });
});
