import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { drapedCircle } from "../../web/viewer/brush-ring.ts";
import { cube, cylinder, queryOf, sheet } from "./surface-helpers.ts";

describe("places of the texture on the surface", () => {
  it("the place that a ray meets is found again by its texture coordinate", () => {
    const query = queryOf(cylinder());
    for (const angle of [0.3, 1.7, 4.4]) {
      const from = new Vector3(5 * Math.sin(angle), 0.37, 5 * Math.cos(angle));
      const met = query.raycast(from, from.clone().setY(0).negate().normalize());
      if (met === null) throw new Error("The ray missed.");
      const place = query.triangleAtUv(0, met.uv);
      if (place === null) throw new Error("Nothing lies there.");
      const found = query.at(place.triangle, place.shares);
      expect(found.position.distanceTo(met.position)).toBeLessThan(1e-5);
    }
  });

  it("coordinates wrap, and between the charts there is nothing", () => {
    const query = queryOf(sheet());
    const place = query.triangleAtUv(0, [0.25, 0.5]);
    expect(query.triangleAtUv(0, [-2.75, 7.5])).toEqual(place);
    expect(query.triangleAtUv(1, [0.25, 0.5])).toBeNull();
  });

  it("a triangle that reaches over the border of the texture is found on both sides", () => {
    const geometry = sheet();
    const uv = geometry.getAttribute("uv");
    for (let vertex = 0; vertex < uv.count; vertex++) uv.setX(vertex, uv.getX(vertex) * 0.5 + 0.75);
    const query = queryOf(geometry);
    const at = (u: number) => {
      const place = query.triangleAtUv(0, [u, 0.5]);
      return place && query.at(place.triangle, place.shares).position.x;
    };
    expect(at(0.8)).toBeCloseTo(-0.8, 5);
    expect(at(0.2)).toBeCloseTo(0.8, 5);
    expect(at(0.5)).toBeNull();
  });

  it("u and v grow over a sheet as its map says", () => {
    const query = queryOf(sheet());
    const { u, v } = query.uvGradients(0);
    expect([u.x, u.y, v.x, v.y].map((part) => Math.round(part * 1e5) / 1e5 || 0)).toEqual([0.5, 0, 0, 0.5]);
  });
});

describe("a brush's ring", () => {
  it("lies on a flat face, and is as wide as the brush", () => {
    const circle = drapedCircle(queryOf(cube()), new Vector3(0, 0, 1), new Vector3(0, 0, 1), 0.3);
    for (const point of circle) {
      expect(point.z).toBeCloseTo(1, 5);
      expect(Math.hypot(point.x, point.y)).toBeCloseTo(0.3, 5);
    }
  });

  it("bends with a round surface", () => {
    const circle = drapedCircle(queryOf(cylinder()), new Vector3(0, 0, 1), new Vector3(0, 0, 1), 0.5);
    for (const point of circle) expect(Math.hypot(point.x, point.z)).toBeCloseTo(1, 2);
  });
});
