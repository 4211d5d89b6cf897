/**
 * Babylon.js' MeshUVSpaceRenderer: draws the mesh unfolded into its texture, with the decal's projection in the shader.
 * It paints onto a transparent texture that the material must then lay over its own; without mip levels here. A drag
 * clears it first, since each painting is added to those before.
 */
// Every mesh is given one.
import "@babylonjs/core/Materials/standardMaterial.js";
import { FreeCamera } from "@babylonjs/core/Cameras/freeCamera.js";
import { Engine } from "@babylonjs/core/Engines/engine.js";
import { RawTexture } from "@babylonjs/core/Materials/Textures/rawTexture.js";
import { RenderTargetTexture } from "@babylonjs/core/Materials/Textures/renderTargetTexture.js";
import { Texture } from "@babylonjs/core/Materials/Textures/texture.js";
import { Vector3 } from "@babylonjs/core/Maths/math.vector.js";
import { Mesh } from "@babylonjs/core/Meshes/mesh.js";
import { VertexData } from "@babylonjs/core/Meshes/mesh.vertexData.js";
import { MeshUVSpaceRenderer } from "@babylonjs/core/Meshes/meshUVSpaceRenderer.js";
import { Scene } from "@babylonjs/core/scene.js";
import type { Picture, PlanarProjector } from "../../web/engine/engine-api.ts";
import type { DragStep, Run } from "../engines/engine.ts";
import { boxAxes } from "../planar-matrix.ts";
import type { BenchMesh } from "../work.ts";
import { countPainted, nextFrame, type PageEngine, readOnePixel, timeWithGpu } from "./page-engine.ts";

export class BabylonEngine implements PageEngine {
  readonly name = "Babylon.js MeshUVSpaceRenderer";
  readonly #engine = new Engine(document.createElement("canvas"), false);
  readonly #scene = new Scene(this.#engine);
  #mesh: Mesh | null = null;
  #decal: RawTexture | null = null;
  #renderer: MeshUVSpaceRenderer | null = null;
  #size = 0;
  /** What the decal of these numbers painted: the nudges change it little, and counting takes long. */
  #painted = { decal: "", texels: 0 };

  static get version(): string {
    return Engine.Version;
  }

  constructor() {
    this.#scene.useRightHandedSystem = true;
    this.#scene.activeCamera = new FreeCamera("camera", new Vector3(0, 0, 5), this.#scene);
  }

  async load({ name, positions, normals, uvs, indices }: BenchMesh, decal: Picture): Promise<void> {
    this.#mesh?.dispose();
    this.#decal?.dispose();
    const mesh = new Mesh(name, this.#scene);
    const data = new VertexData();
    Object.assign(data, { positions, normals, uvs, indices });
    data.applyToMesh(mesh);
    this.#mesh = mesh;
    const { rgba, width, height } = decal;
    this.#decal = RawTexture.CreateRGBATexture(
      ...[rgba, width, height, this.#scene, false, false, Texture.BILINEAR_SAMPLINGMODE],
    );
  }

  async prepare(size: number): Promise<void> {
    if (!this.#mesh) throw new Error("load comes first");
    this.#renderer?.dispose();
    this.#size = size;
    this.#painted = { decal: "", texels: 0 };
    const options = { width: size, height: size, generateMipMaps: false, optimizeUVAllocation: false };
    this.#renderer = new MeshUVSpaceRenderer(this.#mesh, this.#scene, options);
    while (!this.#renderer.isReady()) await nextFrame();
  }

  async project({ projector }: DragStep): Promise<Run> {
    const [renderer, decal, gl] = [this.#renderer, this.#decal, this.#engine._gl as WebGL2RenderingContext];
    if (!renderer || !decal) throw new Error("load and prepare come first");
    const place = placeOf(projector);
    const times = await timeWithGpu(
      () => {
        renderer.clear();
        renderer.renderTexture(decal, place.position, place.normal, place.size, place.angle, false);
        gl.flush();
      },
      () => this.#bound(() => readOnePixel(gl)),
    );
    const name = JSON.stringify([projector.rotation, projector.size]);
    if (this.#painted.decal !== name) this.#painted = { decal: name, texels: countPainted(await this.readTexture()) };
    return { ...times, texels: this.#painted.texels };
  }

  async readTexture(): Promise<Uint8Array> {
    const [gl, size] = [this.#engine._gl as WebGL2RenderingContext, this.#size];
    const rgba = new Uint8Array(size * size * 4);
    this.#bound(() => gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, rgba));
    return rgba;
  }

  close(): void {
    this.#engine.dispose();
  }

  #bound(read: () => void): void {
    const texture = this.#renderer?.texture;
    const target = texture instanceof RenderTargetTexture ? texture.renderTarget : null;
    if (!target) throw new Error("MeshUVSpaceRenderer has no target");
    this.#engine.bindFramebuffer(target);
    read();
    this.#engine.unBindFramebuffer(target);
  }
}

/** A box as Babylon.js names it: a middle, the way out of the surface, and a roll around it. */
function placeOf({ position, rotation, size }: PlanarProjector) {
  const [, up, out] = boxAxes(rotation);
  const normal = Vector3.FromArray(out);
  // Its own frame at angle 0, from the yaw and the pitch that it makes of the normal (MeshUVSpaceRenderer).
  const yaw = -Math.atan2(normal.z, normal.x) - Math.PI / 2;
  const pitch = Math.atan2(normal.y, Math.hypot(normal.x, normal.z));
  const right = new Vector3(Math.cos(yaw), 0, -Math.sin(yaw));
  const upright = new Vector3(Math.sin(yaw) * Math.sin(pitch), Math.cos(pitch), Math.cos(yaw) * Math.sin(pitch));
  const ours = Vector3.FromArray(up);
  return {
    position: Vector3.FromArray(position),
    normal,
    // Its x axis points to the viewer's left; its picture's first row lies at the bottom.
    size: new Vector3(-size[0], -size[1], size[2]),
    angle: Math.atan2(-Vector3.Dot(ours, right), Vector3.Dot(ours, upright)),
  };
}
