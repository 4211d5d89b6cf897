import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { createStudioEnvironment, studioRadiance } from "../../web/viewer/studio-environment.ts";

const DIFFUSE = 1;

function fromAround(degrees: number): Vector3 {
  return new Vector3(Math.sin((degrees * Math.PI) / 180), 0, Math.cos((degrees * Math.PI) / 180));
}

describe("the studio's light", () => {
  it("is nearly the same on all sides, so that a decal on the back is judged as fairly as one on the front", () => {
    const sides = Array.from({ length: 36 }, (_, step) => studioRadiance(fromAround(step * 10), DIFFUSE));
    expect(Math.max(...sides) / Math.min(...sides)).toBeLessThan(1.3);
    expect(sides[0]).toBeGreaterThan(0.9);
    expect(sides[0]).toBeLessThan(1.2);
  });

  it("comes more from above than from below, so that shapes read", () => {
    expect(studioRadiance(new Vector3(0, 1, 0), DIFFUSE)).toBeGreaterThan(1.2 * studioRadiance(fromAround(0), DIFFUSE));
    expect(studioRadiance(new Vector3(0, -1, 0), DIFFUSE)).toBeLessThan(0.7 * studioRadiance(fromAround(0), DIFFUSE));
  });

  it("loses its highlights, and none of its light, on rough surfaces", () => {
    const highlight = new Vector3().setFromSphericalCoords(1, (56 * Math.PI) / 180, (-32 * Math.PI) / 180);
    expect(studioRadiance(highlight, 0)).toBeGreaterThan(2.5 * studioRadiance(highlight, DIFFUSE));
  });

  it("has the levels that three reads, and one beneath", () => {
    const texture = createStudioEnvironment();
    expect(texture.isPMREMTexture).toBe(true);
    expect(texture.mipmaps).toHaveLength(5);
    texture.dispose();
  });
});
