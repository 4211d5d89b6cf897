/** A pool of light on the ground beneath the model, which a dark page needs to see the model stand on something. */
import {
  type Box3,
  DataTexture,
  LinearFilter,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  RGBAFormat,
  Sphere,
  Vector3,
} from "three";

const SIZE = 128;
/** Side of the pool, in radii of the model. */
const REACH = 5;

export class GroundLight {
  readonly mesh: Mesh<PlaneGeometry, MeshBasicMaterial>;

  constructor() {
    const material = new MeshBasicMaterial({
      map: radialFade(),
      transparent: true,
      depthWrite: false,
      toneMapped: false,
    });
    this.mesh = new Mesh(new PlaneGeometry(1, 1), material);
    this.mesh.rotation.x = -Math.PI / 2;
    this.mesh.renderOrder = -2;
    this.mesh.visible = false;
  }

  /** 0 is none, 1 white. */
  set strength(value: number) {
    this.mesh.material.opacity = value;
    this.mesh.material.visible = value > 0;
  }

  place(bounds: Box3): void {
    const { center, radius } = bounds.getBoundingSphere(new Sphere());
    this.mesh.scale.setScalar(radius * REACH);
    // Just under the shadow, which lies just under the model.
    this.mesh.position.copy(new Vector3(center.x, bounds.min.y - radius * 4e-3, center.z));
    this.mesh.visible = true;
  }

  dispose(): void {
    this.mesh.material.map?.dispose();
    this.mesh.material.dispose();
    this.mesh.geometry.dispose();
  }
}

/** White, densest in the middle and gone at the rim without an edge. */
function radialFade(): DataTexture {
  const data = new Uint8Array(SIZE * SIZE * 4).fill(255);
  for (let texel = 0; texel < SIZE * SIZE; texel++) {
    const x = (((texel % SIZE) + 0.5) / SIZE) * 2 - 1;
    const y = ((Math.floor(texel / SIZE) + 0.5) / SIZE) * 2 - 1;
    const inside = Math.max(0, 1 - Math.hypot(x, y));
    data[texel * 4 + 3] = Math.round(255 * inside * inside * (3 - 2 * inside));
  }
  const texture = new DataTexture(data, SIZE, SIZE, RGBAFormat);
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
