/** What lies in a USDZ package, and what three.js makes of it, in Node. */
import type { BufferGeometry, Mesh, MeshPhysicalMaterial, Object3D } from "three";
import { USDLoader } from "three/examples/jsm/loaders/USDLoader.js";
import { vi } from "vitest";

export interface StoredFile {
  readonly path: string;
  /** Of the file's first byte in the package. */
  readonly offset: number;
  readonly bytes: Uint8Array;
  /** 0: stored. */
  readonly method: number;
}

/** The files as their own headers list them, in order. */
export function storedFiles(usdz: Uint8Array): StoredFile[] {
  const view = new DataView(usdz.buffer, usdz.byteOffset, usdz.byteLength);
  const files: StoredFile[] = [];
  for (let at = 0; view.getUint32(at, true) === 0x04034b50; ) {
    const [size, name, extra] = [
      view.getUint32(at + 18, true),
      view.getUint16(at + 26, true),
      view.getUint16(at + 28, true),
    ];
    const offset = at + 30 + name + extra;
    files.push({
      path: new TextDecoder().decode(usdz.subarray(at + 30, at + 30 + name)),
      offset,
      bytes: usdz.subarray(offset, offset + size),
      method: view.getUint16(at + 8, true),
    });
    at = offset + size;
  }
  return files;
}

/** The layer that a viewer opens. */
export const layerOf = (usdz: Uint8Array): string => new TextDecoder().decode(storedFiles(usdz)[0]?.bytes);

export interface SeenMesh {
  readonly geometry: BufferGeometry;
  readonly material: MeshPhysicalMaterial;
}

/** The meshes that three.js finds; its pictures are not looked at. */
export function seenByThree(usdz: Uint8Array): SeenMesh[] {
  vi.stubGlobal("document", {
    createElementNS: () => ({ addEventListener: () => undefined, removeEventListener: () => undefined }),
  });
  const scene = new USDLoader().parse(Uint8Array.from(usdz).buffer);
  const seen: SeenMesh[] = [];
  scene.traverse((object: Object3D & { isMesh?: boolean }) => {
    if (object.isMesh) seen.push(object as Mesh<BufferGeometry, MeshPhysicalMaterial>);
  });
  return seen;
}
