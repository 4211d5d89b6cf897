/**
 * The soft shadow under the model: its silhouette from below, blurred once per model. The nearer to the ground, the
 * darker. Only the resting pose throws one; a walking figure keeps it as its ground.
 */
import {
  type Box3,
  Color,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  OrthographicCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  Sphere,
  Vector2,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from "three";

const SIZE = 256;
/** Side of the shadow's plane, in diameters of the model's footprint: the blur needs room. */
const MARGIN = 1.7;
const BLUR_PASSES = [0.035, 0.018] as const;

export class ContactShadow {
  readonly mesh: Mesh<PlaneGeometry, MeshBasicMaterial>;
  readonly #renderer: WebGLRenderer;
  readonly #target = new WebGLRenderTarget(SIZE, SIZE, { depthBuffer: true });

  constructor(renderer: WebGLRenderer) {
    this.#renderer = renderer;
    const material = new MeshBasicMaterial({
      map: this.#target.texture,
      transparent: true,
      depthWrite: false,
      toneMapped: false,
    });
    this.mesh = new Mesh(new PlaneGeometry(1, 1), material);
    this.mesh.rotation.x = -Math.PI / 2;
    this.mesh.renderOrder = -1;
    this.mesh.visible = false;
  }

  /** 0 is none, 1 black. */
  set strength(value: number) {
    this.mesh.material.opacity = value;
  }

  /** Draws the shadow of `model`, whose bounds are given, as it stands now. */
  cast(model: Object3D, bounds: Box3): void {
    const size = bounds.getSize(new Vector3());
    const centre = bounds.getCenter(new Vector3());
    const radius = bounds.getBoundingSphere(new Sphere()).radius;
    const side = Math.max(size.x, size.z, radius * 0.2) * MARGIN;
    const reach = Math.max(size.y, radius * 0.1) * 0.6;
    this.mesh.scale.set(side, side, 1);
    // Below the lowest point by a hair, so that a flat base does not flicker through it.
    this.mesh.position.set(centre.x, bounds.min.y - radius * 2e-3, centre.z);
    this.mesh.visible = true;
    this.#drawSilhouette(model, this.mesh.position, side, reach);
    this.#blur();
  }

  dispose(): void {
    this.#target.dispose();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  #drawSilhouette(model: Object3D, ground: Vector3, side: number, reach: number): void {
    // Looks up from the ground. Left and right change places, else the picture would be mirrored: it is seen from above.
    const camera = new OrthographicCamera(side / 2, -side / 2, side / 2, -side / 2, 0, reach);
    camera.position.copy(ground);
    camera.up.set(0, 0, -1);
    camera.lookAt(ground.x, ground.y + 1, ground.z);
    const scene = new Scene();
    const parent = model.parent;
    scene.add(model);
    scene.overrideMaterial = new ShaderMaterial({
      vertexShader: SILHOUETTE_VERTEX,
      fragmentShader: "varying float near; void main() { gl_FragColor = vec4(0.0, 0.0, 0.0, near * near); }",
      side: 2,
    });
    this.#withTarget(this.#target, () => this.#renderer.render(scene, camera));
    scene.overrideMaterial.dispose();
    parent?.add(model);
  }

  #blur(): void {
    const scratch = new WebGLRenderTarget(SIZE, SIZE, { depthBuffer: false });
    const material = new ShaderMaterial({
      uniforms: { source: { value: null }, step: { value: new Vector2() } },
      vertexShader: "varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy * 2.0, 0.0, 1.0); }",
      fragmentShader: BLUR_FRAGMENT,
      depthTest: false,
      depthWrite: false,
    });
    const scene = new Scene();
    const quad = new Mesh(new PlaneGeometry(1, 1), material);
    quad.frustumCulled = false;
    scene.add(quad);
    const camera = new OrthographicCamera();
    const pass = (from: WebGLRenderTarget, to: WebGLRenderTarget, x: number, y: number) => {
      material.uniforms.source = { value: from.texture };
      material.uniforms.step = { value: new Vector2(x, y) };
      this.#withTarget(to, () => this.#renderer.render(scene, camera));
    };
    for (const radius of BLUR_PASSES) {
      pass(this.#target, scratch, radius / 8, 0);
      pass(scratch, this.#target, 0, radius / 8);
    }
    scratch.dispose();
    material.dispose();
    quad.geometry.dispose();
  }

  #withTarget(target: WebGLRenderTarget, draw: () => void): void {
    const renderer = this.#renderer;
    const color = renderer.getClearColor(new Color());
    const alpha = renderer.getClearAlpha();
    renderer.setClearColor(0x000000, 0);
    renderer.setRenderTarget(target);
    renderer.clear();
    draw();
    renderer.setRenderTarget(null);
    renderer.setClearColor(color, alpha);
  }
}

/** Three's own chunks, so that morphs and skins are where the model shows them. */
const SILHOUETTE_VERTEX = /* glsl */ `
  #include <common>
  #include <morphtarget_pars_vertex>
  #include <skinning_pars_vertex>
  varying float near;
  void main() {
    #include <begin_vertex>
    #include <morphinstance_vertex>
    #include <morphtarget_vertex>
    #include <skinbase_vertex>
    #include <skinning_vertex>
    #include <project_vertex>
    near = 1.0 - clamp(gl_Position.z * 0.5 + 0.5, 0.0, 1.0);
  }`;

const BLUR_FRAGMENT = /* glsl */ `
  uniform sampler2D source;
  uniform vec2 step;
  varying vec2 at;
  void main() {
    float total = 0.0;
    float alpha = 0.0;
    for (int tap = -8; tap <= 8; tap++) {
      float weight = exp(-float(tap * tap) / 24.0);
      alpha += weight * texture2D(source, at + step * float(tap)).a;
      total += weight;
    }
    gl_FragColor = vec4(0.0, 0.0, 0.0, alpha / total);
  }`;
