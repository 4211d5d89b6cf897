/** A canvas that reaches beyond its view, under the tools that stand beside that: it shows there what the scene has there. */
import type { PerspectiveCamera } from "three";
import type { ScreenSpace } from "./screen-space.ts";

export class WiderCanvas {
  readonly #camera: PerspectiveCamera;
  readonly #canvas: HTMLCanvasElement;
  readonly #screen: ScreenSpace;
  #size: ScreenSpace["size"] | null = null;
  #window: readonly [left: number, top: number, width: number, height: number] = [0, 0, 1, 1];

  /** The camera's frame is the view's, for all who ask where something is on the screen. */
  constructor(camera: PerspectiveCamera, canvas: HTMLCanvasElement, screen: ScreenSpace) {
    this.#camera = camera;
    this.#canvas = canvas;
    this.#screen = screen;
  }

  /** Before the scene is drawn: the camera takes in all of the canvas. */
  widen(): void {
    const { size } = this.#screen;
    // Asked of the document once a size, as the view's own is.
    if (this.#size !== size) {
      const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = this.#canvas;
      this.#size = size;
      this.#window = [offsetLeft, offsetTop, offsetWidth || 1, offsetHeight || 1];
    }
    this.#camera.setViewOffset(size.width, size.height, ...this.#window);
  }

  /** Once it is drawn. */
  narrow(): void {
    this.#camera.clearViewOffset();
  }
}
