/** The chart under the pointer, lit up on the model: its triangles tinted, its border a line. */
import {
  BufferAttribute,
  BufferGeometry,
  type Color,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
} from "three";
import { OVERLAY_LAYER } from "./view-layers.ts";

/** Enough to tell the chart, and so little that its colours are still judged. */
const FILL_OPACITY = 0.1;

export class ChartGlow {
  readonly group = new Group();
  readonly #fill: Mesh<BufferGeometry, MeshBasicMaterial>;
  readonly #border: LineSegments<BufferGeometry, LineBasicMaterial>;

  constructor() {
    const common = { transparent: true, depthWrite: false, toneMapped: false } as const;
    this.#fill = new Mesh(
      new BufferGeometry(),
      new MeshBasicMaterial({
        ...common,
        opacity: FILL_OPACITY,
        side: DoubleSide,
        // In front of the surface that it tints by a hair.
        polygonOffset: true,
        polygonOffsetFactor: -1,
        polygonOffsetUnits: -1,
      }),
    );
    this.#border = new LineSegments(new BufferGeometry(), new LineBasicMaterial(common));
    for (const object of [this.#fill, this.#border]) {
      object.layers.set(OVERLAY_LAYER);
      object.frustumCulled = false;
      this.group.add(object);
    }
    this.#fill.renderOrder = 1;
    this.#border.renderOrder = 2;
    this.group.visible = false;
  }

  set color(value: Color) {
    this.#fill.material.color.copy(value);
    this.#border.material.color.copy(value);
  }

  /**
   * Shows triangles. @param positions three numbers a vertex, model space @param index three vertices a triangle
   * @param borders two vertices a line
   */
  show(positions: Float32Array, index: Uint32Array, borders: Uint32Array): void {
    const vertices = new BufferAttribute(positions, 3);
    for (const [object, order] of [
      [this.#fill, index],
      [this.#border, borders],
    ] as const) {
      object.geometry.dispose();
      object.geometry = new BufferGeometry().setAttribute("position", vertices).setIndex(new BufferAttribute(order, 1));
    }
    this.group.visible = true;
  }

  hide(): void {
    this.group.visible = false;
  }

  dispose(): void {
    for (const object of [this.#fill, this.#border]) {
      object.geometry.dispose();
      object.material.dispose();
    }
  }
}
