import { describe, expect, it } from "vitest";
import { HeldWeight } from "../../web/editor/state/held-weight.ts";
import { History } from "../../web/editor/state/history.ts";

function historyAt(clock: { now: number }): History<string> {
  return new History("a", { mergeWindow: 500, now: () => clock.now });
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

  it("travels to any step, and on to any other", () => {
    const history = historyAt({ now: 0 });
    for (const value of ["b", "c", "d"]) history.record(value, `to ${value}`);
    expect(history.labels).toEqual(["", "to b", "to c", "to d"]);
    expect(history.travelTo(1)).toBe(true);
    expect([history.present, history.undoLabel, history.redoLabel]).toEqual(["b", "to b", "to c"]);
    expect([0, 1, 2, 3, 4].map((place) => history.valueAt(place))).toEqual(["a", "b", "c", "d", undefined]);
    expect(history.travelTo(3)).toBe(true);
    expect(history.present).toBe("d");
    expect(history.labels).toEqual(["", "to b", "to c", "to d"]);
    for (const nowhere of [3, -1, 4, 0.5]) expect(history.travelTo(nowhere), String(nowhere)).toBe(false);
  });
});

interface Recipe {
  readonly layers: readonly { readonly id: number; readonly dabs: Float64Array }[];
}

const KIBIBYTE = 1024;
const layer = (id: number, bytes: number) => ({ id, dabs: new Float64Array(bytes / 8) });
const above = (recipe: Recipe, id: number, bytes: number): Recipe => ({ layers: [...recipe.layers, layer(id, bytes)] });

describe("the history's budget", () => {
  it("lets steps be as many as they like while they share what they hold", () => {
    let recipe: Recipe = { layers: [layer(0, 64 * KIBIBYTE)] };
    const history = new History(recipe, { budget: 512 * KIBIBYTE });
    for (let id = 1; id <= 1000; id += 1) {
      recipe = { layers: [recipe.layers[0] as Recipe["layers"][number], layer(id, 8)] };
      history.record(recipe, "stroke");
    }
    expect(history.position).toBe(1000);
    expect(history.dropped).toBe(0);
  });

  it("drops the oldest steps first, and no more than it must", () => {
    const start: Recipe = { layers: [] };
    const history = new History(start, { budget: 40 * KIBIBYTE });
    for (let id = 1; id <= 5; id += 1) history.record(above(start, id, 16 * KIBIBYTE), `step ${id}`);
    expect(history.labels).toEqual(["step 3", "step 4", "step 5"]);
    expect(history.dropped).toBe(3);
    expect(history.heldBytes).toBeLessThanOrEqual(40 * KIBIBYTE);
  });

  it("does not count against the steps what the present itself holds", () => {
    let recipe: Recipe = { layers: [] };
    const history = new History(recipe, { budget: 8 * KIBIBYTE });
    for (let id = 1; id <= 20; id += 1) {
      recipe = above(recipe, id, 64 * KIBIBYTE);
      history.record(recipe, "stroke");
    }
    expect(history.dropped).toBe(0);
    expect(history.heldBytes).toBeLessThan(8 * KIBIBYTE);
  });

  it("drops nothing that one travels over", () => {
    let recipe: Recipe = { layers: [] };
    const history = new History(recipe, { budget: 8 * KIBIBYTE });
    for (let id = 1; id <= 20; id += 1) {
      recipe = above(recipe, id, 64 * KIBIBYTE);
      history.record(recipe, "stroke");
    }
    history.travelTo(0);
    expect(history.dropped).toBe(0);
    history.travelTo(20);
    expect(history.present).toBe(recipe);
  });

  it("holds nothing more once its steps are forgotten, dropped or merged", () => {
    const history = new History<Recipe>({ layers: [] }, { now: () => 0 });
    for (let id = 1; id <= 3; id += 1) {
      history.record({ layers: [layer(id, 64 * KIBIBYTE)] }, "scrub", "scrub");
    }
    expect(history.position).toBe(1);
    expect(history.heldBytes).toBeLessThan(KIBIBYTE);
    history.undo();
    expect(history.heldBytes).toBeGreaterThan(64 * KIBIBYTE);
    history.record({ layers: [] }, "other");
    expect(history.heldBytes).toBeLessThan(KIBIBYTE);
    history.record({ layers: [layer(9, 64 * KIBIBYTE)] }, "more");
    history.reset({ layers: [] });
    expect(history.heldBytes).toBe(0);
  });

  it("is kept at once when it is made smaller", () => {
    const start: Recipe = { layers: [] };
    const history = new History(start);
    for (let id = 1; id <= 5; id += 1) history.record(above(start, id, 16 * KIBIBYTE), `step ${id}`);
    history.budget = 20 * KIBIBYTE;
    expect(history.labels).toEqual(["step 4", "step 5"]);
  });
});

describe("what values hold", () => {
  it("is counted once where they share it, and until the last of them goes", () => {
    const shared = { uri: "x".repeat(1000) };
    const weight = new HeldWeight();
    const [one, two] = [{ shared }, { shared }];
    weight.retain(one);
    const alone = weight.bytes;
    expect(alone).toBeGreaterThan(1000);
    weight.retain(two);
    expect(weight.bytes - alone).toBeLessThan(100);
    weight.release(one);
    expect(weight.bytes).toBe(alone);
    weight.release(two);
    expect(weight.bytes).toBe(0);
  });

  it("is as much for a dab as for its vectors and it by themselves, and goes with it", () => {
    const weight = new HeldWeight();
    const vectors = { position: [0, 1, 2], rotation: [0, 0, 0, 1], size: [1, 1, 1] };
    const alone = Object.values(vectors).map((vector) => {
      weight.retain(vector);
      const { bytes } = weight;
      weight.release(vector);
      return bytes;
    });
    // A header and a pointer to each.
    const object = 24 + 8 * 3;
    weight.retain(vectors);
    expect(weight.bytes).toBe(object + alone.reduce((sum, bytes) => sum + bytes, 0));
    weight.release(vectors);
    expect(weight.bytes).toBe(0);
  });

  it("counts a long list of numbers once, however many share it", () => {
    const faces = Array.from({ length: 10_000 }, (_, index) => index);
    const weight = new HeldWeight();
    weight.retain({ faces });
    const alone = weight.bytes;
    expect(alone).toBeGreaterThan(80_000);
    weight.retain({ faces });
    expect(weight.bytes - alone).toBeLessThan(100);
  });

  it("includes a model's bytes and its side files", () => {
    const weight = new HeldWeight();
    const bytes = new Uint8Array(5000);
    weight.retain({ source: { name: "fox.gltf", bytes, resources: new Map([["fox.bin", new Uint8Array(7000)]]) } });
    expect(weight.bytes).toBeGreaterThan(12_000);
    expect(weight.bytes).toBeLessThan(12_500);
  });
});
