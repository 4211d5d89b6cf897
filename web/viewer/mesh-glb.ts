/** A three.js mesh as the GLB that the engine reads: one primitive, one material, the mesh's own space as model space. */
import { BufferAttribute, type InterleavedBufferAttribute, Matrix3, type Mesh, type Texture } from "three";
import { TexelcastError } from "../core/texelcast-error.ts";
import { writeGlb } from "../engine/gltf-container.ts";

const FLOAT = 5126;
const UNSIGNED_INT = 5125;
const TYPES = { 2: "VEC2", 3: "VEC3" } as const;

/** Where a texture's rows are counted from below, as three.js does by default. */
const UPSIDE_DOWN = new Matrix3(1, 0, 0, 0, -1, 1, 0, 0, 1);

/**
 * From the texture coordinates of the texture's own UV set to places on its picture, counted from above: its transform, and that
 * three.js turns what it loads upside down, all but an ImageBitmap.
 */
export function placeOnPicture(texture: Texture): Matrix3 {
  if (texture.matrixAutoUpdate) texture.updateMatrix();
  const isBitmap = typeof ImageBitmap !== "undefined" && texture.image instanceof ImageBitmap;
  const place = texture.matrix.clone();
  return texture.flipY && !isBitmap ? place.premultiply(UPSIDE_DOWN) : place;
}

/**
 * The mesh's triangles as they rest (without bones and morphs), as far as they are drawn. Throws a TexelcastError, "bad-argument",
 * where the geometry has no positions or no texture coordinates.
 *
 * @param like a texture whose UV set and places on the picture are taken; null: the `uv` as they are
 */
export function meshGlb(mesh: Mesh, like: Texture | null = null): Uint8Array {
  const { geometry } = mesh;
  const name = mesh.name || "mesh";
  const position = attributeOf(mesh, "position", "Give it vertices.");
  const uv = attributeOf(
    mesh,
    like?.channel ? `uv${like.channel}` : "uv",
    "A texture can only lie on a mesh that is unwrapped.",
  );
  const normal = geometry.getAttribute("normal") && attributeOf(mesh, "normal", "");
  const index = geometry.index;
  const places = floatsOf(uv, 2);
  if (like) new BufferAttribute(places, 2).applyMatrix3(placeOnPicture(like));
  const views = [floatsOf(position, 3), places, ...(normal ? [floatsOf(normal, 3)] : [])];
  const { start, count } = geometry.drawRange;
  const all = Uint32Array.from({ length: index?.count ?? position.count }, (_, i) => index?.getX(i) ?? i);
  const indices = all.slice(start, start + count);
  const parts: readonly (Float32Array | Uint32Array)[] = [...views, indices];
  const offsets = parts.map((_, i) => parts.slice(0, i).reduce((sum, part) => sum + part.byteLength, 0));
  const binary = new Uint8Array(parts.reduce((sum, part) => sum + part.byteLength, 0));
  parts.forEach((part, i) => {
    binary.set(new Uint8Array(part.buffer, part.byteOffset, part.byteLength), offsets[i]);
  });
  const last = parts.length - 1;
  return writeGlb(
    {
      asset: { version: "2.0" },
      scene: 0,
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0, name }],
      materials: [{ name }],
      meshes: [
        {
          primitives: [
            {
              attributes: { POSITION: 0, TEXCOORD_0: 1, ...(normal && { NORMAL: 2 }) },
              indices: last,
              material: 0,
            },
          ],
        },
      ],
      buffers: [{ byteLength: binary.length }],
      bufferViews: parts.map((part, i) => ({ buffer: 0, byteOffset: offsets[i] ?? 0, byteLength: part.byteLength })),
      accessors: parts.map((part, i) =>
        i === last
          ? { bufferView: i, componentType: UNSIGNED_INT, count: part.length, type: "SCALAR" }
          : {
              bufferView: i,
              componentType: FLOAT,
              count: position.count,
              type: TYPES[i === 1 ? 2 : 3],
              ...(i === 0 && boundsOf(part)),
            },
      ),
    },
    binary,
  );
}

type Attribute = BufferAttribute | InterleavedBufferAttribute;

function attributeOf(mesh: Mesh, field: string, hint: string): Attribute {
  const attribute = mesh.geometry.getAttribute(field) as Attribute | undefined;
  const subject = mesh.name || "mesh";
  const corners = mesh.geometry.getAttribute("position")?.count ?? 0;
  if (attribute !== undefined && attribute.count > 0) {
    if (attribute.count >= corners) return attribute;
    throw new TexelcastError(
      "bad-argument",
      `“${field}” of “${subject}” is of ${attribute.count} of its ${corners} vertices.`,
      {
        subject,
        field,
        value: String(attribute.count),
        hint: "Give it a value for every vertex, as “position” has one.",
      },
    );
  }
  throw new TexelcastError("bad-argument", `The geometry of “${subject}” has no attribute “${field}”.`, {
    subject,
    field,
    hint,
  });
}

/** By the attribute's own readers, which undo interleaving and normalised integers. */
function floatsOf(attribute: Attribute, size: 2 | 3): Float32Array {
  const floats = new Float32Array(attribute.count * size);
  for (let i = 0; i < attribute.count; i++) {
    floats[i * size] = attribute.getX(i);
    floats[i * size + 1] = attribute.getY(i);
    if (size === 3) floats[i * size + 2] = attribute.getZ(i);
  }
  return floats;
}

function boundsOf(positions: Float32Array | Uint32Array): { min: number[]; max: number[] } {
  const min = [0, 1, 2].map(() => Number.POSITIVE_INFINITY);
  const max = min.map((value) => -value);
  positions.forEach((value, i) => {
    min[i % 3] = Math.min(min[i % 3] ?? value, value);
    max[i % 3] = Math.max(max[i % 3] ?? value, value);
  });
  return { min, max };
}
