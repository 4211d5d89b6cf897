import { describe, expect, it } from "vitest";
import { projectorFields } from "../../web/editor/panels/projector-fields.ts";
import { scaledProjector, spunProjector } from "../../web/editor/state/projector-steps.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import type { CylindricalProjector, PerspectiveProjector, UvProjector } from "../../web/engine/engine-api.ts";

const slide: PerspectiveProjector = {
  kind: "perspective",
  position: [0, 0, 2],
  rotation: [0, 0, 0, 1],
  fov: 60,
  aspect: 1.5,
  near: 0.1,
  far: 5,
};
const label: CylindricalProjector = {
  kind: "cylindrical",
  position: [0, 0, 0],
  rotation: [0, 0, 0, 1],
  radius: 1,
  height: 0.5,
  arc: 300,
  depth: 0.2,
};
const stamp: UvProjector = { kind: "uv", center: [0.5, 0.5], size: [0.25, 0.5], angle: 170 };

describe("scaling by the keyboard", () => {
  it("widens a slide by its picture, and not to half a turn and beyond", () => {
    const wider = scaledProjector(slide, 1.1);
    expect(Math.tan((wider.fov * Math.PI) / 360)).toBeCloseTo(1.1 * Math.tan(Math.PI / 6), 12);
    expect(scaledProjector(slide, 1e6).fov).toBe(175);
    expect(scaledProjector({ ...slide, fov: 175 }, 0.5).fov).toBeLessThan(175);
  });

  it("makes a label longer and higher, up to the whole way round", () => {
    expect(scaledProjector(label, 1.1)).toEqual({
      ...label,
      arc: expect.closeTo(330, 9),
      height: expect.closeTo(0.55, 9),
    });
    expect(scaledProjector(label, 2).arc).toBe(360);
  });

  it("scales a stamp in its texture", () => {
    expect(scaledProjector(stamp, 2)).toEqual({ ...stamp, size: [0.5, 1] });
  });
});

describe("turning by the keyboard", () => {
  it("is counter-clockwise for every kind, as the viewer sees it", () => {
    expect(spunProjector(stamp, 30)).toEqual({ ...stamp, angle: 140 });
    expect(spunProjector(stamp, -30).angle).toBe(-160);
    expect(spunProjector(slide, 90).rotation[2]).toBeCloseTo(Math.SQRT1_2, 12);
  });
});

describe("the fields of a projector", () => {
  const fieldsOf = (projector: PerspectiveProjector | CylindricalProjector | UvProjector) =>
    projectorFields(projector, 0.01, stringsIn("en").properties).flatMap(({ fields }) => fields);

  it.each([slide, label, stamp])("show every number of a $kind projector once, and change that one", (projector) => {
    const numbers = Object.entries(projector).filter(([key]) => !["kind", "position", "rotation"].includes(key));
    const fields = fieldsOf(projector);
    expect(fields.map(({ value }) => value).sort()).toEqual(numbers.flatMap(([, value]) => value).sort());
    expect(new Set(fields.map(({ name }) => name)).size).toBe(fields.length);
    for (const { value, set } of fields) expect(set(value)).toEqual(projector);
  });

  it("keep near below far, whichever is changed", () => {
    const [, , near, far] = fieldsOf(slide);
    expect(near?.set(7)).toMatchObject({ near: 7, far: expect.closeTo(7.001, 9) });
    expect(far?.set(0.05)).toMatchObject({ near: expect.closeTo(0.049, 9), far: 0.05 });
    expect(far?.set(3)).toMatchObject({ near: 0.1, far: 3 });
    const [, , passing, back] = projectorFields(
      { ...slide, near: 7, far: 7.001 },
      0.01,
      stringsIn("en").properties,
      slide,
    ).flatMap(({ fields }) => fields);
    expect(passing?.set(1), "what is passed by a scrub leaves no trace").toMatchObject({ near: 1, far: 5 });
    expect(back?.set(6)).toMatchObject({ near: 0.1, far: 6 });
    const furthest = near?.set(5e8);
    if (furthest?.kind !== "perspective") throw new Error("It is no slide any more.");
    expect(Math.fround(furthest.far), "in the engine's numbers too").toBeGreaterThan(Math.fround(furthest.near));
  });
});
