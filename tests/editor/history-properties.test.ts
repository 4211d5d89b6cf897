import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { HeldWeight } from "../../web/editor/state/held-weight.ts";
import { History } from "../../web/editor/state/history.ts";

interface Value {
  readonly id: number;
  readonly bytes: Uint8Array;
}

type Act =
  | { readonly do: "record"; readonly key: string | undefined }
  | { readonly do: "wait"; readonly ms: number }
  | { readonly do: "travel"; readonly to: number }
  | { readonly do: "preview" | "cancel" | "undo" | "redo" | "again" | "reset" };

const acts: fc.Arbitrary<Act[]> = fc.array(
  fc.oneof<fc.Arbitrary<Act>[]>(
    fc.record({ do: fc.constant("record" as const), key: fc.constantFrom(undefined, "nudge:1", "nudge:2") }),
    fc.record({ do: fc.constant("record" as const), key: fc.constantFrom(undefined, "nudge:1") }),
    fc.record({ do: fc.constant("wait" as const), ms: fc.constantFrom(1, 500, 501) }),
    fc.record({ do: fc.constant("travel" as const), to: fc.integer({ min: -1, max: 8 }) }),
    fc.record({ do: fc.constantFrom("preview", "cancel", "undo", "redo", "again", "reset") }),
  ),
  { maxLength: 40 },
);

/** A history as one would draw it on paper: a row of values, a finger on one of them. */
class PaperHistory {
  row: { value: Value; label: string }[];
  at = 0;
  shown: Value | undefined;
  /** What the next step may become one with. */
  open: { readonly key: string; readonly time: number } | undefined;

  constructor(value: Value) {
    this.row = [{ value, label: "" }];
  }

  record(value: Value, label: string, key: string | undefined, time: number): void {
    this.shown = undefined;
    const isLast = this.at === this.row.length - 1;
    const merges = isLast && this.open !== undefined && this.open.key === key && time - this.open.time <= 500;
    if (!merges) this.at += 1;
    this.row = [...this.row.slice(0, this.at), { value, label }];
    this.open = key === undefined ? undefined : { key, time };
  }

  travel(to: number): boolean {
    if (to === this.at || this.row[to] === undefined) return false;
    this.at = to;
    this.shown = undefined;
    this.open = undefined;
    return true;
  }

  reset(value: Value): void {
    Object.assign(this, new PaperHistory(value), { shown: undefined, open: undefined });
  }
}

/** What all of those values hold together, and what one of them holds by itself. */
function bytesOf(values: Iterable<Value>): number {
  const weight = new HeldWeight();
  for (const value of values) weight.retain(value);
  return weight.bytes;
}

describe("the history, whatever is done to it,", () => {
  it("is a row of values with a finger on one, and weighs what the others add to that one", () => {
    fc.assert(
      fc.property(acts, (list) => {
        let made = 0;
        let now = 0;
        const make = (): Value => ({ id: made++, bytes: new Uint8Array(64 * (made % 5)) });
        const first = make();
        const history = new History(first, { now: () => now });
        const paper = new PaperHistory(first);
        for (const act of list) {
          if (act.do === "wait") now += act.ms;
          if (act.do === "record") {
            const value = make();
            history.record(value, `step ${value.id}`, act.key);
            paper.record(value, `step ${value.id}`, act.key, now);
          }
          if (act.do === "again") {
            history.record(history.recorded, "nothing new");
            paper.shown = undefined;
          }
          if (act.do === "preview") {
            paper.shown = make();
            history.preview(paper.shown);
          }
          if (act.do === "cancel") {
            history.cancelPreview();
            paper.shown = undefined;
          }
          if (act.do === "undo") expect(history.undo()).toBe(paper.travel(paper.at - 1));
          if (act.do === "redo") expect(history.redo()).toBe(paper.travel(paper.at + 1));
          if (act.do === "travel") expect(history.travelTo(act.to)).toBe(paper.travel(act.to));
          if (act.do === "reset") {
            const value = make();
            history.reset(value);
            paper.reset(value);
          }
          const { row, at } = paper;
          const recorded = row[at]?.value as Value;
          expect(history.labels).toEqual(row.map(({ label }) => label));
          expect(new Set(history.values())).toEqual(new Set(row.map(({ value }) => value)));
          expect(row.map((_, place) => history.valueAt(place)?.id)).toEqual(row.map(({ value }) => value.id));
          expect(history.valueAt(row.length)).toBeUndefined();
          expect([history.position, history.dropped, history.previewing]).toEqual([at, 0, paper.shown !== undefined]);
          expect([history.recorded, history.present]).toEqual([recorded, paper.shown ?? recorded]);
          expect(history.undoLabel).toBe(at > 0 ? row[at]?.label : null);
          expect(history.redoLabel).toBe(row[at + 1]?.label ?? null);
          expect(history.heldBytes).toBe(bytesOf(row.map(({ value }) => value)) - bytesOf([recorded]));
        }
      }),
      { numRuns: 300 },
    );
  });

  it("keeps all of its steps in a budget of just their weight, and one less in a budget of a byte less", () => {
    const make = (id: number): Value => ({ id, bytes: new Uint8Array(1000 + id) });
    const steps = Array.from({ length: 6 }, (_, id) => make(id));
    const first = steps[0] as Value;
    const ample = new History(first);
    for (const step of steps.slice(1)) ample.record(step, `step ${step.id}`);
    for (const [short, dropped] of [
      [0, 0],
      [1, 1],
    ] as const) {
      const history = new History(first, { budget: ample.heldBytes - short });
      for (const step of steps.slice(1)) history.record(step, `step ${step.id}`);
      expect([history.dropped, history.position]).toEqual([dropped, 5 - dropped]);
    }
  });
});
