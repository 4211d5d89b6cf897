/** The view's lens, and pictures of the scene in sizes of their own. */
import { MathUtils, type PerspectiveCamera, type Scene, type WebGLRenderer } from "three";

const FIELD_OF_VIEW = 30;

/**
 * The vertical angle of a view of that aspect, degrees. It is given for the shorter side: a view that grows taller (a phone
 * whose panel closes) shows more above and below, and cuts nothing off at the sides.
 */
export function lensFor(aspect: number): number {
  const half = Math.tan(MathUtils.degToRad(FIELD_OF_VIEW / 2)) / Math.min(1, aspect);
  return MathUtils.radToDeg(2 * Math.atan(half));
}

/**
 * The scene through a camera as a PNG on a clear ground; null where the browser gives no canvas. It leaves the renderer in that
 * size: the caller sets its own again in the same turn.
 */
export async function captureScene(
  renderer: WebGLRenderer,
  scene: Scene,
  camera: PerspectiveCamera,
  width: number,
  height: number,
): Promise<Blob | null> {
  const picture = document.createElement("canvas");
  picture.width = width;
  picture.height = height;
  const context = picture.getContext("2d");
  if (context === null) {
    return null;
  }
  renderer.setPixelRatio(1);
  renderer.setSize(width, height, false);
  camera.updateMatrixWorld();
  renderer.render(scene, camera);
  context.drawImage(renderer.domElement, 0, 0);
  return await new Promise((resolve) => picture.toBlob(resolve, "image/png"));
}
