import { describe, expect, it } from "vitest";
import { History } from "../../web/editor/state/history.ts";

function historyAt(clock: { now: number }): History<string> {
  return new History("a", { limit: 3, mergeWindow: 500, now: () => clock.now });
}

describe("the history", () => {
  it("undoes and redoes steps in order and names them", () => {
    const history = historyAt({ now: 0 });
    history.record("b", "first");
    history.record("c", "second");
    expect(history.undoLabel).toBe("second");
    history.undo();
    expect(history.present).toBe("b");
    expect([history.undoLabel, history.redoLabel]).toEqual(["first", "second"]);
    history.redo();
    expect(history.present).toBe("c");
    expect(history.redoLabel).toBeNull();
  });

  it("makes one step of a preview, however many values it showed", () => {
    const history = historyAt({ now: 0 });
    for (const value of ["b", "c", "d"]) history.preview(value);
    expect(history.present).toBe("d");
    expect(history.recorded).toBe("a");
    history.record("e", "drag");
    history.undo();
    expect(history.present).toBe("a");
  });

  it("forgets a cancelled preview", () => {
    const history = historyAt({ now: 0 });
    history.preview("b");
    history.cancelPreview();
    expect(history.present).toBe("a");
    expect(history.undoLabel).toBeNull();
  });

  it("records nothing when a gesture ends where it began", () => {
    const history = historyAt({ now: 0 });
    history.preview("b");
    history.record("a", "drag");
    expect(history.previewing).toBe(false);
    expect(history.undoLabel).toBeNull();
  });

  it("merges steps of one kind that follow within half a second", () => {
    const clock = { now: 0 };
    const history = historyAt(clock);
    for (const [value, time] of [
      ["b", 0],
      ["c", 400],
      ["d", 800],
    ] as const) {
      clock.now = time;
      history.record(value, "nudge", "nudge:1");
    }
    history.undo();
    expect(history.present).toBe("a");
  });

  it("keeps steps apart that are of different kinds, or further apart in time", () => {
    const clock = { now: 0 };
    const history = historyAt(clock);
    history.record("b", "nudge", "nudge:1");
    history.record("c", "nudge", "nudge:2");
    clock.now = 501;
    history.record("d", "nudge", "nudge:2");
    history.undo();
    expect(history.present).toBe("c");
    history.undo();
    expect(history.present).toBe("b");
  });

  it("never merges into a step that an undo brought back", () => {
    const history = historyAt({ now: 0 });
    history.record("b", "nudge", "nudge:1");
    history.record("c", "other");
    history.undo();
    history.record("d", "nudge", "nudge:1");
    history.undo();
    expect(history.present).toBe("b");
  });

  it("drops what could be redone once something new is recorded", () => {
    const history = historyAt({ now: 0 });
    history.record("b", "first");
    history.undo();
    history.record("c", "second");
    expect(history.redo()).toBe(false);
    expect(history.present).toBe("c");
  });

  it("keeps no more steps than its limit", () => {
    const history = historyAt({ now: 0 });
    for (const value of ["b", "c", "d", "e"]) history.record(value, value);
    while (history.undo());
    expect(history.present).toBe("b");
  });
});
