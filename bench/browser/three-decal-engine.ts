/**
 * three.js' DecalGeometry: cuts the part of the mesh that lies in the box out as a new mesh, to be drawn over the model. It
 * paints no texture, so the texture's size is nothing to it, and the model's own texture never holds the decal.
 */
import { BufferAttribute, BufferGeometry, Euler, Mesh, Quaternion, Vector3 } from "three";
import { DecalGeometry } from "three/examples/jsm/geometries/DecalGeometry.js";
import type { DragStep, Run } from "../engines/engine.ts";
import type { BenchMesh } from "../work.ts";
import type { PageEngine } from "./page-engine.ts";

export class ThreeDecalEngine implements PageEngine {
  readonly name = "three.js DecalGeometry";
  readonly #mesh = new Mesh(new BufferGeometry());

  async load({ positions, normals, uvs, indices }: BenchMesh): Promise<void> {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    geometry.setAttribute("uv", new BufferAttribute(uvs, 2));
    geometry.setIndex(new BufferAttribute(indices, 1));
    this.#mesh.geometry = geometry;
    this.#mesh.updateMatrixWorld();
  }

  async prepare(): Promise<void> {}

  async project({ projector }: DragStep): Promise<Run> {
    const start = performance.now();
    const orientation = new Euler().setFromQuaternion(new Quaternion(...projector.rotation));
    const size = new Vector3(...projector.size);
    new DecalGeometry(this.#mesh, new Vector3(...projector.position), orientation, size);
    return { milliseconds: performance.now() - start, texels: 0 };
  }

  async readTexture(): Promise<null> {
    return null;
  }

  close(): void {}
}
