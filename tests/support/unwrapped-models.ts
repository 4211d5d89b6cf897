/** What of a model must be the same before and after it is unwrapped, read by @gltf-transform and not by what wrote it. */
import { type Document, type Primitive, WebIO } from "@gltf-transform/core";
import { ALL_EXTENSIONS, KHRTextureTransform, type Transform } from "@gltf-transform/extensions";
import { validateBytes } from "gltf-validator";
import type { MaterialInfo, Picture } from "../../web/engine/engine-api.ts";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";

const STRIP = 5;
const FAN = 6;

export const documentOf = async (glb: Uint8Array): Promise<Document> =>
  await new WebIO().registerExtensions(ALL_EXTENSIONS).readBinary(glb as Uint8Array<ArrayBuffer>);

export const primitivesOf = (document: Document): Primitive[] =>
  document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives());

/** The vertices of each triangle's corners, in the order that glTF 2.0, 3.7.2.1, gives strips and fans. */
function cornersOf(primitive: Primitive): number[] {
  const count = primitive.getAttribute("POSITION")?.getCount() ?? 0;
  const listed: number[] = Array.from(primitive.getIndices()?.getArray() ?? Array.from({ length: count }, (_, i) => i));
  const mode = primitive.getMode();
  if (mode !== STRIP && mode !== FAN) return listed;
  return listed.slice(2).flatMap((_, i) => {
    const places = mode === FAN ? [i + 1, i + 2, 0] : i % 2 === 0 ? [i, i + 1, i + 2] : [i, i + 2, i + 1];
    return places.map((place) => listed[place] as number);
  });
}

/** The values of an attribute at each corner of each triangle. */
export function corners(primitive: Primitive, semantic: string): number[][] {
  const values = primitive.getAttribute(semantic);
  return values === null ? [] : cornersOf(primitive).map((vertex) => values.getElement(vertex, []));
}

/** All attributes of all corners, the morph targets' too, of each primitive. */
export function surfaces(document: Document): Record<string, number[][]>[] {
  return primitivesOf(document).map((primitive) => {
    const own = primitive.listSemantics().map((semantic) => [semantic, corners(primitive, semantic)] as const);
    const moved = primitive.listTargets().flatMap((target, i) =>
      target.listSemantics().map((semantic) => {
        const values = target.getAttribute(semantic);
        return [
          `${semantic} of target ${i}`,
          cornersOf(primitive).map((at) => values?.getElement(at, []) ?? []),
        ] as const;
      }),
    );
    return Object.fromEntries([...own, ...moved]);
  });
}

export async function overlapOf(
  glb: Uint8Array,
  size: number,
  material = 0,
): Promise<{ covered: number; overlapping: number; info: MaterialInfo | undefined }> {
  const engine = createEngineHost();
  try {
    const { materials } = await engine.loadModel({ name: "unwrapped.glb", bytes: glb });
    const target = await engine.openTarget({ material, width: size, height: size });
    const { coveredTexels: covered, overlappingTexels: overlapping } = target;
    return { covered, overlapping, info: materials[material] };
  } finally {
    engine.dispose();
  }
}

/** What Khronos's validator calls an error or a warning. */
export async function faultsOf(glb: Uint8Array): Promise<string[]> {
  const { messages } = (await validateBytes(glb)).issues;
  return messages.filter(({ severity }) => severity <= 1).map(({ code, pointer }) => `${code} at ${pointer}`);
}

/** Bilinear, as a viewer magnifies; it goes on by repeating. */
function colorAt({ width, height, rgba }: Picture, u: number, v: number): number[] {
  const [x, y] = [u * width - 0.5, v * height - 0.5];
  const [left, top] = [Math.floor(x), Math.floor(y)];
  const texel = (i: number, j: number): Uint8Array => {
    const at = 4 * ((((j % height) + height) % height) * width + (((i % width) + width) % width));
    return rgba.subarray(at, at + 4);
  };
  return [0, 1, 2].map((channel) => {
    const mix = (j: number) =>
      (texel(left, j)[channel] as number) * (1 - x + left) + (texel(left + 1, j)[channel] as number) * (x - left);
    return mix(top) * (1 - y + top) + mix(top + 1) * (y - top);
  });
}

/** The base colour of a document's first material at places of a triangle's corners. */
async function lookOf(document: Document) {
  const [material] = document.getRoot().listMaterials();
  const info = material?.getBaseColorTextureInfo();
  const transform = info?.getExtension<Transform>(KHRTextureTransform.EXTENSION_NAME);
  const [x, y] = transform?.getOffset() ?? [0, 0];
  const [scaleX, scaleY] = transform?.getScale() ?? [1, 1];
  const [sin, cos] = [Math.sin(transform?.getRotation() ?? 0), Math.cos(transform?.getRotation() ?? 0)];
  const set = transform?.getTexCoord() ?? info?.getTexCoord() ?? 0;
  const picture = await decodePicture(material?.getBaseColorTexture()?.getImage() ?? new Uint8Array(), "texture");
  return {
    uvs: (primitive: Primitive) => corners(primitive, `TEXCOORD_${set}`),
    at: (u: number, v: number) =>
      colorAt(picture, cos * scaleX * u + sin * scaleY * v + x, -sin * scaleX * u + cos * scaleY * v + y),
  };
}

const POINTS = [
  [0.5, 0.3, 0.2],
  [0.1, 0.2, 0.7],
  [0.34, 0.33, 0.33],
  [0.15, 0.7, 0.15],
] as const;

/** The mean difference of the base colour, 0 to 255, between points of the same triangles before and after. */
export async function lookDifference(before: Uint8Array, after: Uint8Array): Promise<number> {
  const [old, now] = [await documentOf(before), await documentOf(after)];
  const [oldLook, look] = [await lookOf(old), await lookOf(now)];
  const [oldPrimitives, primitives] = [primitivesOf(old), primitivesOf(now)];
  let sum = 0;
  let count = 0;
  for (const [i, primitive] of oldPrimitives.entries()) {
    const from = oldLook.uvs(primitive);
    const to = look.uvs(primitives[i] as Primitive);
    for (let corner = 0; corner < from.length; corner += 3) {
      for (const weights of POINTS) {
        const place = (uvs: number[][], axis: number): number =>
          weights.reduce((total, weight, k) => total + weight * (uvs[corner + k]?.[axis] ?? 0), 0);
        const was = oldLook.at(place(from, 0), place(from, 1));
        const is = look.at(place(to, 0), place(to, 1));
        for (const [channel, value] of was.entries()) sum += Math.abs(value - (is[channel] as number));
        count += 3;
      }
    }
  }
  return sum / count;
}
