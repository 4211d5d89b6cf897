import { Quaternion, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { axisOf, type DecalPose, fromLocal, rollOf, type SurfacePoint, toLocal } from "../../web/viewer/decal-pose.ts";
import { DecalSlide } from "../../web/viewer/decal-slide.ts";
import { expectVector, poseAt, radians } from "./pose-helpers.ts";

/** A point of an upright cylinder of radius 1 at `angle` from +Z towards +X. */
function onCylinder(angle: number, height: number): SurfacePoint {
  const normal = new Vector3(Math.sin(angle), 0, Math.cos(angle));
  return { position: normal.clone().setY(height), normal };
}

/** A point of a unit sphere; latitude up from the equator. */
function onSphere(longitude: number, latitude: number): SurfacePoint {
  const normal = new Vector3(
    Math.sin(longitude) * Math.cos(latitude),
    Math.sin(latitude),
    Math.cos(longitude) * Math.cos(latitude),
  );
  return { position: normal.clone(), normal };
}

function slideAlong(slide: DecalSlide, points: SurfacePoint[]): DecalPose {
  return points.map((point) => slide.step(point)).at(-1) as DecalPose;
}

describe("sliding a decal", () => {
  it("keeps the grabbed point of the picture under the pointer at every step", () => {
    const start = poseAt({ position: [0, 0, 1], size: [0.5, 0.5, 0.2] });
    const grab = onCylinder(radians(10), 0.1);
    const grabLocal = toLocal(start, grab.position);
    const slide = new DecalSlide(start, grab);
    for (let degrees = 10; degrees <= 300; degrees += 7) {
      const target = onCylinder(radians(degrees), 0.1 + degrees / 500);
      const pose = slide.step(target);
      expectVector(toLocal(pose, target.position), grabLocal);
    }
  });

  it("changes nothing when the pointer returns to where it took hold", () => {
    const start = poseAt({ position: [0.1, 0, 1], turn: radians(20), axis: [0.2, 0.3, 1] });
    const grab = onSphere(radians(12), radians(8));
    const back = slideAlong(new DecalSlide(start, grab), [onSphere(1, 0.2), onSphere(0.5, -0.4), grab]);
    expectVector(back.position, start.position);
    expect(back.rotation.angleTo(start.rotation)).toBeLessThan(1e-6);
  });

  it("comes back upright after going round a cylinder", () => {
    const start = poseAt({ position: [0, 0, 1], turn: radians(15), axis: [0, 0, 1] });
    const slide = new DecalSlide(start, onCylinder(0, 0));
    const steps = Array.from({ length: 72 }, (_, step) => onCylinder(radians((step + 1) * 5), 0));
    const end = slideAlong(slide, steps);
    expect(end.rotation.angleTo(start.rotation)).toBeLessThan(1e-6);
    expectVector(end.position, start.position, 1e-6);
  });

  it("stands as upright behind a cylinder as in front of it", () => {
    const slide = new DecalSlide(poseAt({ position: [0, 0, 1] }), onCylinder(0, 0));
    const behind = slide.step(onCylinder(Math.PI, 0));
    expectVector(axisOf(behind, 1), new Vector3(0, 1, 0), 1e-6);
    expectVector(axisOf(behind, 2), new Vector3(0, 0, -1), 1e-6);
  });

  it("keeps the picture's own tilt when it goes round a sphere off the equator", () => {
    const tilt = radians(25);
    const start = poseAt({ position: [0, 0, 1], turn: tilt, axis: [0, 0, 1] });
    const slide = new DecalSlide(start, onSphere(0, 0));
    const lap = Array.from({ length: 60 }, (_, step) => onSphere(radians(step * 6), radians(35)));
    for (const point of lap) {
      expect(rollOf(slide.step(point).rotation)).toBeCloseTo(tilt, 6);
    }
  });

  it("does not spin where the surface is level", () => {
    const up = new Vector3(0, 1, 0);
    const start: DecalPose = {
      position: new Vector3(0, 1, 0),
      rotation: new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -Math.PI / 2),
      size: new Vector3(1, 1, 1),
    };
    const slide = new DecalSlide(start, { position: new Vector3(0, 1, 0), normal: up });
    const end = slideAlong(slide, [
      { position: new Vector3(2, 1, 0), normal: up },
      { position: new Vector3(2, 1, 5), normal: up },
    ]);
    expect(end.rotation.angleTo(start.rotation)).toBeLessThan(1e-6);
    expectVector(end.position, new Vector3(2, 1, 5));
  });

  it("folds over an edge by the shortest turn: from the front onto the top, the picture's top points backwards", () => {
    const slide = new DecalSlide(poseAt({ position: [0, 0, 1] }), {
      position: new Vector3(0, 0, 1),
      normal: new Vector3(0, 0, 1),
    });
    const onTop = slide.step({ position: new Vector3(0, 1, 0), normal: new Vector3(0, 1, 0) });
    expectVector(axisOf(onTop, 1), new Vector3(0, 0, -1), 1e-6);
  });

  it("is upright again on the wall behind, after a way over the top", () => {
    const slide = new DecalSlide(poseAt({ position: [0, 0, 1] }), onSphere(0, 0));
    const overTheTop = Array.from({ length: 60 }, (_, step) => onSphere(0, radians((step + 1) * 3)));
    const behind = slideAlong(slide, overTheTop);
    expect(axisOf(behind, 1).y).toBeGreaterThan(0.999);
  });

  it("keeps a lift off the surface that the box had", () => {
    const start = poseAt({ position: [0, 0, 1.3] });
    const slide = new DecalSlide(start, onCylinder(0, 0));
    const aside = slide.step(onCylinder(radians(90), 0));
    expectVector(aside.position, new Vector3(1.3, 0, 0), 1e-9);
    expectVector(fromLocal(aside, 0, 0, -0.3), new Vector3(1, 0, 0), 1e-9);
  });
});
