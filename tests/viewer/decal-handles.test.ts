import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { deepenByHandle, rotateByHandle, scaleByHandle } from "../../web/viewer/decal-handles.ts";
import { fromLocal, rollOf } from "../../web/viewer/decal-pose.ts";
import { expectVector, poseAt, radians } from "./pose-helpers.ts";

const limits = { least: 0.001, most: 100 };
const start = poseAt({ position: [1, 2, 3], turn: radians(40), axis: [1, 1, 0], size: [0.4, 0.2, 0.1] });

describe("a corner handle", () => {
  it.each([
    [1, 1],
    [-1, 1],
    [1, -1],
    [-1, -1],
  ] as const)("at (%i, %i) keeps the opposite corner fixed", (x, y) => {
    const scaled = scaleByHandle(start, { x, y }, { x: 0.07 * x, y: -0.01 * y }, false, limits);
    const before = fromLocal(start, (-x * start.size.x) / 2, (-y * start.size.y) / 2, 0);
    const after = fromLocal(scaled, (-x * scaled.size.x) / 2, (-y * scaled.size.y) / 2, 0);
    expectVector(after, before);
    expect(scaled.size.x).toBeGreaterThan(start.size.x);
  });

  it("keeps the box's proportions, depth included", () => {
    const scaled = scaleByHandle(start, { x: 1, y: 1 }, { x: 0.4, y: 0.2 }, false, limits);
    expectVector(scaled.size, new Vector3(0.8, 0.4, 0.2));
  });

  it("follows the pointer when it moves along the diagonal", () => {
    const scaled = scaleByHandle(start, { x: 1, y: 1 }, { x: 0.1, y: 0.05 }, false, limits);
    expectVector(fromLocal(scaled, scaled.size.x / 2, scaled.size.y / 2, 0), fromLocal(start, 0.3, 0.15, 0));
  });

  it("scales about the centre on request, and still follows the pointer", () => {
    const scaled = scaleByHandle(start, { x: 1, y: 1 }, { x: 0.1, y: 0.05 }, true, limits);
    expectVector(scaled.position, start.position);
    expectVector(scaled.size, new Vector3(0.6, 0.3, 0.15));
  });

  it("stops at the least size and never turns the box inside out", () => {
    const scaled = scaleByHandle(start, { x: 1, y: 1 }, { x: -5, y: -5 }, false, limits);
    expect(scaled.size.y).toBeCloseTo(limits.least, 12);
    expect(scaled.size.x / scaled.size.y).toBeCloseTo(2, 9);
  });
});

describe("an edge handle", () => {
  it("changes one axis and keeps the opposite edge fixed", () => {
    const scaled = scaleByHandle(start, { x: 0, y: -1 }, { x: 0.9, y: -0.1 }, false, limits);
    expectVector(scaled.size, new Vector3(0.4, 0.3, 0.1), 1e-12);
    expectVector(fromLocal(scaled, 0, 0.15, 0), fromLocal(start, 0, 0.1, 0));
  });

  it("grows both ways about the centre on request", () => {
    const scaled = scaleByHandle(start, { x: 1, y: 0 }, { x: 0.1, y: 0 }, true, limits);
    expectVector(scaled.size, new Vector3(0.6, 0.2, 0.1), 1e-12);
    expectVector(scaled.position, start.position);
  });

  it("stops at the largest size", () => {
    const scaled = scaleByHandle(start, { x: 1, y: 0 }, { x: 1e6, y: 0 }, false, limits);
    expect(scaled.size.x).toBe(limits.most);
  });
});

describe("the rotate handle", () => {
  it("turns about the box's own +Z alone", () => {
    const turned = rotateByHandle(start, radians(33), null);
    expectVector(turned.position, start.position);
    expectVector(
      new Vector3(0, 0, 1).applyQuaternion(turned.rotation),
      new Vector3(0, 0, 1).applyQuaternion(start.rotation),
    );
    expect(rollOf(turned.rotation) - rollOf(start.rotation)).toBeCloseTo(radians(33), 9);
  });

  it("snaps the roll against upright, not the distance turned", () => {
    const askew = rotateByHandle(poseAt({}), radians(7), null);
    const snapped = rotateByHandle(askew, radians(10), radians(15));
    expect(rollOf(snapped.rotation)).toBeCloseTo(radians(15), 9);
  });
});

describe("the depth handle", () => {
  it("moves the near face with the pointer and mirrors it behind, so that the centre stays on the surface", () => {
    const deeper = deepenByHandle(start, 0.05, limits);
    expectVector(deeper.size, new Vector3(0.4, 0.2, 0.2), 1e-12);
    expectVector(deeper.position, start.position);
  });

  it("does not make a picture's box so thin that a stripe is left of it", () => {
    expect(deepenByHandle(start, -1, limits).size.z).toBeCloseTo(0.05, 12);
  });

  it("leaves a box that is thinner already as thin as it is", () => {
    const thin = poseAt({ size: [0.4, 0.2, 0.01] });
    expect(deepenByHandle(thin, -1, limits).size.z).toBe(0.01);
    expect(deepenByHandle(thin, 0.01, limits).size.z).toBeCloseTo(0.03, 12);
  });
});
