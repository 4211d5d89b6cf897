import { BoxGeometry, Group, Mesh, MeshStandardMaterial, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { beneath } from "../../web/viewer/decal-placement.ts";
import { poseOf } from "../../web/viewer/decal-pose.ts";
import { guideOf, partsOf } from "../../web/viewer/model-parts.ts";
import type { MeshLabel, ModelScene } from "../../web/viewer/model-scene.ts";
import { facedParts, fittingName } from "../../web/viewer/texture-guide.ts";
import { queryOf } from "./surface-helpers.ts";

const LABEL: MeshLabel = { node: "", material: "", several: false, extras: undefined };

function sceneWith(...labels: Partial<MeshLabel>[]): ModelScene {
  const root = new Group();
  const materials = new Map<number, MeshStandardMaterial[]>();
  const known = new Map<Mesh, MeshLabel>();
  for (const [index, label] of labels.entries()) {
    const mesh = new Mesh(new BoxGeometry(), new MeshStandardMaterial());
    mesh.name = `mesh_${index}`;
    root.add(mesh);
    materials.set(index, [mesh.material as MeshStandardMaterial]);
    known.set(mesh, { ...LABEL, ...label });
  }
  return { root, animations: [], materials, labels: known, dispose: () => {} };
}

describe("the parts of a model", () => {
  it("go by the names of their nodes, else of their meshes", () => {
    const parts = partsOf(sceneWith({ node: "Right arm" }, {}));
    expect(parts.map(({ id, name, triangles }) => [id, name, triangles])).toEqual([
      [0, "Right arm", 12],
      [1, "mesh_1", 12],
    ]);
  });

  it("of one node with several materials go by these, grouped by the node", () => {
    const common = { node: "Skateboard", several: true };
    const parts = partsOf(sceneWith({ ...common, material: "Deck" }, { ...common, material: "Wheels" }));
    expect(parts.map(({ name, group, material }) => [name, group, material])).toEqual([
      ["Deck", "Skateboard", 0],
      ["Wheels", "Skateboard", 1],
    ]);
  });

  it("are hidden at first and grouped where the file says so, and whatever else it says is passed over", () => {
    const extras = { texelcast: { group: "Overlay", hidden: true } };
    const [overlay, odd] = partsOf(
      sceneWith({ node: "Head overlay", extras }, { node: "Odd", extras: { texelcast: 7 } }),
    );
    expect(overlay).toMatchObject({ group: "Overlay", hidden: true });
    expect(odd).toMatchObject({ group: null, hidden: false });
  });
});

describe("the guide of a texture", () => {
  it("is what the material's file entry names, without what is malformed", () => {
    const scene = sceneWith({});
    const good = { part: "Head", face: "front", uv: [0, 0, 0.5, 0.5] };
    const guide = [good, { part: 3, uv: [0, 0, 1, 1] }, { part: "Short", uv: [0, 1] }, null];
    (scene.materials.get(0)?.[0] as MeshStandardMaterial).userData = { texelcast: { guide } };
    expect(guideOf(scene, 0)).toEqual([good]);
    expect(guideOf(scene, 4)).toEqual([]);
  });

  it("puts a name where there is room for it", () => {
    const entry = { part: "Head", face: "front", uv: [0, 0, 1, 1] } as const;
    expect(fittingName(entry, 80, 20)).toBe("front");
    expect(fittingName(entry, 30, 20)).toBe("");
    expect(fittingName(entry, 80, 8)).toBe("");
  });

  it("has one box around all faces of a part", () => {
    const faces = [
      { part: "Head", face: "right", uv: [0, 0.125, 0.125, 0.25] },
      { part: "Head", face: "top", uv: [0.125, 0, 0.25, 0.125] },
      { part: "Handle", uv: [0.5, 0.5, 1, 1] },
    ] as const;
    expect(facedParts(faces)).toEqual([{ name: "Head", uv: [0, 0, 0.25, 0.25] }]);
  });
});

describe("a decal under a hidden layer", () => {
  const box = { kind: "planar", position: [0, 0, 1], rotation: [0, 0, 0, 1], size: [0.5, 0.5, 0.4] } as const;
  const visible = queryOf(new BoxGeometry(2, 2, 2));
  /** Mirrored, so that it is seen from inside, as a hidden layer is. */
  const layerOf = (width: number) => queryOf(new BoxGeometry(width, width, width).scale(-1, 1, 1));

  it("ends before the layer", () => {
    const layer = layerOf(2.1);
    const pose = beneath(layer, visible, poseOf(box));
    const top = pose.position.z + pose.size.z / 2;
    expect(top).toBeGreaterThan(1);
    expect(top).toBeLessThan(1.05);
    expect(pose.position.z - pose.size.z / 2).toBeCloseTo(0.8, 6);
    expect(pose.position.distanceTo(new Vector3(0, 0, 1))).toBeLessThan(0.1);
  });

  it("stays as it is where the layer is farther away than it reaches", () => {
    const layer = layerOf(3);
    const pose = beneath(layer, visible, poseOf(box));
    expect(pose.size.z).toBeCloseTo(0.4, 9);
    expect(pose.position.z).toBeCloseTo(1, 9);
  });
});
