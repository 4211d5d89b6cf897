import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { PerspectiveProjector } from "../../web/engine/engine-api.ts";
import { seenFrom } from "../../web/viewer/surface-sight.ts";
import { cube, queryOf, sheet, sphere } from "./surface-helpers.ts";

const ahead = (z: number): PerspectiveProjector => ({
  kind: "perspective",
  position: [0.1, 0.2, z],
  rotation: [0, 0, 0, 1],
  fov: 60,
  aspect: 1.5,
  near: 0.01,
  far: 10,
});

/** Where the ray through a pixel's middle goes. */
function rayOf({ position, fov, aspect }: PerspectiveProjector, x: number, y: number, width: number, height: number) {
  const half = Math.tan((fov * Math.PI) / 360);
  const direction = new Vector3(
    ((2 * x + 1) / width - 1) * half * aspect,
    (1 - (2 * y + 1) / height) * half,
    -1,
  ).normalize();
  return [new Vector3(...position), direction] as const;
}

describe("what an eye sees of a model", () => {
  it("is, pixel by pixel, what a ray through the pixel meets first", () => {
    const query = queryOf(
      sphere(),
      sheet().scale(3, 3, 1).translate(0, 0, -1.5),
      cube().scale(0.2, 0.2, 0.2).translate(0.5, 0.5, 1.2),
    );
    const eye = ahead(3);
    const [width, height] = [36, 24];
    const sight = seenFrom(query.surface, eye, width, height);
    let met = 0;
    for (let pixel = 0; pixel < width * height; pixel++) {
      const hit = query.raycast(...rayOf(eye, pixel % width, Math.floor(pixel / width), width, height));
      if (hit === null) continue;
      met += 1;
      expect(sight.materials[pixel]).toBe(0);
      expect(sight.uvs[pixel * 2]).toBeCloseTo(hit.uv[0], 4);
      expect(sight.uvs[pixel * 2 + 1]).toBeCloseTo(hit.uv[1], 4);
    }
    expect(met, "pixels that see the model").toBeGreaterThan(300);
    expect(sight.materials.filter((material) => material === 0)).toHaveLength(met);
  });

  it("is the front of a surface that goes on behind the eye, and nothing of its back", () => {
    const floor = sheet()
      .scale(20, 20, 1)
      .rotateX(-Math.PI / 2);
    const above = seenFrom(queryOf(floor).surface, ahead(0), 8, 8);
    expect([...above.materials.subarray(0, 8)], "above the horizon").toEqual(Array(8).fill(-1));
    expect([...above.materials.subarray(56)], "below it").toEqual(Array(8).fill(0));
    const below = seenFrom(queryOf(floor.clone().translate(0, 1, 0)).surface, ahead(0), 8, 8);
    expect(below.materials.every((material) => material === -1)).toBe(true);
  });
});
