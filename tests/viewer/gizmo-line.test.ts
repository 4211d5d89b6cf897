import { describe, expect, it } from "vitest";
import { piecesOf } from "../../web/viewer/gizmo-line.ts";

describe("a line's pieces", () => {
  it("are the points of each open line of a path", () => {
    expect(piecesOf("M1.0 2.0L3.5 4.0L5.0 -6.0")).toEqual(["1.0 2.0 3.5 4.0 5.0 -6.0"]);
    expect(piecesOf("M1.0 2.0L3.0 4.0M7.0 8.0L9.0 10.0")).toEqual(["1.0 2.0 3.0 4.0", "7.0 8.0 9.0 10.0"]);
  });

  it("are none where nothing is drawn, or where a line is closed, which a polyline is not", () => {
    expect(piecesOf("")).toEqual([]);
    expect(piecesOf("M1.0 2.0L3.0 4.0L5.0 6.0Z")).toEqual([]);
  });
});
