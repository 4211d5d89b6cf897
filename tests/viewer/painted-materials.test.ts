import { Group, MeshStandardMaterial, Texture, type WebGLRenderer } from "three";
import { describe, expect, it } from "vitest";
import type { DirtyRect, TargetInfo, TargetUpdate } from "../../web/engine/engine-api.ts";
import { PaintedMaterials } from "../../web/viewer/painted-materials.ts";

/** What a texture asks of three's renderer, and the rectangles that reach the GPU: level and place. */
function recordingRenderer() {
  const uploaded: number[][] = [];
  const gl = {
    getParameter: () => "",
    pixelStorei() {},
    texSubImage2D: (_kind: number, ...place: number[]) => uploaded.push(place.slice(0, 5)),
  };
  const renderer = {
    getContext: () => gl,
    initTexture() {},
    properties: { get: () => ({ __webglTexture: {} }) },
    state: { bindTexture() {}, pixelStorei() {} },
  };
  return { renderer: renderer as unknown as WebGLRenderer, uploaded };
}

/** A model of one material, index 0, with this picture of its own. */
function painted(own: Texture | null) {
  const material = new MeshStandardMaterial({ map: own, color: 0xff0000 });
  const { renderer, uploaded } = recordingRenderer();
  const materials = new PaintedMaterials(renderer, {
    root: new Group(),
    animations: [],
    materials: new Map([[0, [material]]]),
    labels: new Map(),
    dispose() {},
  });
  const info = { material: 0, width: 8, height: 4, mipLevels: 2 } as TargetInfo;
  materials.bind(info);
  return { material, materials, uploaded };
}

function update(rects: readonly DirtyRect[]): TargetUpdate {
  return { material: 0, rects, bytes: new Uint8Array(256) } as unknown as TargetUpdate;
}

const FIRST: readonly DirtyRect[] = [
  { level: 0, x: 0, y: 0, width: 8, height: 4, byteOffset: 0 },
  { level: 1, x: 0, y: 0, width: 4, height: 2, byteOffset: 128 },
];

describe("the materials of a model that is painted", () => {
  it("show the model's own picture until the first update, whose picture takes its place on the GPU", () => {
    const own = new Texture();
    let freed = 0;
    own.addEventListener("dispose", () => {
      freed += 1;
    });
    const { material, materials } = painted(own);
    expect([material.map === own, freed]).toEqual([true, 0]);
    materials.apply(update(FIRST));
    expect([material.map === own, freed]).toEqual([false, 1]);
    // The model's own again, to be freed with it.
    materials.dispose();
    expect(material.map).toBe(own);
  });

  it("lose their colour to the first update where they have no picture: it lies in the texture", () => {
    const { material, materials } = painted(null);
    expect(material.color.getHex()).toBe(0xff0000);
    materials.apply(update(FIRST));
    expect(material.color.getHex()).toBe(0xffffff);
  });

  it("take the rectangles of the levels that they have, and leave the empty ones", () => {
    const { materials, uploaded } = painted(null);
    const { bytes } = materials.apply(
      update([
        ...FIRST,
        { level: 2, x: 0, y: 0, width: 2, height: 1, byteOffset: 160 },
        { level: 0, x: 3, y: 1, width: 0, height: 2, byteOffset: 168 },
      ]),
    );
    expect(uploaded).toEqual([
      [0, 0, 0, 8, 4],
      [1, 0, 0, 4, 2],
    ]);
    expect(bytes).toBe(8 * 4 * 4 + 4 * 2 * 4);
  });
});
