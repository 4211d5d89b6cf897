import { describe, expect, it } from "vitest";
import type { ScaleHandleName } from "../../web/viewer/gizmo-overlay.ts";
import { scaleHandlePlaces } from "../../web/viewer/handle-places.ts";
import { distance, FINGER_REACH, handleUnder, MOUSE_REACH } from "../../web/viewer/handle-under.ts";

const middle = { x: 200, y: 300 };

/** Handles of an upright rectangle about the middle, y down. */
function placesOf(width: number, height: number, reach: number) {
  const pixelOf = (name: ScaleHandleName) => ({
    x: middle.x + (name.includes("e") ? width / 2 : name.includes("w") ? -width / 2 : 0),
    y: middle.y + (name.includes("s") ? height / 2 : name.includes("n") ? -height / 2 : 0),
  });
  return new Map(scaleHandlePlaces(pixelOf, { middle, reach }));
}

describe("the handles of an outline", () => {
  const sizes = [2, 12, 30, 60, 88, 120, 300].flatMap((width) =>
    [2, 12, 30, 60, 88, 120, 300].map((height) => [width, height] as const),
  );

  it.each([
    ["a finger", FINGER_REACH],
    ["a mouse", MOUSE_REACH],
  ])("leave %s the middle, however small it is", (_, reach) => {
    for (const [width, height] of sizes) {
      const places = placesOf(width, height, reach);
      for (let angle = 0; angle < 360; angle += 15) {
        const radians = (angle * Math.PI) / 180;
        const press = {
          x: middle.x + reach * 0.95 * Math.cos(radians),
          y: middle.y + reach * 0.95 * Math.sin(radians),
        };
        expect(handleUnder(press, places, middle, reach), `${width} x ${height} px at ${angle} degrees`).toBeNull();
      }
    }
  });

  it("stand on it where it is large enough", () => {
    expect(placesOf(300, 200, FINGER_REACH).get("ne")).toMatchObject({ x: 350, y: 200 });
    expect(placesOf(300, 200, FINGER_REACH).get("e")).toMatchObject({ x: 350, y: 300 });
  });

  it("leave out an edge's where a finger could not tell it from the corners", () => {
    expect([...placesOf(70, 70, FINGER_REACH).keys()].sort()).toEqual(["ne", "nw", "se", "sw"]);
    expect(placesOf(70, 70, MOUSE_REACH).size).toBe(8);
  });

  it("are each caught where they stand", () => {
    for (const reach of [FINGER_REACH, MOUSE_REACH]) {
      for (const [name, place] of placesOf(60, 90, reach)) {
        expect(handleUnder(place, placesOf(60, 90, reach), middle, reach)).toBe(name);
        expect(distance(place, middle)).toBeGreaterThanOrEqual(2 * reach - 1e-9);
      }
    }
  });
});

describe("a press between two handles", () => {
  const handles = [
    ["corner", { x: 0, y: 0 }],
    ["depth", { x: 20, y: 0 }],
  ] as const;

  it("takes the nearer one, whichever is drawn on top", () => {
    expect(handleUnder({ x: 9, y: 0 }, handles, null, 22)).toBe("corner");
    expect(handleUnder({ x: 11, y: 0 }, handles, null, 22)).toBe("depth");
  });

  it("takes none out of reach", () => {
    expect(handleUnder({ x: 44, y: 0 }, handles, null, 22)).toBeNull();
  });

  it("takes the decal where its middle is nearer than both", () => {
    expect(handleUnder({ x: 10, y: 6 }, handles, { x: 10, y: 8 }, 22)).toBeNull();
  });
});
