import { Ray, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type {
  CylindricalProjector,
  PerspectiveProjector,
  Projector,
  UvProjector,
} from "../../web/engine/engine-api.ts";
import { nudged, pictureDrag } from "../../web/viewer/projector-drag.ts";
import { pictureBox, throwOutline, volumeEdges } from "../../web/viewer/projector-outline.ts";
import { toView } from "../../web/viewer/projector-sight.ts";
import type { SurfaceQuery, SurfaceSample } from "../../web/viewer/surface-query.ts";
import { expectVector } from "./pose-helpers.ts";
import { cylinder, queryOf } from "./surface-helpers.ts";

const view = { right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };
const eye = new Vector3(0, 0, 6);
const slide: PerspectiveProjector = {
  kind: "perspective",
  position: [1, 1, 4],
  rotation: [-0.1, 0.1, 0.02, 1],
  fov: 20,
  aspect: 1,
  near: 0.5,
  far: 100,
};
const label: CylindricalProjector = {
  kind: "cylindrical",
  position: [0, 0.1, 0],
  rotation: [0, 0.1, 0, 1],
  radius: 1,
  height: 0.5,
  arc: 90,
  depth: 0.2,
};
const stamp: UvProjector = { kind: "uv", center: [0.5, 0.5], size: [0.2, 0.1], angle: 30 };

function pointerAt(x: number, y: number) {
  return { ray: new Ray(eye.clone(), new Vector3(x, y, 1).sub(eye).normalize()), alt: false, shift: false };
}
function surfaceAt(query: SurfaceQuery, x: number, y: number): SurfaceSample {
  const { ray } = pointerAt(x, y);
  return query.raycast(ray.origin, ray.direction) as SurfaceSample;
}

describe("dragging a picture", () => {
  const query = queryOf(cylinder());

  it("swings a slide so that the grabbed point keeps under the pointer, the eye where it is", () => {
    const grab = surfaceAt(query, 0.1, 0.2);
    const moved = pictureDrag(query, slide, grab).move(pointerAt(-0.3, -0.1)) as PerspectiveProjector;
    expect(moved).toMatchObject({ position: slide.position, fov: slide.fov });
    const before = toView(slide, grab.position);
    const after = toView(moved, surfaceAt(query, -0.3, -0.1).position);
    expect(after.x / after.z).toBeCloseTo(before.x / before.z, 9);
    expect(after.y / after.z).toBeCloseTo(before.y / before.z, 9);
  });

  it("turns a label round its axis and moves it along, and not off it", () => {
    const grab = surfaceAt(query, 0.1, 0.2);
    const moved = pictureDrag(query, label, grab).move(pointerAt(-0.5, -0.1)) as CylindricalProjector;
    expectVector(toView(moved, surfaceAt(query, -0.5, -0.1).position), toView(label, grab.position), 1e-3);
    expect(moved.position[0]).toBeCloseTo(0, 12);
    expect(moved.position[2]).toBeCloseTo(0, 12);
    expect(moved.radius).toBe(label.radius);
  });

  it("moves a stamp by the texture under the pointer", () => {
    const grab = surfaceAt(query, 0.1, 0.2);
    const target = surfaceAt(query, -0.3, 0.4);
    const moved = pictureDrag(query, stamp, grab).move(pointerAt(-0.3, 0.4)) as UvProjector;
    expect(moved.center[0] - 0.5).toBeCloseTo(target.uv[0] - grab.uv[0], 12);
    expect(moved.center[1] - 0.5).toBeCloseTo(target.uv[1] - grab.uv[1], 12);
    expect(moved).toMatchObject({ size: stamp.size, angle: 30 });
  });

  it("says nothing beside the model", () => {
    for (const projector of [slide, label, stamp]) {
      expect(pictureDrag(query, projector, surfaceAt(query, 0, 0)).move(pointerAt(9, 0))).toBeNull();
    }
  });
});

describe("nudging", () => {
  it("moves an eye beside itself, a label round and along its axis, a stamp in its texture", () => {
    expect(nudged(slide, view, 0.5, 0.25, 4)).toEqual({ ...slide, position: [1.5, 1.25, 4] });
    const turned = nudged({ ...label, rotation: [0, 0, 0, 1] }, view, 0.2, 0.3, 4) as CylindricalProjector;
    expect(turned.position).toEqual([0, expect.closeTo(0.4, 12), 0]);
    expect(turned.rotation[1]).toBeCloseTo(Math.sin(0.1), 12);
    const shifted = nudged(stamp, view, 1, 0.5, 4) as UvProjector;
    expect(shifted.center).toEqual([0.75, 0.375]);
  });
});

describe("the lines of a projector", () => {
  const query = queryOf(cylinder());

  it("lay a label's and a slide's border on the surface", () => {
    for (const projector of [label, { ...slide, rotation: [-0.12, 0.12, 0, 1] } as const]) {
      const outline = throwOutline(query, projector);
      expect(outline).toHaveLength(80);
      for (const { position, onSurface } of outline) {
        expect(onSurface).toBe(true);
        expect(Math.hypot(position.x, position.z)).toBeCloseTo(1, 2);
      }
    }
  });

  it("are finite where the rays meet nothing, and draw none for a stamp", () => {
    const away: Projector[] = [
      { ...slide, rotation: [0, 1, 0, 0] },
      { ...label, position: [9, 0, 0] },
      { ...label, depth: 5 },
    ];
    for (const projector of away as (PerspectiveProjector | CylindricalProjector)[]) {
      const points = [
        ...throwOutline(query, projector).map(({ position }) => position),
        ...volumeEdges(query, projector).flat(),
      ];
      for (const point of points) expect(Number.isFinite(point.lengthSq())).toBe(true);
    }
    expect(throwOutline(query, stamp)).toEqual([]);
    expect(volumeEdges(query, stamp)).toEqual([]);
  });

  it("end a slide's pyramid behind the model, however far it reaches", () => {
    const farthest = Math.max(...volumeEdges(query, slide).flatMap((edge) => edge.map((point) => point.length())));
    expect(farthest).toBeLessThan(10);
  });

  it("give the camera a box to look at", () => {
    const box = pictureBox(query, label);
    expect(box?.position.length()).toBeCloseTo(Math.hypot(1, 0.1), 2);
    expect(box?.size.x).toBeCloseTo(Math.SQRT2, 6);
    expect(pictureBox(query, stamp)).toBeNull();
  });
});
