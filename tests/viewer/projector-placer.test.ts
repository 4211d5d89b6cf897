import { CylinderGeometry, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type {
  CylindricalProjector,
  PerspectiveProjector,
  PlanarProjector,
  Projector,
  UvProjector,
} from "../../web/engine/engine-api.ts";
import { placeOfPicture } from "../../web/viewer/picture-place.ts";
import { ProjectorPlacer } from "../../web/viewer/projector-placer.ts";
import type { SurfaceQuery } from "../../web/viewer/surface-query.ts";
import { expectVector, radians, slideSpot } from "./pose-helpers.ts";
import { cube, cylinder, queryOf, sheet, sphere } from "./surface-helpers.ts";

const FRONT: PlanarProjector = {
  kind: "planar",
  position: [0, 0.1, 1],
  rotation: [0, 0, 0, 1],
  size: [0.4, 0.2, 0.3],
};
const view = (eye: Vector3) => ({ eye, right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) });
const placerOn = (query: SurfaceQuery, eye = new Vector3(0, 0.1, 5)) =>
  new ProjectorPlacer(query, view(eye), () => null);

describe("a decal thrown from the camera", () => {
  it("covers in the view what the box covered, and reaches past the whole model", () => {
    const eye = new Vector3(0, 0.1, 5);
    const thrown = placerOn(queryOf(sheet()), eye).converted({ ...FRONT, position: [0, 0.1, 0] }, "perspective");
    const slide = thrown as PerspectiveProjector;
    expect(slide).toMatchObject({ kind: "perspective", position: [0, 0.1, 5] });
    expect(slide.aspect).toBeCloseTo(2, 2);
    expect(2 * 5 * Math.tan(radians(slide.fov) / 2)).toBeCloseTo(0.2, 2);
    expect(slide.near).toBeLessThan(5);
    expect(slide.far).toBeGreaterThan(5);
    const spot = slideSpot(slide, new Vector3(0.2, 0.2, 0));
    expect(spot?.x).toBeCloseTo(0.5, 1);
    expect(spot?.y).toBeCloseTo(0.5, 1);
  });

  it("stands as the picture stood in the view, and is squeezed as it was seen", () => {
    const leaned: PlanarProjector = { ...FRONT, position: [0, 0, 0], rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2] };
    const eye = new Vector3(3, 0, 3);
    const slide = placerOn(queryOf(sheet()), eye).converted(leaned, "perspective") as PerspectiveProjector;
    // A quarter turn: the picture's width runs up the model; from half the side its height looks shorter.
    expect(slide.aspect).toBeCloseTo(2 / Math.cos(radians(45)), 1);
  });

  it("is refused for a decal that the camera does not see", () => {
    expect(
      placerOn(queryOf(sheet()), new Vector3(0, 0, -5)).converted({ ...FRONT, position: [0, 0, 0] }, "perspective"),
    ).toBeNull();
  });

  it("taken again from another place keeps its picture's proportions", () => {
    const query = queryOf(cylinder());
    const first = placerOn(query).converted(FRONT, "perspective") as PerspectiveProjector;
    const again = placerOn(query, new Vector3(2, 0.5, 4)).converted(first, "perspective") as PerspectiveProjector;
    expect(again.position).toEqual([2, 0.5, 4]);
    expect(again.aspect).toBeCloseTo(first.aspect, 9);
  });
});

describe("a decal wrapped around", () => {
  it("lies on the cylinder's own radius and axis, as wide and as high as it was", () => {
    const label = placerOn(queryOf(cylinder())).converted(FRONT, "cylindrical") as CylindricalProjector;
    expect(label.radius).toBeCloseTo(1, 2);
    expectVector(new Vector3(...label.position), new Vector3(0, 0.1, 0), 0.01);
    expect(label.radius * radians(label.arc)).toBeCloseTo(0.4, 2);
    expect(label.height).toBeCloseTo(0.2, 6);
    expect(label.rotation[3]).toBeCloseTo(1, 3);
  });

  it("finds a lying cylinder's axis, and its middle from a small decal beside the middle", () => {
    const lying = queryOf(new CylinderGeometry(0.5, 0.5, 3, 96, 24).rotateZ(Math.PI / 2).translate(0, 2, 0));
    const box: PlanarProjector = { ...FRONT, position: [0.6, 2, 0.5], size: [0.1, 0.1, 0.1] };
    const label = placerOn(lying).converted(box, "cylindrical") as CylindricalProjector;
    expect(label.radius).toBeCloseTo(0.5, 2);
    expectVector(new Vector3(...label.position), new Vector3(0.6, 2, 0), 0.01);
  });

  it("takes the middle of a box from its thickness, and lies near its sides", () => {
    const label = placerOn(queryOf(cube())).converted(FRONT, "cylindrical") as CylindricalProjector;
    expectVector(new Vector3(...label.position), new Vector3(0, 0.1, 0), 0.05);
    expect(label.radius).toBeGreaterThan(0.95);
    expect(label.radius).toBeLessThan(1.3);
    expect(label.radius - label.depth).toBeLessThan(1);
  });

  it("passes over a handle that stands off the wall", () => {
    const handle = new CylinderGeometry(0.1, 0.1, 1.2, 16).translate(0, 0, 1.6);
    const query = queryOf(cylinder(), handle);
    const box: PlanarProjector = {
      ...FRONT,
      position: [1, 0, 0],
      rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2],
      size: [3, 0.5, 1],
    };
    const label = placerOn(query, new Vector3(5, 0, 0)).converted(box, "cylindrical") as CylindricalProjector;
    expect(label.radius).toBeCloseTo(1, 2);
  });
});

