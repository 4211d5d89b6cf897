import { describe, expect, it } from "vitest";
import { TextureCamera } from "../../web/viewer/texture-camera.ts";

function cameraOf(view: [number, number], texture: [number, number]): TextureCamera {
  const camera = new TextureCamera();
  camera.setView({ width: view[0], height: view[1] });
  camera.setTexture({ width: texture[0], height: texture[1] });
  return camera;
}

describe("the texture view's camera", () => {
  it("fits and centres all of the texture at first", () => {
    const camera = cameraOf([432, 232], [1024, 512]);
    expect(camera.scale).toBeCloseTo(400 / 1024, 9);
    expect(camera.pixelOf([0, 0])).toEqual({ x: 16, y: 16 });
    expect(camera.pixelOf([1, 1]).x).toBeCloseTo(416, 9);
  });

  it("stays fitted when the view changes its size, until the user zooms", () => {
    const camera = cameraOf([432, 432], [1024, 1024]);
    camera.setView({ width: 832, height: 832 });
    expect(camera.scale).toBeCloseTo(800 / 1024, 9);
    camera.zoomAt(2, 100, 100);
    const zoomed = camera.scale;
    camera.setView({ width: 432, height: 432 });
    expect(camera.scale).toBe(zoomed);
  });

  it("keeps the texel under the pointer where it is while it zooms", () => {
    const camera = cameraOf([500, 500], [1024, 1024]);
    const texelAt = (x: number) => (x - camera.x) / camera.scale;
    const before = texelAt(210);
    camera.zoomAt(3, 210, 210);
    expect(texelAt(210)).toBeCloseTo(before, 9);
  });

  it("zooms in as far as single texels, and out a little beyond all of it", () => {
    const camera = cameraOf([500, 500], [1024, 1024]);
    camera.zoomAt(1e9, 250, 250);
    expect(camera.scale).toBe(64);
    camera.zoomAt(1e-9, 250, 250);
    expect(camera.scale * 1024).toBeCloseTo(0.4 * 468, 6);
  });

  it("keeps a part of the texture in view, however far it is dragged", () => {
    const camera = cameraOf([500, 500], [1024, 1024]);
    camera.panBy(1e6, -1e6);
    expect(camera.x).toBeLessThan(500);
    expect(camera.y + 1024 * camera.scale).toBeGreaterThan(0);
  });

  it("keeps the same part in view when the target gets another size", () => {
    const camera = cameraOf([500, 500], [1024, 1024]);
    camera.zoomAt(4, 100, 100);
    const middle = camera.pixelOf([0.5, 0.5]);
    camera.setTexture({ width: 2048, height: 2048 });
    expect(camera.pixelOf([0.5, 0.5]).x).toBeCloseTo(middle.x, 6);
  });

  it("fits again on request", () => {
    const camera = cameraOf([500, 500], [1024, 1024]);
    camera.zoomAt(4, 100, 100);
    camera.fit();
    expect(camera.pixelOf([0, 0])).toEqual({ x: 16, y: 16 });
  });
});
