/** Demo models to GLB. */

import {
  type Accessor,
  Document,
  type Material,
  type Primitive,
  type Texture,
  TextureInfo,
  WebIO,
} from "@gltf-transform/core";
import type { Geometry } from "../geometry/atlas.ts";

export interface MaterialLook {
  readonly name: string;
  /** Linear, straight alpha; multiplies the base colour picture. */
  readonly baseColor?: readonly [number, number, number, number];
  readonly roughness: number;
  readonly metallic: number;
  /** PNG bytes. */
  readonly basePicture?: Uint8Array<ArrayBuffer>;
  /** PNG bytes: roughness in green, metallic in blue. */
  readonly surfacePicture?: Uint8Array<ArrayBuffer>;
}

export function createDocument(): Document {
  const document = new Document();
  document.getRoot().getAsset().generator = "Texelcast demo";
  document.createBuffer("buffer");
  return document;
}

export function addMaterial(document: Document, look: MaterialLook): Material {
  const material = document
    .createMaterial(look.name)
    .setBaseColorFactor([...(look.baseColor ?? [1, 1, 1, 1])])
    .setRoughnessFactor(look.roughness)
    .setMetallicFactor(look.metallic);
  if (look.basePicture) {
    material.setBaseColorTexture(addPicture(document, `${look.name} base colour`, look.basePicture));
    useMipmaps(material.getBaseColorTextureInfo());
  }
  if (look.surfacePicture) {
    material.setMetallicRoughnessTexture(addPicture(document, `${look.name} surface`, look.surfacePicture));
    useMipmaps(material.getMetallicRoughnessTextureInfo());
  }
  return material;
}

function addPicture(document: Document, name: string, png: Uint8Array<ArrayBuffer>): Texture {
  return document.createTexture(name).setImage(png).setMimeType("image/png");
}

function useMipmaps(info: TextureInfo | null): void {
  info?.setMinFilter(TextureInfo.MinFilter.LINEAR_MIPMAP_LINEAR).setMagFilter(TextureInfo.MagFilter.LINEAR);
}

/** A triangle list; `withUvs` is false for parts that carry no picture. */
export function addPrimitive(document: Document, geometry: Geometry, material: Material, withUvs = true): Primitive {
  const primitive = document
    .createPrimitive()
    .setMaterial(material)
    .setIndices(addAccessor(document, "SCALAR", geometry.indices))
    .setAttribute("POSITION", addAccessor(document, "VEC3", geometry.positions))
    .setAttribute("NORMAL", addAccessor(document, "VEC3", geometry.normals));
  if (withUvs) primitive.setAttribute("TEXCOORD_0", addAccessor(document, "VEC2", geometry.uvs));
  return primitive;
}

export function addAccessor(
  document: Document,
  type: "SCALAR" | "VEC2" | "VEC3" | "VEC4" | "MAT4",
  array: Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint8Array<ArrayBuffer>,
): Accessor {
  const buffer = document.getRoot().listBuffers()[0] ?? null;
  return document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
}

export function writeGlb(document: Document): Promise<Uint8Array<ArrayBuffer>> {
  return new WebIO().writeBinary(document);
}
