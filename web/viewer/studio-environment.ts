/**
 * The light: a neutral photo studio, drawn once into an environment map. Grey only, alike from all sides (a decal on
 * the back is judged as fairly as one on the front), brighter from above so that shapes read.
 */
import {
  BackSide,
  BoxGeometry,
  Color,
  Float32BufferAttribute,
  Mesh,
  MeshBasicMaterial,
  PMREMGenerator,
  Scene,
  SphereGeometry,
  type Texture,
  type WebGLRenderer,
} from "three";

/** Radiance of the dome straight below, at the horizon and straight above. */
const FLOOR = 0.5;
const HORIZON = 0.62;
const CEILING = 0.95;

/** Soft boxes: direction in degrees round the vertical, height of the centre, width, height, radiance. */
const SOFT_BOXES = [
  { around: 35, lift: 3.2, width: 3.6, height: 4.2, radiance: 4.2 },
  { around: 140, lift: 3.6, width: 3, height: 3.4, radiance: 2.6 },
  { around: 215, lift: 3.2, width: 3.6, height: 4.2, radiance: 3.2 },
  { around: 320, lift: 3.6, width: 3, height: 3.4, radiance: 2.8 },
] as const;
const DISTANCE = 8;

/** Texels of a cube face: enough for the gloss of a glazed mug, and a quarter of the cost of three's default. */
const FACE_SIZE = 128;

/** The environment map as a texture that `Scene.environment` takes, and how to free it. */
export function createStudioEnvironment(renderer: WebGLRenderer): { texture: Texture; dispose(): void } {
  const scene = new Scene();
  scene.add(dome());
  for (const { around, lift, width, height, radiance } of SOFT_BOXES) {
    const box = new Mesh(new BoxGeometry(width, height, 0.1), glow(radiance));
    const angle = (around * Math.PI) / 180;
    box.position.set(Math.sin(angle) * DISTANCE, lift, Math.cos(angle) * DISTANCE);
    box.lookAt(0, 0, 0);
    scene.add(box);
  }
  const overhead = new Mesh(new BoxGeometry(5, 0.1, 5), glow(2.2));
  overhead.position.y = DISTANCE;
  scene.add(overhead);

  const generator = new PMREMGenerator(renderer);
  const target = generator.fromScene(scene, 0.02, 0.1, 50, { size: FACE_SIZE });
  generator.dispose();
  scene.traverse((object) => {
    if (object instanceof Mesh) {
      object.geometry.dispose();
      object.material.dispose();
    }
  });
  return { texture: target.texture, dispose: () => target.dispose() };
}

function dome(): Mesh {
  const geometry = new SphereGeometry(20, 32, 24);
  const positions = geometry.getAttribute("position");
  const colors: number[] = [];
  for (let vertex = 0; vertex < positions.count; vertex++) {
    const height = positions.getY(vertex) / 20;
    const radiance = HORIZON + height * (height < 0 ? HORIZON - FLOOR : CEILING - HORIZON);
    colors.push(radiance, radiance, radiance);
  }
  geometry.setAttribute("color", new Float32BufferAttribute(colors, 3));
  return new Mesh(geometry, new MeshBasicMaterial({ vertexColors: true, side: BackSide, toneMapped: false }));
}

function glow(radiance: number): MeshBasicMaterial {
  return new MeshBasicMaterial({ color: new Color(radiance, radiance, radiance), toneMapped: false });
}
