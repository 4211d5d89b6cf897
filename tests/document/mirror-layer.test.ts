import { Matrix4, Quaternion, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { Mirror, PlanarProjector } from "../../web/editor/document/index.ts";
import { mirroredDabs, mirroredProjector } from "../../web/editor/document/mirror-layer.ts";
import type { EngineDab } from "../../web/engine/engine-api.ts";

const rotation = new Quaternion(0.3, -0.5, 0.2, 0.7).normalize();
const projector: PlanarProjector = {
  kind: "planar",
  position: [0.3, 1.2, -0.4],
  rotation: rotation.toArray() as [number, number, number, number],
  size: [0.2, 0.5, 0.1],
};

const boxOf = (one: PlanarProjector): Matrix4 =>
  new Matrix4().compose(new Vector3(...one.position), new Quaternion(...one.rotation), new Vector3(...one.size));

function reflected(point: Vector3, { axis, offset }: Mirror): Vector3 {
  const image = point.clone();
  image[axis] = 2 * offset - image[axis];
  return image;
}

const CORNERS = [new Vector3(0, 0, 0), new Vector3(0.5, 0.1, 0.2), new Vector3(-0.3, 0.4, -0.5)];

describe("a mirrored projector", () => {
  it.each(["x", "y", "z"] as const)(
    "across %s casts the picture, left and right exchanged, at the mirror image",
    (axis) => {
      const mirror: Mirror = { axis, offset: 0.15, readable: false };
      const twin = mirroredProjector(projector, mirror) as PlanarProjector;
      for (const corner of CORNERS) {
        const exchanged = new Vector3(-corner.x, corner.y, corner.z);
        const image = reflected(corner.clone().applyMatrix4(boxOf(projector)), mirror);
        expect(exchanged.applyMatrix4(boxOf(twin)).distanceTo(image)).toBeLessThan(1e-12);
      }
    },
  );

  it("stays upright where the picture is to be readable", () => {
    const upright: PlanarProjector = { ...projector, rotation: [0, 0, 0, 1] };
    for (const axis of ["x", "y", "z"] as const) {
      const twin = mirroredProjector(upright, { axis, offset: 0, readable: true }) as PlanarProjector;
      expect(new Vector3(0, 1, 0).applyQuaternion(new Quaternion(...twin.rotation)).y).toBeCloseTo(1, 12);
      const toViewer = new Vector3(0, 0, 1).applyQuaternion(new Quaternion(...twin.rotation)).z;
      expect(toViewer).toBeCloseTo(axis === "z" ? -1 : 1, 12);
    }
  });

  it("comes back to itself by the same mirror", () => {
    for (const axis of ["x", "y", "z"] as const) {
      const mirror: Mirror = { axis, offset: 0.7, readable: false };
      const twice = mirroredProjector(mirroredProjector(projector, mirror) as PlanarProjector, mirror);
      expect(
        boxOf(twice as PlanarProjector).elements.every((e, i) => Math.abs(e - boxOf(projector).elements[i]) < 1e-12),
      ).toBe(true);
    }
  });

  it("is none for a flat stamp", () => {
    const stamp = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 } as const;
    expect(mirroredProjector(stamp, { axis: "x", offset: 0, readable: false })).toBeNull();
  });
});

describe("mirrored dabs", () => {
  const dab = (x: number): EngineDab => ({ ...projector, position: [x, 0, 0], flow: 1 });
  const across: Mirror = { axis: "x", offset: 0, readable: false };

  it("follow their own dabs one by one, flipped, and are the same objects each time", () => {
    const dabs = [dab(1), dab(2)];
    const all = mirroredDabs(dabs, [across]);
    expect(all.map((one) => (one.kind === "planar" ? one.position[0] : 0))).toEqual([1, -1, 2, -2]);
    expect(all.map((one) => one.flipX ?? false)).toEqual([false, true, false, true]);
    const more = mirroredDabs([...dabs, dab(3)], [{ ...across }]);
    expect(more.slice(0, 4).every((one, index) => one === all[index])).toBe(true);
  });

  it("by two mirrors are four, of which one is turned round twice", () => {
    const all = mirroredDabs([dab(1)], [across, { axis: "y", offset: 1, readable: false }]);
    expect(all).toHaveLength(4);
    expect(all.map((one) => one.flipX ?? false)).toEqual([false, true, true, false]);
  });

  it("keep their picture where it is to be readable", () => {
    const all = mirroredDabs([dab(1)], [{ ...across, readable: true }]);
    expect(all.map((one) => one.flipX ?? false)).toEqual([false, false]);
  });
});
