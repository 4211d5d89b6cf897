import { describe, expect, it } from "vitest";
import { FIRST_WINDOW, renderedRows, rowWindow } from "../../web/editor/panels/row-window.ts";

const ROWS = Array.from({ length: 1000 }, (_, at) => ({ id: `row-${at}` }));
const rendered = (top: number, height: number, needed: readonly string[] = []): number[] =>
  renderedRows(ROWS, rowWindow(top, height), ({ id }) => needed.includes(id));

describe("the rows of a long list that are rendered", () => {
  it("are those in sight with some to either side, and few of all", () => {
    for (const top of [0, 0.4, 17, 499.9, 980]) {
      const places = rendered(top, 20);
      const [first, last] = [Math.max(0, Math.floor(top) - 12), Math.min(999, Math.ceil(top) + 19 + 12)];
      for (let at = first; at <= last; at += 1) expect(places).toContain(at);
      expect(places.length).toBeLessThanOrEqual(20 + 2 * (12 + 8));
    }
  });

  it("are the same ones while the list is scrolled by less than a row or a few", () => {
    expect(rowWindow(102, 18)).toEqual(rowWindow(100, 20));
    expect(rowWindow(130, 20)).not.toEqual(rowWindow(100, 20));
  });

  it("hold, in their order, those that are needed wherever they lie", () => {
    const places = rendered(500, 10, ["row-999", "row-0", "row-505"]);
    expect(places[0]).toBe(0);
    expect(places.at(-1)).toBe(999);
    expect(places).toEqual([...new Set(places)].sort((a, b) => a - b));
  });

  it("are all of a short list, and the topmost of one without a size yet", () => {
    expect(renderedRows(ROWS.slice(0, 5), rowWindow(0, 0), () => false)).toEqual([0, 1, 2, 3, 4]);
    expect(renderedRows(ROWS, FIRST_WINDOW, () => false)).toHaveLength(FIRST_WINDOW.end);
  });

  it("are none where the list has become shorter than it is scrolled, until it is scrolled back", () => {
    expect(renderedRows(ROWS.slice(0, 5), rowWindow(400, 20), () => false)).toEqual([]);
  });
});