describe("back to a box, and flat in the texture", () => {
  const query = queryOf(sheet());
  const start: PlanarProjector = { ...FRONT, position: [0.2, 0.1, 0] };

  it("a box comes back from any kind where it was, as large as it was", () => {
    const eye = new Vector3(0.2, 0.1, 5);
    const stampPlace = (uv: readonly [number, number]) =>
      query.raycast(new Vector3(uv[0] * 2 - 1, uv[1] * 2 - 1, 1), new Vector3(0, 0, -1));
    const placer = new ProjectorPlacer(query, view(eye), stampPlace);
    for (const kind of ["perspective", "uv"] as const) {
      const other = placer.converted(start, kind);
      const box = placer.converted(other as Projector, "planar") as PlanarProjector;
      expectVector(new Vector3(...box.position), new Vector3(...start.position), 0.01);
      expect(box.size[0], kind).toBeCloseTo(0.4, 2);
      expect(box.size[1], kind).toBeCloseTo(0.2, 2);
    }
  });

  it("a stamp has the texture's scale and the picture's direction", () => {
    const stamp = placerOn(query).converted({ ...start, rotation: [0, 0, Math.sin(0.2), Math.cos(0.2)] }, "uv");
    const { center, size, angle } = stamp as UvProjector;
    // The sheet is two metres wide and its texture covers it once; three's v runs up, the document's down.
    expect(center[0]).toBeCloseTo(0.6, 3);
    expect(size[0]).toBeCloseTo(0.2, 3);
    expect(size[1]).toBeCloseTo(0.1, 3);
    expect(Math.abs(angle)).toBeCloseTo((0.4 * 180) / Math.PI, 2);
  });
});

describe("aligning", () => {
  const askew: PlanarProjector = { ...FRONT, position: [0, 0, 1], rotation: [0.2, 0.15, 0.3, 0.92] };
  const forward = (projector: Projector): Vector3 => {
    const place = placeOfPicture(queryOf(sphere()), projector, () => null);
    return new Vector3().crossVectors(place?.right as Vector3, place?.up as Vector3).normalize();
  };

  it("a box looks straight at the surface under its middle", () => {
    const box = placerOn(queryOf(cube())).aligned(askew, "surface") as PlanarProjector;
    expectVector(forward(box), new Vector3(0, 0, 1), 1e-3);
    expect(box.size.slice(0, 2)).toEqual([0.4, 0.2]);
  });

  it("upright, its top points up the model", () => {
    const { rotation } = placerOn(queryOf(cube())).aligned(askew, "upright") as PlanarProjector;
    const right = new Vector3(1, 0, 0).applyQuaternion({
      x: rotation[0],
      y: rotation[1],
      z: rotation[2],
      w: rotation[3],
    });
    expect(right.y).toBeCloseTo(0, 9);
  });

  it("to the view, it faces the camera", () => {
    const eye = new Vector3(3, 1, 4);
    const box = placerOn(queryOf(cube()), eye).aligned(askew, "view") as PlanarProjector;
    expectVector(
      forward(box),
      eye
        .clone()
        .sub(new Vector3(0, 0, 1))
        .normalize(),
      1e-6,
    );
  });

  it("a label turns its middle to the camera and keeps its axis", () => {
    const label: CylindricalProjector = {
      ...{ kind: "cylindrical", position: [0, 0, 0], rotation: [0, 0, 0, 1], radius: 1 },
      ...{ height: 0.5, arc: 90, depth: 0.1 },
    };
    const turned = placerOn(queryOf(cylinder()), new Vector3(5, 2, 0)).aligned(label, "view") as CylindricalProjector;
    expect(turned.rotation[1]).toBeCloseTo(Math.SQRT1_2, 6);
    expect(turned.rotation[3]).toBeCloseTo(Math.SQRT1_2, 6);
  });
});
