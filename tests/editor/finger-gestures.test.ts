import { describe, expect, it } from "vitest";
import { FingerGestures } from "../../web/editor/state/finger-gestures.ts";

/** So many fingers that go so far, all down before the first is lifted. */
function meaningOf(count: number, way: { x: number; y: number }, milliseconds: number) {
  const gestures = new FingerGestures();
  const fingers = Array.from({ length: count }, (_, id) => ({ id, x: 100 + 60 * id, y: 300, time: 10 * id }));
  for (const finger of fingers) gestures.down(finger);
  return fingers
    .map(({ id, x, y }) => gestures.up({ id, x: x + way.x, y: y + way.y, time: milliseconds }))
    .findLast(() => true);
}

describe("gestures of several fingers", () => {
  it("a tap of three undoes, of four redoes", () => {
    expect(meaningOf(3, { x: 2, y: 3 }, 200)).toBe("undo");
    expect(meaningOf(4, { x: 2, y: 3 }, 200)).toBe("redo");
  });

  it("three that swipe to the left undo, to the right redo", () => {
    expect(meaningOf(3, { x: -120, y: 10 }, 500)).toBe("undo");
    expect(meaningOf(3, { x: 120, y: -10 }, 500)).toBe("redo");
  });

  it("one and two fingers, a long rest and a way up or down mean nothing", () => {
    expect(meaningOf(1, { x: 0, y: 0 }, 100)).toBeNull();
    expect(meaningOf(2, { x: 0, y: 0 }, 100)).toBeNull();
    expect(meaningOf(3, { x: 0, y: 0 }, 900)).toBeNull();
    expect(meaningOf(3, { x: 20, y: 140 }, 300)).toBeNull();
    expect(meaningOf(5, { x: 0, y: 0 }, 100)).toBeNull();
  });

  it("a gesture that the system takes over means nothing, and the next one counts", () => {
    const gestures = new FingerGestures();
    const at = (id: number, time: number) => ({ id, x: 100 * id, y: 100, time });
    for (const id of [1, 2, 3]) gestures.down(at(id, 0));
    gestures.cancel();
    expect(gestures.up(at(1, 50))).toBeNull();
    for (const id of [4, 5, 6]) gestures.down(at(id, 100));
    expect([4, 5, 6].map((id) => gestures.up(at(id, 200)))).toEqual([null, null, "undo"]);
  });
});
