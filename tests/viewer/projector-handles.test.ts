import { Ray, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { CylindricalProjector, PerspectiveProjector } from "../../web/engine/engine-api.ts";
import { pictureRay } from "../../web/viewer/picture-ray.ts";
import { thrownHandleDrag } from "../../web/viewer/projector-handles.ts";
import { toView } from "../../web/viewer/projector-sight.ts";
import { expectVector, radians, slideSpot } from "./pose-helpers.ts";

const LIMITS = { least: 0.001, most: 10 };
const slide: PerspectiveProjector = {
  kind: "perspective",
  position: [0, 0, 4],
  rotation: [0, 0, 0, 1],
  fov: 20,
  aspect: 2,
  near: 1,
  far: 8,
};
const label: CylindricalProjector = {
  kind: "cylindrical",
  position: [0, 0.2, 0],
  rotation: [0, 0, 0, 1],
  radius: 1,
  height: 0.5,
  arc: 60,
  depth: 0.1,
};

/** A pointer that looks from a place beside the eye at a point of the model. */
function pointerTo(point: Vector3, options: { alt?: boolean; shift?: boolean; eye?: Vector3 } = {}) {
  const eye = options.eye ?? new Vector3(0.5, 0.3, 6);
  const ray = new Ray(eye, point.clone().sub(eye).normalize());
  return { ray, alt: options.alt ?? false, shift: options.shift ?? false };
}
/** Where the slide's picture, from its middle, falls on the plane through the origin. */
const onScreen = (x: number, y: number): Vector3 => {
  const ray = pictureRay(slide, x, y);
  if (ray === null) throw new Error("A slide has rays.");
  return ray.origin.addScaledVector(ray.direction, (ray.origin.z - 0) / -ray.direction.z);
};
const onMug = (degrees: number, height: number): Vector3 =>
  new Vector3(Math.sin(radians(degrees)), height, Math.cos(radians(degrees)));

describe("the handles of a picture thrown from an eye", () => {
  it("a corner follows the pointer, the picture's proportions and its middle stay", () => {
    const corner = onScreen(0.5, 0.5);
    const drag = thrownHandleDrag(slide, "ne", corner, pointerTo(corner).ray, LIMITS);
    const target = corner.clone().multiplyScalar(1.5);
    const moved = drag?.move(pointerTo(target)) as PerspectiveProjector;
    expect(moved).toMatchObject({ position: slide.position, rotation: slide.rotation, aspect: 2 });
    expect(slideSpot(moved, target)?.x).toBeCloseTo(0.5, 6);
    expect(slideSpot(moved, target)?.y).toBeCloseTo(0.5, 6);
  });

  it("an edge changes its own side alone", () => {
    const edge = onScreen(0.5, 0);
    const drag = thrownHandleDrag(slide, "e", edge, pointerTo(edge).ray, LIMITS);
    const wider = drag?.move(pointerTo(edge.clone().multiplyScalar(2))) as PerspectiveProjector;
    expect(wider.fov).toBeCloseTo(20, 9);
    expect(wider.aspect).toBeCloseTo(4, 6);
    const top = onScreen(0, 0.5);
    const higher = thrownHandleDrag(slide, "n", top, pointerTo(top).ray, LIMITS)?.move(
      pointerTo(top.clone().multiplyScalar(2)),
    ) as PerspectiveProjector;
    expect(Math.tan(radians(higher.fov) / 2)).toBeCloseTo(2 * Math.tan(radians(10)), 6);
    expect(higher.aspect).toBeCloseTo(1, 6);
  });

  it("the knob turns it about the way it looks, with Shift in steps of 15°", () => {
    const top = onScreen(0, 0.5);
    const side = new Vector3(-top.y, top.x, 0);
    const drag = thrownHandleDrag(slide, "rotate", top, pointerTo(top).ray, LIMITS);
    const turned = drag?.move(pointerTo(side)) as PerspectiveProjector;
    expect(turned.rotation[2]).toBeCloseTo(Math.SQRT1_2, 6);
    const snapped = drag?.move(pointerTo(side.clone().add(new Vector3(0, 0.05, 0)), { shift: true }));
    expect((snapped as PerspectiveProjector).rotation[2]).toBeCloseTo(Math.SQRT1_2, 6);
  });

  it("near and far follow the pointer along the eye's axis and do not pass each other", () => {
    const at = (z: number) => pointerTo(new Vector3(0, 0, z), { eye: new Vector3(5, 0, 0) });
    const near = thrownHandleDrag(slide, "near", new Vector3(), at(3).ray, LIMITS);
    expect(near?.move(at(2))).toMatchObject({ near: expect.closeTo(2, 6) });
    const pushed = near?.move(at(-50)) as PerspectiveProjector;
    expect(pushed.near).toBeLessThan(pushed.far);
    const far = thrownHandleDrag(slide, "far", new Vector3(), at(-4).ray, LIMITS);
    expect(far?.move(at(-1))).toMatchObject({ far: expect.closeTo(5, 6) });
  });
});

describe("the handles of a label", () => {
  it("an end of its arc follows the pointer round, and the other end stays", () => {
    const drag = thrownHandleDrag(label, "e", onMug(30, 0.2), pointerTo(onMug(30, 0.2)).ray, LIMITS);
    const grown = drag?.move(pointerTo(onMug(50, 0.2))) as CylindricalProjector;
    expect(grown.arc).toBeCloseTo(80, 6);
    const other = toView(grown, onMug(-30, 0.2));
    expect(Math.atan2(other.x, other.z)).toBeCloseTo(radians(-40), 6);
  });

  it("with Alt both ends move", () => {
    const drag = thrownHandleDrag(label, "e", onMug(30, 0.2), pointerTo(onMug(30, 0.2)).ray, LIMITS);
    const grown = drag?.move(pointerTo(onMug(40, 0.2), { alt: true })) as CylindricalProjector;
    expect(grown.arc).toBeCloseTo(80, 6);
    expect(grown.rotation).toEqual(label.rotation);
  });

  it("top and bottom change its height, a corner both in proportion", () => {
    const high = thrownHandleDrag(label, "n", onMug(0, 0.45), pointerTo(onMug(0, 0.45)).ray, LIMITS)?.move(
      pointerTo(onMug(0, 0.65)),
    ) as CylindricalProjector;
    expect(high.height).toBeCloseTo(0.7, 6);
    expectVector(new Vector3(...high.position), new Vector3(0, 0.3, 0), 1e-6);
    const whole = thrownHandleDrag(label, "ne", onMug(30, 0.45), pointerTo(onMug(30, 0.45)).ray, LIMITS)?.move(
      pointerTo(onMug(45, 0.575)),
    ) as CylindricalProjector;
    expect(whole.arc / label.arc).toBeCloseTo(whole.height / label.height, 6);
    expect(whole.arc).toBeGreaterThan(65);
  });

  it("is never longer than all the way round", () => {
    const wide = { ...label, arc: 350 };
    const drag = thrownHandleDrag(wide, "e", onMug(0, 0.2), pointerTo(onMug(0, 0.2)).ray, LIMITS);
    expect(drag?.move(pointerTo(onMug(40, 0.2)))).toMatchObject({ arc: 360 });
  });

  it("comes off its cylinder as wide as it was", () => {
    const at = (x: number) => pointerTo(new Vector3(0, 0.2, x), { eye: new Vector3(5, 0.2, 0) });
    const moved = thrownHandleDrag(label, "depth", new Vector3(), at(1).ray, LIMITS)?.move(at(1.5));
    expect(moved).toMatchObject({ radius: expect.closeTo(1.5, 6), arc: expect.closeTo(40, 6) });
  });

  it("its axis is turned about the way to its middle", () => {
    const above = new Vector3(0, 0.7, 1);
    const aside = new Vector3(-0.5, 0.2, 1);
    const drag = thrownHandleDrag(label, "rotate", above, pointerTo(above).ray, LIMITS);
    const turned = drag?.move(pointerTo(aside)) as CylindricalProjector;
    expect(turned.position).toEqual(label.position);
    expect(turned.rotation[2]).toBeCloseTo(Math.SQRT1_2, 6);
  });
});
