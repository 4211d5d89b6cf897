import { Ray, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { decalsAt, planeHit, rectangleHit } from "../../web/viewer/decal-picking.ts";
import { projectorOf } from "../../web/viewer/decal-pose.ts";
import type { SurfaceSample } from "../../web/viewer/surface-query.ts";
import type { ViewerDecal } from "../../web/viewer/viewer-api.ts";
import { expectVector, poseAt } from "./pose-helpers.ts";

function decal(id: string, changes: Partial<ViewerDecal> = {}): ViewerDecal {
  const projector = projectorOf(poseAt({ size: [1, 1, 0.5] }));
  return { id, name: id, materials: [0], visible: true, aspect: 1, projector, ...changes };
}

function sample(x: number, y: number, normal = new Vector3(0, 0, 1)): SurfaceSample {
  return { position: new Vector3(x, y, 0), normal, distance: 1, triangle: 0, face: 0, material: 0, uv: [0, 0] };
}

describe("the decals under a point", () => {
  it("come topmost first, the list being bottom to top", () => {
    expect(decalsAt([decal("under"), decal("over")], sample(0, 0)).map(({ id }) => id)).toEqual(["over", "under"]);
  });

  it("are those whose box holds the point", () => {
    expect(decalsAt([decal("here")], sample(0.6, 0))).toEqual([]);
  });

  it("are not those on the other side of the surface", () => {
    expect(decalsAt([decal("front")], sample(0, 0, new Vector3(0, 0, -1)))).toEqual([]);
  });

  it("are not hidden ones, nor those of another material", () => {
    expect(decalsAt([decal("hidden", { visible: false }), decal("other", { materials: [1] })], sample(0, 0))).toEqual(
      [],
    );
  });
});

describe("a box's rectangle", () => {
  const pose = poseAt({ position: [0, 0, 1], size: [1, 0.5, 0.2] });

  it("is met from the front, within its width and height", () => {
    const hit = rectangleHit(pose, new Ray(new Vector3(0.4, 0.2, 5), new Vector3(0, 0, -1)));
    expectVector(hit as Vector3, new Vector3(0.4, 0.2, 1));
    expect(rectangleHit(pose, new Ray(new Vector3(0.4, 0.3, 5), new Vector3(0, 0, -1)))).toBeNull();
  });

  it("is not met from behind", () => {
    expect(rectangleHit(pose, new Ray(new Vector3(0, 0, -5), new Vector3(0, 0, 1)))).toBeNull();
  });

  it("has a plane that can be raised to where a handle is", () => {
    const hit = planeHit(pose, 0.25, new Ray(new Vector3(3, 0, 5), new Vector3(0, 0, -1)));
    expectVector(hit as Vector3, new Vector3(3, 0, 1.25));
  });

  it("is not met at grazing angles, where a pixel would be worth metres", () => {
    const grazing = new Vector3(1, 0, -0.02).normalize();
    expect(planeHit(pose, 0, new Ray(new Vector3(-5, 0, 1.1), grazing))).toBeNull();
  });
});
