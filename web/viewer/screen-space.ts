/** Model space to CSS pixels of the view and back, for one camera and one view size. */
import { type PerspectiveCamera, Ray, Vector2, Vector3 } from "three";
import { ClientCorner } from "./client-corner.ts";
import { windowOf } from "./window-of.ts";

export interface ScreenPoint {
  /** CSS pixels from the view's top left corner. */
  readonly x: number;
  readonly y: number;
}

export class ScreenSpace {
  readonly #camera: PerspectiveCamera;
  readonly #element: HTMLElement;
  readonly #corner: ClientCorner;
  readonly #resize: ResizeObserver;
  #size: { readonly width: number; readonly height: number } | null = null;

  constructor(camera: PerspectiveCamera, element: HTMLElement) {
    this.#camera = camera;
    this.#element = element;
    this.#corner = new ClientCorner(element);
    // Asked of the document once a size and not once a point: the gizmo changes its drawing in each frame of a drag, and
    // after a change each question makes the browser lay the page out anew.
    this.#resize = new (windowOf(element).ResizeObserver)(() => {
      this.#size = null;
    });
    this.#resize.observe(element);
  }

  dispose(): void {
    this.#resize.disconnect();
    this.#corner.dispose();
  }

  /** Null for points behind the camera. */
  project(point: Vector3): ScreenPoint | null {
    const projected = point.clone().applyMatrix4(this.#camera.matrixWorldInverse);
    if (projected.z > -this.#camera.near * 0.5) {
      return null;
    }
    projected.applyMatrix4(this.#camera.projectionMatrix);
    const { width, height } = this.size;
    return { x: ((projected.x + 1) / 2) * width, y: ((1 - projected.y) / 2) * height };
  }

  holds({ x, y }: ScreenPoint): boolean {
    const { width, height } = this.size;
    return x >= 0 && y >= 0 && x <= width && y <= height;
  }

  /** The point of the view that is nearest to a point, this far from its border. */
  within({ x, y }: ScreenPoint, margin: number): ScreenPoint {
    const { width, height } = this.size;
    return {
      x: Math.max(margin, Math.min(width - margin, x)),
      y: Math.max(margin, Math.min(height - margin, y)),
    };
  }

  /** Of the view, CSS pixels; at least one, as a view that is not shown yet has a middle, too. */
  get size(): { readonly width: number; readonly height: number } {
    this.#size ??= { width: this.#element.clientWidth || 1, height: this.#element.clientHeight || 1 };
    return this.#size;
  }

  /** Metres that one CSS pixel spans at a point of model space. */
  metresPerPixel(point: Vector3): number {
    const depth = Math.abs(point.clone().applyMatrix4(this.#camera.matrixWorldInverse).z);
    return (2 * depth * Math.tan((this.#camera.fov * Math.PI) / 360)) / this.size.height;
  }

  /** Where an event is in the view. */
  pointOf(clientX: number, clientY: number): ScreenPoint {
    return this.#corner.pointOf(clientX, clientY);
  }

  /** From the eye through a point of the view; the direction is unit. */
  rayThrough(point: ScreenPoint): Ray {
    const { width, height } = this.size;
    const device = new Vector2((point.x / (width || 1)) * 2 - 1, 1 - (point.y / (height || 1)) * 2);
    const origin = this.#camera.getWorldPosition(new Vector3());
    const direction = new Vector3(device.x, device.y, 0.5).unproject(this.#camera).sub(origin).normalize();
    return new Ray(origin, direction);
  }

  get eye(): Vector3 {
    return this.#camera.getWorldPosition(new Vector3());
  }

  /** The camera's axes in model space. */
  get axes(): { right: Vector3; up: Vector3 } {
    const right = new Vector3();
    const up = new Vector3();
    this.#camera.matrixWorld.extractBasis(right, up, new Vector3());
    return { right, up };
  }
}
