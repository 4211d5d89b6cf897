/** The editor's tools in the flat view: their pointer, and their ring as it lies in the texture. */
import { closedPath, crossPath, RingOverlay } from "./brush-ring.ts";
import type { TextureCamera } from "./texture-camera.ts";
import type { ToolInput } from "./tool-input.ts";
import { ToolPointer } from "./tool-pointer.ts";
import type { SurfaceHit } from "./viewer-api.ts";

type UvPoint = readonly [number, number];

/** Pixels across. */
const LEAST_RING = 6;

export class TextureTools {
  readonly #camera: TextureCamera;
  readonly #pointer: ToolPointer;
  readonly #overlay: RingOverlay;
  #pick: (uv: UvPoint) => SurfaceHit | null = () => null;
  #ring: readonly (readonly UvPoint[])[] = [];
  #shown = false;

  constructor(root: HTMLElement, camera: TextureCamera) {
    this.#camera = camera;
    this.#overlay = new RingOverlay(root);
    this.#pointer = new ToolPointer(root, {
      kind: "texture",
      hitAt: ({ x, y }) => this.#pick(camera.uvOf(x, y)),
      uvAt: ({ x, y }) => camera.uvOf(x, y),
      placeOf: (hit) => camera.pixelOf(hit.uv),
    });
  }

  get active(): boolean {
    return this.#pointer.tool !== null;
  }

  /** `pick` finds the surface of a place. */
  set(input: ToolInput | null, pick: (uv: UvPoint) => SurfaceHit | null): void {
    this.#pick = pick;
    this.#pointer.tool = input;
    if (input === null) this.showRing(null);
  }

  showRing(outlines: readonly (readonly UvPoint[])[] | null): void {
    this.#ring = outlines ?? [];
    this.place(this.#shown);
  }

  /** Draws the ring where its place is in the view now; nothing while no texture is `shown`. */
  place(shown: boolean): void {
    this.#shown = shown;
    const paths = shown ? this.#ring.map((outline) => this.#pathOf(outline)) : [];
    this.#overlay.draw(paths[0] ?? "", paths[1] ?? "");
  }

  dispose(): void {
    this.#pointer.dispose();
    this.#overlay.dispose();
  }

  /** A ring that would be a dot is a cross. */
  #pathOf(outline: readonly UvPoint[]): string {
    const points = outline.map((uv) => this.#camera.pixelOf(uv));
    const [first, opposite] = [points[0], points[points.length >> 1]];
    if (first === undefined || opposite === undefined) return "";
    const across = Math.hypot(first.x - opposite.x, first.y - opposite.y);
    const middle = { x: (first.x + opposite.x) / 2, y: (first.y + opposite.y) / 2 };
    return across < LEAST_RING ? crossPath(middle) : closedPath(points);
  }
}
