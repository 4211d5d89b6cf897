/**
 * The light: a neutral photo studio as an environment map. Grey only, nearly alike from all sides (a decal on the back
 * is judged as fairly as one on the front), brighter from above and from one side so that shapes read.
 *
 * Every light is a spherical Gaussian, which stays one under the blur that a rough surface sees through. So each
 * roughness level is written in closed form, in milliseconds. Three's PMREMGenerator filters a drawn room instead; in
 * software rendering that took 2.5 to 5 seconds, before the first frame.
 *
 * The layout of levels is that of three's prefiltered cube maps (PMREMGenerator.lodToRoughness): roughness 0 at level 0,
 * the diffuse light at the last one.
 */
import {
  CubeTexture,
  DataTexture,
  DataUtils,
  HalfFloatType,
  LinearFilter,
  LinearMipmapLinearFilter,
  LinearSRGBColorSpace,
  RGBAFormat,
  Vector3,
} from "three";

/** A soft light: where it hangs (degrees round the vertical from +Z towards +X, and above the horizon). */
interface SoftLight {
  readonly around: number;
  readonly above: number;
  /** Radiance at its middle. */
  readonly radiance: number;
  /** Sharpness of the Gaussian; 20 is about 25 degrees across at half its radiance. */
  readonly sharpness: number;
}

const LIGHTS: readonly SoftLight[] = [
  { around: -32, above: 34, radiance: 4.8, sharpness: 14 },
  { around: 48, above: 18, radiance: 1.5, sharpness: 10 },
  { around: 164, above: 36, radiance: 4.2, sharpness: 14 },
  { around: -128, above: 20, radiance: 1.5, sharpness: 10 },
  { around: 0, above: 90, radiance: 0.8, sharpness: 5 },
];

/** The walls between the lights: radiance at the horizon, and how much it grows to the top (and falls to the floor). */
const WALL = 0.5;
const WALL_SLOPE = 0.14;

/** Texels along a face of the sharpest level. Gaussians have no edges that more would show. */
const FACE_SIZE = 64;
/** Levels that three reads, and one beneath that it expects to be there. */
const LEVELS = 5;

/** The prefiltered map, as `Scene.environment` takes it. Plain data: it survives a lost WebGL context by itself. */
export function createStudioEnvironment(): CubeTexture {
  const levels = Array.from({ length: LEVELS + 1 }, (_, level) => {
    const roughness = 1 - Math.sqrt(Math.max(0, 1 - level / (LEVELS - 1)));
    return drawFaces(Math.max(1, FACE_SIZE >> level), roughness);
  });
  const texture = new CubeTexture(levels[0]);
  texture.mipmaps = levels.slice(1).map((faces) => ({ image: faces })) as never[];
  texture.format = RGBAFormat;
  texture.type = HalfFloatType;
  texture.colorSpace = LinearSRGBColorSpace;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = false;
  texture.isPMREMTexture = true;
  texture.needsUpdate = true;
  return texture;
}

/** Radiance that a surface of this roughness gathers around `direction` (unit). */
export function studioRadiance(direction: Vector3, roughness: number): number {
  // The lobe about the normal, as a Gaussian: half the width of the GGX distribution's, and the cosine at roughness 1.
  const lobe = 0.5 / Math.max(roughness, 0.02) ** 4 + 1.6;
  let radiance = WALL + WALL_SLOPE * direction.y * (1 - roughness / 3);
  for (const { axis, light } of HUNG_LIGHTS) {
    const sharpness = (light.sharpness * lobe) / (light.sharpness + lobe);
    const spread = energyOf(light.sharpness) / energyOf(sharpness);
    radiance += light.radiance * spread * Math.exp(sharpness * (axis.dot(direction) - 1));
  }
  return radiance;
}

const HUNG_LIGHTS = LIGHTS.map((light) => {
  const polar = ((90 - light.above) * Math.PI) / 180;
  return { light, axis: new Vector3().setFromSphericalCoords(1, polar, (light.around * Math.PI) / 180) };
});

/** Integral of a Gaussian of radiance 1 over the sphere. */
function energyOf(sharpness: number): number {
  return ((2 * Math.PI) / sharpness) * (1 - Math.exp(-2 * sharpness));
}

function drawFaces(size: number, roughness: number): DataTexture[] {
  return Array.from({ length: 6 }, (_, face) => {
    const data = new Uint16Array(size * size * 4);
    const one = DataUtils.toHalfFloat(1);
    for (let texel = 0; texel < size * size; texel++) {
      const s = (((texel % size) + 0.5) / size) * 2 - 1;
      const t = ((Math.floor(texel / size) + 0.5) / size) * 2 - 1;
      const grey = DataUtils.toHalfFloat(studioRadiance(faceDirection(face, s, t), roughness));
      data.set([grey, grey, grey, one], texel * 4);
    }
    return new DataTexture(data, size, size, RGBAFormat, HalfFloatType);
  });
}

/** OpenGL's cube faces (+X, -X, +Y, -Y, +Z, -Z); three mirrors x of cube textures, so it is mirrored back here. */
function faceDirection(face: number, s: number, t: number): Vector3 {
  const direction = [
    new Vector3(1, -t, -s),
    new Vector3(-1, -t, s),
    new Vector3(s, 1, t),
    new Vector3(s, -1, -t),
    new Vector3(s, -t, 1),
    new Vector3(-s, -t, -1),
  ][face] as Vector3;
  direction.x *= -1;
  return direction.normalize();
}
