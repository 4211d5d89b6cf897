import { Quaternion, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import {
  axisOf,
  boxCorners,
  containsPoint,
  type DecalPose,
  facesNormal,
  fromLocal,
  minimalRotation,
  poseOf,
  projectorOf,
  rollOf,
  toLocal,
  uprightFrame,
} from "../../web/viewer/decal-pose.ts";
import { expectVector, poseAt, radians } from "./pose-helpers.ts";

describe("a decal's pose", () => {
  it("goes to a projector and back unchanged", () => {
    const pose = poseAt({ position: [1, 2, 3], turn: radians(30), axis: [0, 1, 0], size: [0.2, 0.1, 0.05] });
    const back = poseOf(projectorOf(pose));
    expectVector(back.position, pose.position);
    expect(back.rotation.angleTo(pose.rotation)).toBeLessThan(1e-6);
    expectVector(back.size, pose.size);
  });

  it("normalises a quaternion that a document holds with rounding", () => {
    const pose = poseOf({ kind: "planar", position: [0, 0, 0], rotation: [0, 0.7, 0, 0.7], size: [1, 1, 1] });
    expect(pose.rotation.length()).toBeCloseTo(1, 12);
  });

  it("carries points into its metric frame and out again", () => {
    const pose = poseAt({ position: [4, -1, 2], turn: 1.1, axis: [1, 2, 3], size: [1, 2, 3] });
    const point = new Vector3(0.3, -0.8, 5);
    expectVector(toLocal(pose, fromLocal(pose, 0.3, -0.8, 5)), point);
  });

  it("contains the points of its box and none beyond a face", () => {
    const pose = poseAt({ position: [0, 1, 0], turn: radians(90), axis: [0, 1, 0], size: [2, 1, 0.5] });
    expect(containsPoint(pose, new Vector3(0.24, 1.49, 0.99))).toBe(true);
    expect(containsPoint(pose, new Vector3(0.26, 1, 0))).toBe(false);
    expect(containsPoint(pose, new Vector3(0, 1.51, 0))).toBe(false);
    expect(containsPoint(pose, new Vector3(0, 1, 1.01))).toBe(false);
  });

  it("faces the surface whose normal looks along its +Z", () => {
    const pose = poseAt({ turn: radians(90), axis: [0, 1, 0] });
    expectVector(axisOf(pose, 2), new Vector3(1, 0, 0));
    expect(facesNormal(pose, new Vector3(1, 0, 0.2).normalize())).toBe(true);
    expect(facesNormal(pose, new Vector3(-1, 0, 0))).toBe(false);
  });

  it("has eight corners at half its size", () => {
    const pose: DecalPose = poseAt({ size: [2, 4, 6] });
    const corners = boxCorners(pose);
    expect(corners).toHaveLength(8);
    expectVector(corners[0] as Vector3, new Vector3(-1, -2, -3));
    expectVector(corners[1] as Vector3, new Vector3(1, -2, -3));
    expectVector(corners[7] as Vector3, new Vector3(1, 2, 3));
  });
});

describe("the shortest turn between two normals", () => {
  it("takes one to the other without any spin about them", () => {
    const from = new Vector3(0, 0, 1);
    const to = new Vector3(1, 1, 1).normalize();
    const turn = minimalRotation(from, to);
    expectVector(from.clone().applyQuaternion(turn), to);
    const axis = new Vector3(turn.x, turn.y, turn.z);
    expect(axis.dot(from)).toBeCloseTo(0, 12);
    expect(axis.dot(to)).toBeCloseTo(0, 12);
  });

  it("keeps up upright when the normals are opposite", () => {
    const turn = minimalRotation(new Vector3(0, 0, 1), new Vector3(0, 0, -1));
    expectVector(new Vector3(0, 1, 0).applyQuaternion(turn), new Vector3(0, 1, 0));
    expectVector(new Vector3(0, 0, 1).applyQuaternion(turn), new Vector3(0, 0, -1));
  });

  it("is defined for opposite vertical normals too", () => {
    const turn = minimalRotation(new Vector3(0, 1, 0), new Vector3(0, -1, 0));
    expectVector(new Vector3(0, 1, 0).applyQuaternion(turn), new Vector3(0, -1, 0));
  });
});

describe("upright", () => {
  it("stands +Y as near to the model's up as the surface lets it", () => {
    const normal = new Vector3(0, 0.6, 0.8);
    const frame = uprightFrame(normal) as Quaternion;
    expectVector(new Vector3(0, 0, 1).applyQuaternion(frame), normal);
    expectVector(new Vector3(0, 1, 0).applyQuaternion(frame), new Vector3(0, 0.8, -0.6));
  });

  it("does not exist on a floor", () => {
    expect(uprightFrame(new Vector3(0, 1, 0))).toBeNull();
  });

  it.each([0, 15, 90, -135, 180])("gives back a roll of %i degrees about the box's own +Z", (degrees) => {
    const frame = uprightFrame(new Vector3(0.3, 0.4, 0.866).normalize()) as Quaternion;
    const rolled = frame.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), radians(degrees)));
    expect(Math.cos(rollOf(rolled))).toBeCloseTo(Math.cos(radians(degrees)), 9);
    expect(Math.sin(rollOf(rolled))).toBeCloseTo(Math.sin(radians(degrees)), 9);
  });

  it("measures the roll on a floor from the picture's top pointing away from the viewer at +Z", () => {
    const lying = new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -Math.PI / 2);
    expect(rollOf(lying)).toBeCloseTo(0, 9);
  });
});
